#include "latticeworld_ros/publishing/robot_topics.h"

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/console.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Empty.h>

#include <boost/function.hpp>
#include <cstdint>
#include <utility>

#include "latticeworld_ros/conversion/agent_conversion.h"

namespace latticeworld {
namespace {

// The queue is as deep as that of tf: two seconds in real time, so that bursts of a simulation that
// runs faster reach who keeps up, and who does not keep up is not told of a past long gone.
constexpr std::uint32_t kStateQueue = 100;

}  // namespace

RobotTopics::RobotTopics(ros::NodeHandle node, CommandSinks sinks,
                         std::function<void(const std::vector<RobotWish>&)> others)
    : node_(std::move(node)),
      sinks_(std::move(sinks)),
      others_(std::move(others)),
      thread_([this] { Run(); }) {}

RobotTopics::~RobotTopics() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void RobotTopics::Want(std::vector<RobotWish> wishes) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wanted_ = std::move(wishes);
    ++wanted_version_;
  }
  changed_.notify_all();
}

void RobotTopics::WaitUntilReady() {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::uint64_t wanted = wanted_version_;
  changed_.wait(lock, [&] { return stopping_ || applied_version_ >= wanted; });
}

std::shared_ptr<const RobotPublisherMap> RobotTopics::publishers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return publishers_;
}

void RobotTopics::Run() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || applied_version_ != wanted_version_; });
    if (stopping_) return;
    const std::vector<RobotWish> wishes = wanted_;
    const std::uint64_t version = wanted_version_;
    lock.unlock();
    Apply(wishes);
    others_(wishes);
    lock.lock();
    applied_version_ = version;
    changed_.notify_all();
  }
}

void RobotTopics::Apply(const std::vector<RobotWish>& wishes) {
  auto publishers = std::make_shared<RobotPublisherMap>();
  const std::shared_ptr<const RobotPublisherMap> before = this->publishers();
  std::map<std::string, std::vector<ros::Subscriber>> subscribers;
  for (const RobotWish& wish : wishes) {
    const std::string& name = wish.name;
    const auto listening = subscribers_.find(name);
    subscribers[name] =
        listening != subscribers_.end() ? std::move(listening->second) : Subscribe(name);
    RobotPublishers& robot = (*publishers)[name];
    const auto kept = before->find(name);
    if (kept != before->end()) {
      robot = kept->second;
    } else {
      robot.ground_truth =
          HeardPublisher(node_.advertise<nav_msgs::Odometry>(name + "/ground_truth", kStateQueue));
      robot.joint_states = HeardPublisher(
          node_.advertise<sensor_msgs::JointState>(name + "/joint_states", kStateQueue));
    }
    // The name may have gone to an agent of the other kind.
    if (!wish.controllable) {
      robot.odom = HeardPublisher();
    } else if (!robot.odom) {
      robot.odom = HeardPublisher(node_.advertise<nav_msgs::Odometry>(name + "/odom", kStateQueue));
    }
  }
  subscribers_ = std::move(subscribers);
  const std::lock_guard<std::mutex> lock(mutex_);
  publishers_ = std::move(publishers);
}

std::vector<ros::Subscriber> RobotTopics::Subscribe(const std::string& name) {
  const boost::function<void(const geometry_msgs::Twist::ConstPtr&)> on_velocity =
      [this, name](const geometry_msgs::Twist::ConstPtr& twist) {
        sinks_.velocity(name, ToVelocityCommand(*twist));
      };
  const boost::function<void(const sensor_msgs::JointState::ConstPtr&)> on_joints =
      [this, name](const sensor_msgs::JointState::ConstPtr& message) {
        Result<std::vector<JointCommand>> commands = ToJointCommands(*message);
        if (commands.ok()) {
          sinks_.joints(name, std::move(commands).value());
        } else {
          ROS_WARN_STREAM_THROTTLE(
              1.0, "joint_command of " << name << ": " << commands.status().ToString());
        }
      };
  const boost::function<void(const std_msgs::Empty::ConstPtr&)> on_strike =
      [this, name](const std_msgs::Empty::ConstPtr&) { sinks_.strike(name); };
  return {node_.subscribe<geometry_msgs::Twist>(name + "/cmd_vel", 1, on_velocity),
          node_.subscribe<sensor_msgs::JointState>(name + "/joint_command", 1, on_joints),
          node_.subscribe<std_msgs::Empty>(name + "/strike", 1, on_strike)};
}

}  // namespace latticeworld
