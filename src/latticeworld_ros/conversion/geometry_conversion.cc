#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {

geometry_msgs::Point ToPoint(const Eigen::Vector3d& v) {
  geometry_msgs::Point point;
  point.x = v.x();
  point.y = v.y();
  point.z = v.z();
  return point;
}

geometry_msgs::Vector3 ToVector3(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 vector;
  vector.x = v.x();
  vector.y = v.y();
  vector.z = v.z();
  return vector;
}

geometry_msgs::Quaternion ToQuaternion(const Eigen::Quaterniond& q) {
  geometry_msgs::Quaternion quaternion;
  quaternion.x = q.x();
  quaternion.y = q.y();
  quaternion.z = q.z();
  quaternion.w = q.w();
  return quaternion;
}

Eigen::Vector3d FromVector(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d ToIsometry(const Eigen::Vector3d& position_m,
                             const Eigen::Quaterniond& orientation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = orientation.toRotationMatrix();
  pose.translation() = position_m;
  return pose;
}

geometry_msgs::Pose ToPose(const Eigen::Isometry3d& pose) {
  geometry_msgs::Pose message;
  message.position = ToPoint(pose.translation());
  message.orientation = ToQuaternion(Eigen::Quaterniond(pose.linear()).normalized());
  return message;
}

geometry_msgs::TransformStamped ToTransformStamped(const Eigen::Isometry3d& parent_from_child,
                                                   ros::Time stamp, const std::string& parent,
                                                   const std::string& child) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation = ToVector3(parent_from_child.translation());
  message.transform.rotation =
      ToQuaternion(Eigen::Quaterniond(parent_from_child.linear()).normalized());
  return message;
}

}  // namespace latticeworld
