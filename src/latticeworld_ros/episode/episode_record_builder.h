#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_RECORD_BUILDER_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_RECORD_BUILDER_H_

#include <ros/time.h>
#include <sensor_msgs/JointState.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "latticeworld/episode/episode_record.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// Gathers what an episode was from its messages: events first, then states, each in order.
class EpisodeRecordBuilder {
 public:
  explicit EpisodeRecordBuilder(const latticeworld_msgs::EpisodeStart& start);

  void Add(const latticeworld_msgs::AgentEvent& message);
  void Add(const latticeworld_msgs::AgentStates& message);
  void Add(const latticeworld_msgs::EpisodeEnd& message);
  // topic: <agent>/joint_states.
  void Add(const sensor_msgs::JointState& message, const std::string& topic);
  void CountHash() { ++record_.hashes; }
  EpisodeRecord Take();

 private:
  // Seconds since the episode began.
  double Since(ros::Time stamp) const { return (stamp - begin_).toSec(); }
  // Whether the agent was put somewhere between two moments.
  bool WasPut(const std::string& agent, double from_s, double to_s) const;

  const ros::Time begin_;
  const std::uint64_t begin_step_;
  EpisodeRecord record_;
  std::map<std::string, std::vector<double>> put_s_;  // when agents came or came back, by agent
  bool begun_ = false;
  std::uint64_t step_ = 0, episode_step_ = 0;  // of the states before
  double time_s_ = 0.0;                        // of the states before
  std::map<std::string, double> joints_s_;     // of the last joint states, by agent
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_RECORD_BUILDER_H_
