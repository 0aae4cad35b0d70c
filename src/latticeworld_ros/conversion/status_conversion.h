#ifndef LATTICEWORLD_ROS_CONVERSION_STATUS_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_STATUS_CONVERSION_H_

#include "latticeworld/common/status.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

latticeworld_msgs::Status ToStatusMessage(const Status& status);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_STATUS_CONVERSION_H_
