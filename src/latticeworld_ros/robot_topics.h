#ifndef LATTICEWORLD_ROS_ROBOT_TOPICS_H_
#define LATTICEWORLD_ROS_ROBOT_TOPICS_H_

#include <ros/ros.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

// What one controllable robot publishes.
struct RobotPublishers {
  ros::Publisher odom;
  ros::Publisher ground_truth;
};
using RobotPublisherMap = std::map<std::string, RobotPublishers>;

// <robot>/odom, <robot>/ground_truth and <robot>/cmd_vel of every controllable robot that there is.
// Talking to the master takes milliseconds a topic, which the simulation must not wait for: a
// thread of its own makes and ends them.
class RobotTopics {
 public:
  using CommandSink = std::function<void(const std::string& robot, const VelocityCommand&)>;

  // node: its callback queue calls the sink.
  RobotTopics(ros::NodeHandle node, CommandSink sink);
  ~RobotTopics();
  RobotTopics(const RobotTopics&) = delete;
  RobotTopics& operator=(const RobotTopics&) = delete;

  // The robots that there are now, sorted. Does not block.
  void Want(std::vector<std::string> names);
  // Blocks until the topics are those of the last Want.
  void WaitUntilReady();
  std::shared_ptr<const RobotPublisherMap> publishers() const;

 private:
  void Run();
  // Makes and ends topics until they are those of `names`.
  void Apply(const std::vector<std::string>& names);

  ros::NodeHandle node_;
  const CommandSink sink_;
  std::map<std::string, ros::Subscriber> subscribers_;  // of the thread alone

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> wanted_;
  std::uint64_t wanted_version_ = 0;
  std::uint64_t applied_version_ = 0;
  bool stopping_ = false;
  std::shared_ptr<const RobotPublisherMap> publishers_ = std::make_shared<RobotPublisherMap>();
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_ROBOT_TOPICS_H_
