#include "latticeworld_ros/navigator/navigator_goal.h"

#include <tf2/exceptions.h>

#include <cmath>
#include <utility>
#include <vector>

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
                               const tf2_ros::Buffer& buffer, const std::string& global_frame,
                               const std::string& name) {
  std::vector<Violation> violations;
  const auto refuse = [&](const char* field, const std::string& message, std::string given) {
    violations.push_back({"illegal_value", name + field, message, std::move(given)});
  };
  const auto& p = goal.pose.position;
  const Eigen::Vector3d position_m(p.x, p.y, p.z);
  if (!position_m.allFinite()) {
    const std::string given = Numbers({p.x, p.y, p.z});
    refuse(".pose.position", "is " + given + "; legal are finite numbers [m]", given);
  }
  const auto& q = goal.pose.orientation;
  const std::string quaternion = Numbers({q.x, q.y, q.z, q.w});
  const auto refuse_orientation = [&](const char* flaw) {
    refuse(".pose.orientation",
           "(x, y, z, w) is " + quaternion + flaw +
               "; legal is (0, 0, sin(heading / 2), cos(heading / 2))",
           quaternion);
  };
  const Eigen::Quaterniond orientation(q.w, q.x, q.y, q.z);
  // The norm of a NaN is no number, and fails too.
  const bool turns = orientation.norm() > kLeastLength && std::isfinite(orientation.norm());
  if (!turns) refuse_orientation(", which is not of length 1");
  const std::string frame = WithoutSlash(goal.header.frame_id);
  Result<Eigen::Isometry3d> map_from_frame = Eigen::Isometry3d(Eigen::Isometry3d::Identity());
  if (!frame.empty() && frame != global_frame) {
    // The latest transform, as move_base takes it: a goal is a place, whatever its stamp.
    map_from_frame = LookUp(buffer, global_frame, frame, ros::Time());
  }
  const Status& of_tf = map_from_frame.status();
  if (frame.empty() || of_tf.code() == StatusCode::kInvalidArgument) {
    refuse(".header.frame_id",
           (frame.empty() ? "is no frame" : "is " + Quote(frame) + ": " + of_tf.message()) +
               "; legal is " + Quote(global_frame) + " and every frame that tf connects with it",
           Quote(frame));
  } else if (map_from_frame.ok() && turns &&
             (map_from_frame->linear() * orientation.normalized())(2, 2) < kLeastUpright) {
    refuse_orientation(", which does not stand upright");
  }
  if (!violations.empty()) return Status::FromViolations("illegal request", std::move(violations));
  LW_RETURN_IF_ERROR(of_tf.WithContext(name + ".header.frame_id"));
  const Eigen::Isometry3d in_map =
      *map_from_frame * ToIsometry(position_m, orientation.normalized());
  const Eigen::Vector3d x_axis = in_map.linear().col(0);
  return NavigatorGoal{{in_map.translation().x(), in_map.translation().y()},
                       std::atan2(x_axis.y(), x_axis.x())};
}

Result<PlanRequest> ReadPlanRequest(const nav_msgs::GetPlan::Request& request,
                                    const tf2_ros::Buffer& buffer,
                                    const std::string& global_frame) {
  const Result<NavigatorGoal> goal = ReadGoal(request.goal, buffer, global_frame, "goal");
  const bool from_here = request.start.header.frame_id.empty();
  const Result<NavigatorGoal> start =
      from_here ? NavigatorGoal() : ReadGoal(request.start, buffer, global_frame, "start");
  std::vector<Violation> violations;
  for (const Status& status : {start.status(), goal.status()}) {
    violations.insert(violations.end(), status.violations().begin(), status.violations().end());
  }
  if (!std::isfinite(request.tolerance) || request.tolerance < 0.0f) {
    const std::string given = FormatDouble(request.tolerance);
    violations.push_back(
        {"out_of_range", "tolerance", "is " + given + "; legal are 0 m and more", given});
  }
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal request", std::move(violations)));
  LW_RETURN_IF_ERROR(start.status());
  LW_RETURN_IF_ERROR(goal.status());
  PlanRequest read;
  if (!from_here) read.start = start->place;
  read.goal = goal->place;
  read.tolerance_m = request.tolerance;
  return read;
}

}  // namespace latticeworld
