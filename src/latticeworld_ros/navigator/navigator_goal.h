#ifndef LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_GOAL_H_
#define LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_GOAL_H_

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/GetPlan.h>
#include <tf2_ros/buffer.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// What tf says: the transform that takes coordinates of `source` to `target` at `time` (0: the
// latest); `of`, where there is one, is set to the time that it is of. Errors: INVALID_ARGUMENT
// (frames that tf does not know or connect), UNAVAILABLE (none of that time), each with tf's own
// words.
Result<Eigen::Isometry3d> LookUp(const tf2_ros::Buffer& buffer, const std::string& target,
                                 const std::string& source, ros::Time time,
                                 ros::Time* of = nullptr);

// A place to go to, in the global frame.
struct NavigatorGoal {
  WorldPoint place;
  double heading_rad = 0.0;
};

// name: of the field that the pose is of, "target_pose". Errors: INVALID_ARGUMENT with every
// violation: a position or an orientation that is no number, a quaternion of no length or one that
// does not stand upright, a frame that nothing connects with the global one. UNAVAILABLE: tf has no
// transform yet.
Result<NavigatorGoal> ReadGoal(const geometry_msgs::PoseStamped& goal,
                               const tf2_ros::Buffer& buffer, const std::string& global_frame,
                               const std::string& name);

// What make_plan asks for, in the global frame.
struct PlanRequest {
  std::optional<WorldPoint> start;  // none: where the robot is
  WorldPoint goal;
  double tolerance_m = 0.0;
};

// Errors: as ReadGoal, of start, goal and tolerance at once.
Result<PlanRequest> ReadPlanRequest(const nav_msgs::GetPlan::Request& request,
                                    const tf2_ros::Buffer& buffer, const std::string& global_frame);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_GOAL_H_
