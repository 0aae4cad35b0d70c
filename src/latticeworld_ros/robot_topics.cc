#include "latticeworld_ros/robot_topics.h"

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>

#include <algorithm>
#include <boost/function.hpp>
#include <utility>

#include "latticeworld_ros/agent_conversion.h"

namespace latticeworld {

RobotTopics::RobotTopics(ros::NodeHandle node, CommandSink sink)
    : node_(std::move(node)), sink_(std::move(sink)), thread_([this] { Run(); }) {}

RobotTopics::~RobotTopics() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void RobotTopics::Want(std::vector<std::string> names) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wanted_ = std::move(names);
    ++wanted_version_;
  }
  changed_.notify_all();
}

void RobotTopics::WaitUntilReady() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return stopping_ || applied_version_ == wanted_version_; });
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
    const std::vector<std::string> names = wanted_;
    const std::uint64_t version = wanted_version_;
    lock.unlock();
    Apply(names);
    lock.lock();
    applied_version_ = version;
    changed_.notify_all();
  }
}

void RobotTopics::Apply(const std::vector<std::string>& names) {
  auto publishers = std::make_shared<RobotPublisherMap>();
  const std::shared_ptr<const RobotPublisherMap> before = this->publishers();
  for (const std::string& name : names) {
    const auto kept = before->find(name);
    if (kept != before->end()) {
      publishers->insert(*kept);
      continue;
    }
    (*publishers)[name] = {node_.advertise<nav_msgs::Odometry>(name + "/odom", 10),
                           node_.advertise<nav_msgs::Odometry>(name + "/ground_truth", 10)};
    const boost::function<void(const geometry_msgs::Twist::ConstPtr&)> on_command =
        [this, name](const geometry_msgs::Twist::ConstPtr& twist) { sink_(name, FromRos(*twist)); };
    subscribers_[name] = node_.subscribe<geometry_msgs::Twist>(name + "/cmd_vel", 1, on_command);
  }
  for (auto entry = subscribers_.begin(); entry != subscribers_.end();) {
    entry = publishers->count(entry->first) != 0 ? std::next(entry) : subscribers_.erase(entry);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  publishers_ = std::move(publishers);
}

}  // namespace latticeworld
