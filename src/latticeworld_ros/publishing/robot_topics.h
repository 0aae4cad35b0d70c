#ifndef LATTICEWORLD_ROS_PUBLISHING_ROBOT_TOPICS_H_
#define LATTICEWORLD_ROS_PUBLISHING_ROBOT_TOPICS_H_

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
#include "latticeworld_ros/publishing/heard_publisher.h"

namespace latticeworld {

// An agent that has topics of its own.
struct RobotWish {
  std::string name;
  bool controllable = false;  // false: decided for from outside (policy "external")
  std::string species;

  friend bool operator==(const RobotWish& a, const RobotWish& b) {
    return a.name == b.name && a.controllable == b.controllable && a.species == b.species;
  }
  friend bool operator!=(const RobotWish& a, const RobotWish& b) { return !(a == b); }
};

// What an agent that obeys commands publishes.
struct RobotPublishers {
  HeardPublisher odom;  // none where it is not controllable
  HeardPublisher ground_truth;
  HeardPublisher joint_states;
};
using RobotPublisherMap = std::map<std::string, RobotPublishers>;

// What commands are given to. Called from the callback queue's thread.
struct CommandSinks {
  std::function<void(const std::string& agent, const VelocityCommand&)> velocity;
  std::function<void(const std::string& agent, std::vector<JointCommand>)> joints;
  std::function<void(const std::string& agent)> strike;
};

// <agent>/cmd_vel, joint_command, strike, ground_truth and joint_states of every agent that obeys
// commands, and odom of the controllable ones: odometry is an instrument that robots have. Talking
// to the master takes milliseconds a topic, which the simulation must not wait for: a thread of its
// own makes and ends them.
class RobotTopics {
 public:
  // node: its callback queue calls the sinks. others: makes and ends whatever else those agents
  // have, on the thread and before the topics count as ready.
  RobotTopics(ros::NodeHandle node, CommandSinks sinks,
              std::function<void(const std::vector<RobotWish>&)> others);
  ~RobotTopics();
  RobotTopics(const RobotTopics&) = delete;
  RobotTopics& operator=(const RobotTopics&) = delete;

  // The agents that there are now, sorted by name. Does not block.
  void Want(std::vector<RobotWish> wishes);
  // Blocks until the topics are those of the last Want before the call.
  void WaitUntilReady();
  std::shared_ptr<const RobotPublisherMap> publishers() const;

 private:
  void Run();
  // Makes and ends topics until they are those of `wishes`.
  void Apply(const std::vector<RobotWish>& wishes);
  std::vector<ros::Subscriber> Subscribe(const std::string& name);

  ros::NodeHandle node_;
  const CommandSinks sinks_;
  const std::function<void(const std::vector<RobotWish>&)> others_;
  std::map<std::string, std::vector<ros::Subscriber>> subscribers_;  // of the thread alone

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<RobotWish> wanted_;
  std::uint64_t wanted_version_ = 0;
  std::uint64_t applied_version_ = 0;
  bool stopping_ = false;
  std::shared_ptr<const RobotPublisherMap> publishers_ = std::make_shared<RobotPublisherMap>();
  std::thread thread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_ROBOT_TOPICS_H_
