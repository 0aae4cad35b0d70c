#ifndef LATTICEWORLD_ROS_PUBLISHING_STATE_PUBLISHER_H_
#define LATTICEWORLD_ROS_PUBLISHING_STATE_PUBLISHER_H_

#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld_ros/node/master_watch.h"
#include "latticeworld_ros/publishing/heard_publisher.h"
#include "latticeworld_ros/publishing/journal_publisher.h"
#include "latticeworld_ros/publishing/robot_frames.h"
#include "latticeworld_ros/publishing/robot_topics.h"
#include "latticeworld_ros/publishing/scene_publisher.h"
#include "latticeworld_ros/running/sensor_thread.h"
#include "latticeworld_ros/running/simulation_listener.h"
#include "latticeworld_ros/server/world_server_options.h"

namespace latticeworld {

// Publishes what changes while a world runs: /clock (before all that carries its stamp), /tf (one
// message a tick, whatever the number of agents and props), agents, agent_events, world/weather
// (latched, once a second while it moves), odometry and joint states, agents/markers, diagnostics
// and what the scene publisher and the journal publisher do. Everything but the constructor runs on
// the simulation loop's thread.
class StatePublisher : public SimulationListener {
 public:
  // language_server: for diagnostics; nullptr: there is none. master: outlives the publisher.
  StatePublisher(ros::NodeHandle node, const WorldServerOptions& options, RobotTopics* robots,
                 MapFollower* maps, SensorThread* sensors,
                 std::shared_ptr<const OpenAiClient> language_server, const MasterWatch* master);

  void OnTick(const Tick& tick) override;
  void OnStandstill(ros::Time now) override;
  void OnBegin() override;
  void OnRestore() override;
  void OnStatistics(const LoopStatistics& statistics) override;

  // Returns where the odometry of a controllable robot began; nullptr: it has none.
  const Eigen::Isometry3d* MapFromOdom(const std::string& robot) const;

 private:
  // What is due of a tick, but for the sensors' part.
  void PublishTick(const Tick& tick);
  void PublishClock(ros::Time now);
  void PublishEvents(const Tick& tick, const std::vector<Event>& events);
  void PublishState(const Tick& tick, const WorldState& state);
  // Numbers a message that is not empty in its first transform.
  void PublishTransforms(tf2_msgs::TFMessage* message);
  // Lets agents have the topics that they should have.
  void WishForTopics(const WorldState& state);
  // What every agent that obeys commands tells.
  void PublishRobot(const AgentSnapshot& agent, const Tick& tick, const RobotPublishers& robot);
  void PublishWeather(const Tick& tick, const WorldState& state);
  void PublishMarkers(const Tick& tick, const WorldState& state);

  RobotTopics* const robots_;
  SensorThread* const sensors_;
  const std::shared_ptr<const OpenAiClient> language_server_;
  const MasterWatch* const master_;
  const RobotFrameOptions frames_;
  const std::uint64_t ticks_per_clock_;
  const std::uint64_t ticks_per_state_;
  const std::uint64_t ticks_per_markers_;
  const std::uint64_t ticks_per_weather_;
  HeardPublisher clock_, tf_, agents_, events_, markers_;
  ros::Publisher weather_, diagnostics_;
  ScenePublisher scene_;
  JournalPublisher journal_;
  std::uint32_t last_tf_ = 0;  // number of the last message of tf that somebody heard
  bool weather_moves_ = true;  // as published last; true: nothing was

  std::vector<RobotWish> wishes_;                           // as last told to robots_
  std::map<std::string, Eigen::Isometry3d> map_from_odom_;  // where each robot began
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_PUBLISHING_STATE_PUBLISHER_H_
