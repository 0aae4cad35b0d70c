#ifndef LATTICEWORLD_ROS_PUBLISHING_ROBOT_FRAMES_H_
#define LATTICEWORLD_ROS_PUBLISHING_ROBOT_FRAMES_H_

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace latticeworld {

// Which transforms of controllable robots are published. A frame has one parent and one publisher:
// what AMCL, SLAM or a filter publishes, the server leaves out.
struct RobotFrameOptions {
  bool map_to_odom = true;                       // map -> <robot>/odom of all robots
  bool odom_to_base = true;                      // <robot>/odom -> <robot>/base_link of all
  std::vector<std::string> localised_elsewhere;  // robots whose map -> odom others publish
  std::vector<std::string> odometry_elsewhere;   // robots whose odom -> base_link others publish
};

// Adds map -> <robot>/odom and <robot>/odom -> <robot>/base_link, those of them that are published.
void AppendRobotFrames(const RobotFrameOptions& options, const std::string& robot, ros::Time stamp,
                       const Eigen::Isometry3d& map_from_odom,
                       const Eigen::Isometry3d& odom_from_base,
                       std::vector<geometry_msgs::TransformStamped>* transforms);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_ROBOT_FRAMES_H_
