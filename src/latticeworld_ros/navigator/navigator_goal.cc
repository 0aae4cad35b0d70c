#include "latticeworld_ros/navigator/navigator_goal.h"

#include <tf2/exceptions.h>

#include <cmath>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

// A goal may lean as a robot on a slope does, and so may the frame it is given in; a quaternion
// that leans more was meant otherwise.
constexpr double kLeastUpright = 0.5;  // of the goal's z axis along the vertical
constexpr double kLeastLength = 1e-6;  // of a quaternion

// tf2's searches want no slash before a name, which many programs still write.
std::string WithoutSlash(const std::string& frame) {
  return !frame.empty() && frame[0] == '/' ? frame.substr(1) : frame;
}

std::string Numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + FormatDouble(value);
  return "(" + text + ")";
}

}  // namespace

Result<Eigen::Isometry3d> LookUp(const tf2_ros::Buffer& buffer, const std::string& target,
                                 const std::string& source, ros::Time time, ros::Time* of) {
  try {
    const geometry_msgs::TransformStamped found =
        buffer.lookupTransform(WithoutSlash(target), WithoutSlash(source), time);
    if (of != nullptr) *of = found.header.stamp;
    const auto& q = found.transform.rotation;
    return ToIsometry(FromVector(found.transform.translation),
                      Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized());
  } catch (const tf2::ExtrapolationException& error) {
    return Unavailable(error.what());
  } catch (const tf2::TransformException& error) {
    return InvalidArgument(error.what());
  }
}

Result<NavigatorGoal> ReadGoal(const geometry_msgs::PoseStamped& goal,
                               const tf2_ros::Buffer& buffer, const std::string& global_frame) {
  const auto& p = goal.pose.position;
  const auto& q = goal.pose.orientation;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    return InvalidArgument("the goal's position is " + Numbers({p.x, p.y, p.z}) +
                           "; legal are finite numbers [m]");
  }
  const Eigen::Quaterniond orientation(q.w, q.x, q.y, q.z);
  // The norm of a NaN is no number, and fails too.
  if (!(orientation.norm() > kLeastLength) || !std::isfinite(orientation.norm())) {
    return InvalidArgument("the goal's orientation (x, y, z, w) is " +
                           Numbers({q.x, q.y, q.z, q.w}) +
                           "; legal is a quaternion of length 1: (0, 0, sin(heading / 2), "
                           "cos(heading / 2))");
  }
  const std::string frame = WithoutSlash(goal.header.frame_id);
  if (frame.empty()) {
    return InvalidArgument("the goal has no frame; legal is " + Quote(global_frame) +
                           " and every frame that tf connects with it");
  }
  Eigen::Isometry3d map_from_frame = Eigen::Isometry3d::Identity();
  if (frame != global_frame) {
    // The latest transform, as move_base takes it: a goal is a place, whatever its stamp.
    const auto found = LookUp(buffer, global_frame, frame, ros::Time());
    if (!found.ok()) {
      return found.status().WithContext("the goal is given in the frame " + Quote(frame) +
                                        "; legal is " + Quote(global_frame) +
                                        " and every frame that tf connects with it");
    }
    map_from_frame = *found;
  }
  const Eigen::Isometry3d in_map =
      map_from_frame * ToIsometry({p.x, p.y, p.z}, orientation.normalized());
  const Eigen::Vector3d x_axis = in_map.linear().col(0);
  if (in_map.linear()(2, 2) < kLeastUpright) {
    return InvalidArgument("the goal's orientation (x, y, z, w) is " +
                           Numbers({q.x, q.y, q.z, q.w}) +
                           ", which does not stand upright; legal is (0, 0, sin(heading / 2), "
                           "cos(heading / 2))");
  }
  return NavigatorGoal{{in_map.translation().x(), in_map.translation().y()},
                       std::atan2(x_axis.y(), x_axis.x())};
}

}  // namespace latticeworld
