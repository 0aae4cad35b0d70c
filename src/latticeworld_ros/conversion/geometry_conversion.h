#ifndef LATTICEWORLD_ROS_CONVERSION_GEOMETRY_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_GEOMETRY_CONVERSION_H_

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Vector3.h>
#include <ros/time.h>

#include <Eigen/Geometry>
#include <string>

namespace latticeworld {

inline constexpr char kMapFrame[] = "map";

geometry_msgs::Point ToPoint(const Eigen::Vector3d& v);
geometry_msgs::Vector3 ToVector3(const Eigen::Vector3d& v);
geometry_msgs::Quaternion ToQuaternion(const Eigen::Quaterniond& q);
Eigen::Vector3d FromVector(const geometry_msgs::Vector3& v);

Eigen::Isometry3d ToIsometry(const Eigen::Vector3d& position_m,
                             const Eigen::Quaterniond& orientation);
geometry_msgs::Pose ToPose(const Eigen::Isometry3d& pose);
geometry_msgs::TransformStamped ToTransformStamped(const Eigen::Isometry3d& parent_from_child,
                                                   ros::Time stamp, const std::string& parent,
                                                   const std::string& child);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_GEOMETRY_CONVERSION_H_
