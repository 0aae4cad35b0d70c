#ifndef LATTICEWORLD_CAMPAIGN_STACKS_REFERENCE_STACK_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_REFERENCE_STACK_H_

#include <memory>

#include "latticeworld/campaign/stacks/robot_stack.h"

namespace latticeworld {

// The Navigator in process. It is given what its ROS node is given: the occupancy map of the
// robot's limits, sweeps, the pose and the wheels' speeds.
std::unique_ptr<RobotStack> MakeReferenceStack();

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_REFERENCE_STACK_H_
