#ifndef LATTICEWORLD_ROS_CONVERSION_LOCKSTEP_MESSAGES_H_
#define LATTICEWORLD_ROS_CONVERSION_LOCKSTEP_MESSAGES_H_

// The messages of the service lockstep, in the namespace latticeworld_msgs as
// those of messages.h, which comes first: what it has is not read again.

#include "latticeworld_ros/conversion/messages.h"

#define latticeworld latticeworld_msgs
#include <latticeworld/AgentCommand.h>
#include <latticeworld/Lockstep.h>
#include <latticeworld/Observation.h>
#undef latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_LOCKSTEP_MESSAGES_H_
