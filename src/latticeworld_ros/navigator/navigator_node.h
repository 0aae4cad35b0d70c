#ifndef LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_NODE_H_
#define LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_NODE_H_

#include <actionlib/server/simple_action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Empty.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/reference_navigator/navigator.h"
#include "latticeworld_ros/navigator/navigator_goal.h"
#include "latticeworld_ros/navigator/navigator_node_options.h"

namespace latticeworld {

// The reference navigator behind the names of move_base, for one robot: docs/navigation.md.
//
// Everything but tf's listener runs on the thread that calls the global callback queue. Control is
// driven by the stamps of the odometry and by nothing else: it keeps its rate in simulated time
// however fast the simulation runs, and waits with it while it is paused.
class NavigatorNode {
 public:
  // Topics of the robot lie below its name in the namespace of `node`. Errors: those of
  // Navigator::Create.
  static Result<std::unique_ptr<NavigatorNode>> Create(ros::NodeHandle node,
                                                       const NavigatorNodeOptions& options);
  // Ends the goal under way, and the robot's motion with it.
  ~NavigatorNode();
  NavigatorNode(const NavigatorNode&) = delete;
  NavigatorNode& operator=(const NavigatorNode&) = delete;

 private:
  using Server = actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>;
  using Way = std::shared_ptr<const std::vector<WorldPoint>>;

  NavigatorNode(ros::NodeHandle node, const NavigatorNodeOptions& options,
                std::unique_ptr<Navigator> navigator);

  void OnMap(const nav_msgs::OccupancyGrid& map);
  void OnOdometry(const nav_msgs::Odometry::ConstPtr& odometry);
  void OnGoal();
  void OnPreempt();
  void OnWatch();
  bool MakePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);

  // Takes the goal of the action, or says why not. It waits where tf does not say yet where the
  // robot is.
  Status TakeGoal(const geometry_msgs::PoseStamped& target);
  // Sends the robot on its way from there to the goal that was taken.
  Status BeginGoal(const NavigatorPose& pose);
  // Whether there are a map and odometry: FAILED_PRECONDITION naming what lacks.
  Status Ready() const;
  // Returns where the robot is by tf, at the last odometry's stamp. Errors: what tf says.
  Result<NavigatorPose> Pose() const;

  void Control();
  // Shows the newest reading of a sensor whose place is known to the navigator.
  template <typename Message>
  void See(std::deque<boost::shared_ptr<const Message>>* readings);
  void Drive(double speed_mps, double yaw_rate_radps);
  // The goal under way ends ABORTED for that reason, and the robot stands.
  void Abort(const Status& why);
  void Stop();
  void PublishWay(const Way& way);
  std_msgs::Header HeaderOfNow() const;  // in the global frame

  const NavigatorNodeOptions options_;
  const std::unique_ptr<Navigator> navigator_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;

  bool has_map_ = false;
  std::string map_problem_;  // of the last map that could not be used
  nav_msgs::Odometry::ConstPtr odometry_;
  ros::Time next_control_;
  ros::Time last_pose_at_;  // when tf last said where the robot is, or the goal was taken
  std::optional<NavigatorGoal> waiting_goal_;  // taken, while tf does not say where the robot is
  std::deque<sensor_msgs::LaserScan::ConstPtr> scans_;
  std::deque<sensor_msgs::PointCloud2::ConstPtr> clouds_;
  Way published_way_;
  double height_m_ = 0.0;  // of the robot, where paths are drawn

  ros::NodeHandle node_;  // of the robot
  ros::Publisher cmd_vel_, current_goal_, plan_, action_goal_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Timer watch_;
  Server server_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_NAVIGATOR_NAVIGATOR_NODE_H_
