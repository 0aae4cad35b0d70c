#include "latticeworld_ros/navigator/navigator_node.h"

#include <geometry_msgs/Twist.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/navigator/navigator_input.h"
#include "latticeworld_ros/navigator/navigator_output.h"

namespace latticeworld {
namespace {

constexpr double kTfCache_s = 30.0;
constexpr double kWatch_s = 0.5;      // of simulated time between looks at the odometry
constexpr double kMostLate_s = 0.3;   // a reading waits no longer for the tf of its moment
constexpr std::size_t kWaiting = 4;   // readings of a sensor
constexpr double kWarnEvery_s = 5.0;  // of one kind

}  // namespace

Result<std::unique_ptr<NavigatorNode>> NavigatorNode::Create(ros::NodeHandle node,
                                                             const NavigatorNodeOptions& options) {
  LW_ASSIGN_OR_RETURN(std::unique_ptr<Navigator> navigator, Navigator::Create(options.navigator));
  return std::unique_ptr<NavigatorNode>(
      new NavigatorNode(std::move(node), options, std::move(navigator)));
}

NavigatorNode::NavigatorNode(ros::NodeHandle node, const NavigatorNodeOptions& options,
                             std::unique_ptr<Navigator> navigator)
    : options_(options),
      navigator_(std::move(navigator)),
      tf_(ros::Duration(kTfCache_s)),
      tf_listener_(tf_, node, /*spin_thread=*/true, ros::TransportHints().tcpNoDelay()),
      node_(node, options.robot),
      server_(node_, "move_base", /*auto_start=*/false) {
  cmd_vel_ = node_.advertise<geometry_msgs::Twist>("cmd_vel", 1);
  current_goal_ = node_.advertise<geometry_msgs::PoseStamped>("move_base/current_goal", 1, true);
  plan_ = node_.advertise<nav_msgs::Path>("move_base/NavfnROS/plan", 1, true);
  action_goal_ = node_.advertise<move_base_msgs::MoveBaseActionGoal>("move_base/goal", 1);

  // Small messages at once: TCP may hold them back for what are seconds of a fast simulation.
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  subscribers_.push_back(node.subscribe<nav_msgs::OccupancyGrid>(
      "map", 1, [this](const nav_msgs::OccupancyGrid::ConstPtr& map) { OnMap(*map); }));
  subscribers_.push_back(node_.subscribe<nav_msgs::Odometry>(
      "odom", 1, [this](const nav_msgs::Odometry::ConstPtr& odometry) { OnOdometry(odometry); },
      ros::VoidConstPtr(), hints));
  const auto listen = [&](auto* readings, const std::string& topic) {
    using Pointer = typename std::decay_t<decltype(*readings)>::value_type;
    using Message = std::remove_const_t<typename Pointer::element_type>;
    const boost::function<void(const Pointer&)> keep = [readings](const Pointer& reading) {
      readings->push_back(reading);
      if (readings->size() > kWaiting) readings->pop_front();
    };
    subscribers_.push_back(
        node_.subscribe<Message>(topic, kWaiting, keep, ros::VoidConstPtr(), hints));
  };
  const NavigatorSensor sensor = options_.sensor;
  const bool both = sensor == NavigatorSensor::kBoth;
  if (both || sensor == NavigatorSensor::kScan) listen(&scans_, "scan");
  if (both || sensor == NavigatorSensor::kPoints) listen(&clouds_, "points");
  // As with move_base, what comes by this topic goes the way of every other goal.
  subscribers_.push_back(node_.subscribe<geometry_msgs::PoseStamped>(
      "move_base_simple/goal", 1, [this](const geometry_msgs::PoseStamped::ConstPtr& pose) {
        move_base_msgs::MoveBaseActionGoal goal;
        goal.header.stamp = ros::Time::now();
        goal.goal.target_pose = *pose;
        action_goal_.publish(goal);
      }));

  services_.push_back(
      node_.advertiseService("move_base/make_plan", &NavigatorNode::MakePlan, this));
  services_.push_back(node_.advertiseService<std_srvs::Empty::Request, std_srvs::Empty::Response>(
      "move_base/clear_costmaps", [this](std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
        navigator_->Forget();
        return true;
      }));
  watch_ =
      node_.createTimer(ros::Duration(kWatch_s), [this](const ros::TimerEvent&) { OnWatch(); });
  server_.registerGoalCallback([this] { OnGoal(); });
  server_.registerPreemptCallback([this] { OnPreempt(); });
  server_.start();
}

NavigatorNode::~NavigatorNode() {
  if (server_.isActive()) Abort(Cancelled("the navigator ends"));
}

void NavigatorNode::OnMap(const nav_msgs::OccupancyGrid& map) {
  Result<CostMap> read = ToCostMap(map);
  Status status = read.status();
  if (status.ok() && map.header.frame_id != options_.global_frame) {
    status = InvalidArgument("the map is in the frame " + Quote(map.header.frame_id) +
                             "; legal is global_frame, " + Quote(options_.global_frame));
  }
  if (!status.ok()) {
    map_problem_ = status.message();
    ROS_ERROR_STREAM("map: " << status.ToString());
    return;
  }
  navigator_->SetMap(*std::move(read));
  has_map_ = true;
}

void NavigatorNode::OnOdometry(const nav_msgs::Odometry::ConstPtr& odometry) {
  const ros::Time stamp = odometry->header.stamp;
  const ros::Duration period(1.0 / options_.control_rate_hz);
  // Time that ran backward is that of another simulation or bag.
  if (odometry_ != nullptr && stamp < odometry_->header.stamp) {
    next_control_ = stamp;
    last_pose_at_ = stamp;
    scans_.clear();
    clouds_.clear();
  }
  odometry_ = odometry;
  if (stamp < next_control_) return;
  next_control_ += period;
  if (next_control_ <= stamp) next_control_ = stamp + period;
  Control();
}

void NavigatorNode::OnGoal() {
  const auto goal = server_.acceptNewGoal();  // what went before it is PREEMPTED
  if (server_.isPreemptRequested()) return OnPreempt();
  const Status status = TakeGoal(goal->target_pose);
  if (!status.ok()) Abort(status);
}

void NavigatorNode::OnPreempt() {
  Stop();
  if (server_.isActive()) server_.setPreempted({}, "the goal was cancelled");
}

Status NavigatorNode::Ready() const {
  if (!has_map_) {
    return FailedPrecondition(
        "there is no map yet on " + subscribers_[0].getTopic() +
        (map_problem_.empty() ? "; a world or a map server publishes one" : ": " + map_problem_));
  }
  if (odometry_ == nullptr) {
    return FailedPrecondition("there is no odometry yet on " + subscribers_[1].getTopic() +
                              "; a controllable agent of that name publishes it");
  }
  return Status();
}

Result<NavigatorPose> NavigatorNode::Pose() const {
  const std::string& base =
      options_.base_frame.empty() ? odometry_->child_frame_id : options_.base_frame;
  const ros::Time stamp = odometry_->header.stamp;
  ros::Time of;
  auto found = LookUp(tf_, options_.global_frame, base, stamp, &of);
  // tf comes on a topic of its own, before or after the odometry of a step.
  if (!found.ok()) found = LookUp(tf_, options_.global_frame, base, ros::Time(), &of);
  if (found.ok() && std::abs((of - stamp).toSec()) > options_.odom_timeout_s) {
    found = Unavailable("the last one is of " + FormatDouble(of.toSec()) + " s, the odometry of " +
                        FormatDouble(stamp.toSec()) + " s");
  }
  if (!found.ok()) {
    return FailedPrecondition("tf does not say where " + Quote(base) + " is in " +
                              Quote(options_.global_frame) + ": " + found.status().message());
  }
  NavigatorPose pose;
  pose.time_s = of.toSec();
  pose.map_from_base = *found;
  pose.speed_mps = odometry_->twist.twist.linear.x;
  pose.yaw_rate_radps = odometry_->twist.twist.angular.z;
  if (!pose.map_from_base.matrix().allFinite() || !std::isfinite(pose.speed_mps) ||
      !std::isfinite(pose.yaw_rate_radps)) {
    return FailedPrecondition("odometry or tf of " + Quote(base) + " are no finite numbers");
  }
  return pose;
}

Status NavigatorNode::TakeGoal(const geometry_msgs::PoseStamped& target) {
  LW_ASSIGN_OR_RETURN(const NavigatorGoal goal,
                      ReadGoal(target, tf_, options_.global_frame, "target_pose"));
  LW_RETURN_IF_ERROR(Ready());
  waiting_goal_ = goal;
  last_pose_at_ = odometry_->header.stamp;
  // Odometry may come before the first tf: the goal waits for that as long as one under way would.
  const Result<NavigatorPose> pose = Pose();
  return pose.ok() ? BeginGoal(*pose) : Status();
}

Status NavigatorNode::BeginGoal(const NavigatorPose& pose) {
  const NavigatorGoal goal = *std::exchange(waiting_goal_, std::nullopt);
  LW_RETURN_IF_ERROR(navigator_->SetGoal(goal.place, goal.heading_rad, pose));
  geometry_msgs::PoseStamped message;
  message.header = HeaderOfNow();
  message.pose = UprightPose(goal.place, pose.map_from_base.translation().z(), goal.heading_rad);
  current_goal_.publish(message);
  return Status();
}

void NavigatorNode::OnWatch() {
  if (!server_.isActive() || odometry_ == nullptr) return;
  const double age_s = (ros::Time::now() - odometry_->header.stamp).toSec();
  if (age_s <= options_.odom_timeout_s) return;
  Abort(Unavailable("no odometry came on " + subscribers_[1].getTopic() + " for " +
                    FormatDouble(age_s) + " s; is the robot still there?"));
}

template <typename Message>
void NavigatorNode::See(std::deque<boost::shared_ptr<const Message>>* readings) {
  // The newest of several since the last control tells most; older ones are let go.
  for (std::size_t i = readings->size(); i-- > 0;) {
    const Message& reading = *(*readings)[i];
    std::string unknown;
    const auto pose_at = [&](ros::Time time) -> std::optional<Eigen::Isometry3d> {
      const auto found = LookUp(tf_, options_.global_frame, reading.header.frame_id, time);
      if (found.ok()) return *found;
      unknown = found.status().message();
      return std::nullopt;
    };
    const Result<SensorSighting> sighting = ToSighting(reading, options_.sensor_range_m, pose_at);
    if (sighting.ok()) {
      navigator_->See(*sighting);
      readings->erase(readings->begin(), readings->begin() + static_cast<std::ptrdiff_t>(i) + 1);
      return;
    }
    const double late_s = (odometry_->header.stamp - reading.header.stamp).toSec();
    if (sighting.status().code() == StatusCode::kUnavailable && std::abs(late_s) < kMostLate_s)
      continue;  // tf may still come to know
    ROS_WARN_STREAM_THROTTLE(kWarnEvery_s, "a reading in the frame "
                                               << Quote(reading.header.frame_id) << " is left out: "
                                               << sighting.status().ToString() << " " << unknown);
    readings->erase(readings->begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void NavigatorNode::Control() {
  See(&scans_);
  See(&clouds_);
  if (!server_.isActive()) return;
  const ros::Time stamp = odometry_->header.stamp;
  const Result<NavigatorPose> pose = Pose();
  if (!pose.ok()) {
    if ((stamp - last_pose_at_).toSec() > options_.odom_timeout_s) return Abort(pose.status());
    return Drive(0.0, 0.0);
  }
  last_pose_at_ = stamp;
  height_m_ = pose->map_from_base.translation().z();
  if (waiting_goal_) {
    const Status begun = BeginGoal(*pose);
    if (!begun.ok()) return Abort(begun);
  }
  const NavigatorOutput output = navigator_->Update(*pose);
  if (output.way != published_way_) PublishWay(output.way);
  switch (output.state) {
    case NavigatorState::kArrived:
      Stop();
      server_.setSucceeded({}, "Goal reached.");
      return;
    case NavigatorState::kFailed:
      return Abort(output.why);
    case NavigatorState::kIdle:
      return Abort(Internal("the navigator has lost its goal"));
    case NavigatorState::kFollowing:
    case NavigatorState::kRecovering:
      break;
  }
  Drive(output.speed_mps, output.yaw_rate_radps);
  // Feedback comes after the command, so that who steps a world may wait for it.
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position.header = HeaderOfNow();
  feedback.base_position.pose = ToPose(pose->map_from_base);
  server_.publishFeedback(feedback);
}

bool NavigatorNode::MakePlan(nav_msgs::GetPlan::Request& request,
                             nav_msgs::GetPlan::Response& response) {
  // roscpp answers an exception's text to the caller; without one it could say nothing.
  const auto plan = [&]() -> Result<std::vector<WorldPoint>> {
    LW_ASSIGN_OR_RETURN(PlanRequest wanted, ReadPlanRequest(request, tf_, options_.global_frame));
    LW_RETURN_IF_ERROR(Ready());
    if (!wanted.start) {
      LW_ASSIGN_OR_RETURN(const NavigatorPose pose, Pose());
      wanted.start = {pose.map_from_base.translation().x(), pose.map_from_base.translation().y()};
    }
    return navigator_->Plan(*wanted.start, wanted.goal, wanted.tolerance_m);
  }();
  if (!plan.ok() && plan.status().code() != StatusCode::kNotFound)
    throw std::runtime_error(plan.status().ToString());
  response.plan = ToPath(plan.ok() ? *plan : std::vector<WorldPoint>(), height_m_, HeaderOfNow());
  return true;
}

void NavigatorNode::Drive(double speed_mps, double yaw_rate_radps) {
  geometry_msgs::Twist twist;
  twist.linear.x = speed_mps;
  twist.angular.z = yaw_rate_radps;
  cmd_vel_.publish(twist);
}

void NavigatorNode::Abort(const Status& why) {
  Stop();
  ROS_WARN_STREAM("goal of " << options_.robot << " aborted: " << why.ToString());
  if (server_.isActive()) server_.setAborted({}, why.ToString());
}

void NavigatorNode::Stop() {
  waiting_goal_.reset();
  navigator_->Cancel();
  Drive(0.0, 0.0);
}

void NavigatorNode::PublishWay(const Way& way) {
  published_way_ = way;
  if (way != nullptr) plan_.publish(ToPath(*way, height_m_, HeaderOfNow()));
}

std_msgs::Header NavigatorNode::HeaderOfNow() const {
  std_msgs::Header header;
  header.frame_id = options_.global_frame;
  if (odometry_ != nullptr) header.stamp = odometry_->header.stamp;
  return header;
}

}  // namespace latticeworld
