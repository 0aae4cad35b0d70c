#include "latticeworld_ros/publishing/robot_frames.h"

#include <algorithm>

#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void AppendRobotFrames(const RobotFrameOptions& options, const std::string& robot, ros::Time stamp,
                       const Eigen::Isometry3d& map_from_odom,
                       const Eigen::Isometry3d& odom_from_base,
                       std::vector<geometry_msgs::TransformStamped>* transforms) {
  const std::string odom = OdomFrame(robot);
  if (options.map_to_odom && !Contains(options.localised_elsewhere, robot)) {
    transforms->push_back(ToTransformStamped(map_from_odom, stamp, kMapFrame, odom));
  }
  if (options.odom_to_base && !Contains(options.odometry_elsewhere, robot)) {
    transforms->push_back(ToTransformStamped(odom_from_base, stamp, odom, BaseFrame(robot)));
  }
}

}  // namespace latticeworld
