#include "latticeworld_ros/publishing/state_publisher.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/agent_markers.h"
#include "latticeworld_ros/conversion/weather_conversion.h"
#include "latticeworld_ros/server/diagnostics.h"

namespace latticeworld {
namespace {

// The policy of agents that do what their command topics say.
constexpr char kExternalPolicy[] = "external";

std::uint64_t TicksPer(double rate_hz, double step_s) {
  return static_cast<std::uint64_t>(std::max(1L, std::lround(1.0 / (rate_hz * step_s))));
}

}  // namespace

StatePublisher::StatePublisher(ros::NodeHandle node, const WorldServerOptions& options,
                               RobotTopics* robots, MapFollower* maps, SensorThread* sensors,
                               std::shared_ptr<const OpenAiClient> language_server,
                               const MasterWatch* master)
    : robots_(robots),
      sensors_(sensors),
      language_server_(std::move(language_server)),
      master_(master),
      frames_(options.frames),
      ticks_per_clock_(TicksPer(options.clock_rate_hz, options.simulator.step_s)),
      ticks_per_state_(TicksPer(options.state_rate_hz, options.simulator.step_s)),
      ticks_per_markers_(TicksPer(options.marker_rate_hz, options.simulator.step_s)),
      ticks_per_weather_(TicksPer(1.0, options.simulator.step_s)),
      clock_(node.advertise<rosgraph_msgs::Clock>("/clock", 100)),
      tf_(node.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      agents_(node.advertise<latticeworld_msgs::AgentStates>("agents", 100)),
      events_(node.advertise<latticeworld_msgs::AgentEvent>("agent_events", 1000)),
      markers_(node.advertise<visualization_msgs::MarkerArray>("agents/markers", 10)),
      weather_(node.advertise<latticeworld_msgs::Weather>("world/weather", 1, /*latch=*/true)),
      diagnostics_(node.advertise<diagnostic_msgs::DiagnosticArray>("diagnostics", 10)),
      scene_(node, maps),
      journal_(node, options.state_hash_rate_hz, options.simulator.step_s) {}

void StatePublisher::OnTick(const Tick& tick) {
  PublishTick(tick);
  // Last, for it may wait.
  sensors_->Take(tick);
}

void StatePublisher::PublishTick(const Tick& tick) {
  const PublishBatch batch;
  const auto due = [&](std::uint64_t ticks) { return tick.settled || tick.number % ticks == 0; };
  const bool state_due = tick.simulator != nullptr && due(ticks_per_state_);
  const bool markers_due = tick.simulator != nullptr && due(ticks_per_markers_);
  const std::vector<Event>& events = tick.events;
  const bool weather_told = std::any_of(events.begin(), events.end(), [](const Event& event) {
    return event.kind == EventKind::kWeatherChanged;
  });
  const bool weather_due =
      tick.simulator != nullptr && (weather_told || (weather_moves_ && due(ticks_per_weather_)));

  if (due(ticks_per_clock_) || state_due || markers_due || weather_due || !events.empty() ||
      journal_.IsDue(tick) || sensors_->IsDue(tick)) {
    PublishClock(tick.now);
  }
  journal_.Publish(tick);
  PublishEvents(tick, events);
  if (state_due || markers_due || weather_due) {
    const std::shared_ptr<const WorldState> state = tick.simulator->State();
    if (weather_due) PublishWeather(tick, *state);
    if (state_due) PublishState(tick, *state);
    if (markers_due) PublishMarkers(tick, *state);
  }
}

const Eigen::Isometry3d* StatePublisher::MapFromOdom(const std::string& robot) const {
  const auto found = map_from_odom_.find(robot);
  return found == map_from_odom_.end() ? nullptr : &found->second;
}

void StatePublisher::OnStandstill(ros::Time now) { PublishClock(now); }

void StatePublisher::OnBegin() {
  map_from_odom_.clear();
  OnRestore();
}

void StatePublisher::OnRestore() {
  // Odometry frames stay where they are: the robots began there. The next tick shows all else.
  weather_moves_ = true;
  scene_.OnJump();
  sensors_->OnJump();
}

void StatePublisher::OnStatistics(const LoopStatistics& statistics) {
  // The clock first: what is published below carries this stamp.
  PublishClock(statistics.now);
  diagnostics_.publish(ToDiagnosticArray(statistics, sensors_->statistics(), language_server_.get(),
                                         master_->report()));
}

void StatePublisher::PublishClock(ros::Time now) {
  clock_.Publish([now] {
    rosgraph_msgs::Clock message;
    message.clock = now;
    return message;
  });
}

void StatePublisher::PublishEvents(const Tick& tick, const std::vector<Event>& events) {
  for (const Event& event : events) {
    events_.Publish([&] { return ToAgentEvent(event, tick.now, tick.world_id()); });
  }
}

void StatePublisher::PublishState(const Tick& tick, const WorldState& state) {
  WishForTopics(state);
  const std::shared_ptr<const RobotPublisherMap> robots = robots_->publishers();
  tf2_msgs::TFMessage transforms;
  transforms.transforms.reserve(state.agents.size() + wishes_.size() + state.props.size());
  for (const AgentSnapshot& agent : state.agents) {
    const Eigen::Isometry3d map_from_base = PoseOf(agent);
    const std::string base = BaseFrame(agent.name);
    const auto robot = robots->find(agent.name);
    if (robot != robots->end()) PublishRobot(agent, tick, robot->second);
    if (!agent.controllable) {
      transforms.transforms.push_back(ToTransformStamped(map_from_base, tick.now, kMapFrame, base));
      continue;
    }
    // Odometry begins where the robot begins, as if switched on there, with z up.
    const Eigen::Isometry3d& map_from_odom =
        map_from_odom_.try_emplace(agent.name, LevelFrameAt(map_from_base)).first->second;
    const Eigen::Isometry3d odom_from_map = map_from_odom.inverse();
    const std::string odom = OdomFrame(agent.name);
    AppendRobotFrames(frames_, agent.name, tick.now, map_from_odom, odom_from_map * map_from_base,
                      &transforms.transforms);
    if (robot != robots->end()) {
      robot->second.odom.Publish([&] { return ToOdometry(agent, tick.now, odom, odom_from_map); });
    }
  }
  for (const PropSnapshot& prop : state.props) {
    transforms.transforms.push_back(ToTransformStamped(
        ToIsometry(prop.position_m, prop.orientation), tick.now, kMapFrame, prop.name));
  }
  PublishTransforms(&transforms);
  agents_.Publish([&] { return ToAgentStates(state, tick.now, tick.world_id()); });
  scene_.Publish(tick, state);
}

void StatePublisher::PublishTransforms(tf2_msgs::TFMessage* message) {
  tf_.Publish([&]() -> const tf2_msgs::TFMessage& {
    // roscpp numbers no message without a header of its own: who records counts losses by this.
    if (!message->transforms.empty()) message->transforms.front().header.seq = ++last_tf_;
    return *message;
  });
}

void StatePublisher::WishForTopics(const WorldState& state) {
  std::vector<RobotWish> wishes;
  for (const AgentSnapshot& agent : state.agents) {
    if (agent.controllable || agent.policy == kExternalPolicy) {
      wishes.push_back({agent.name, agent.controllable, agent.species});
    }
  }
  if (wishes == wishes_) return;
  // A name that comes back later begins anew.
  std::map<std::string, Eigen::Isometry3d> kept;
  for (const RobotWish& wish : wishes) {
    const auto known = map_from_odom_.find(wish.name);
    if (wish.controllable && known != map_from_odom_.end()) kept.insert(*known);
  }
  map_from_odom_ = std::move(kept);
  wishes_ = wishes;
  robots_->Want(std::move(wishes));
}

void StatePublisher::PublishRobot(const AgentSnapshot& agent, const Tick& tick,
                                  const RobotPublishers& robot) {
  robot.ground_truth.Publish(
      [&] { return ToOdometry(agent, tick.now, kMapFrame, Eigen::Isometry3d::Identity()); });
  robot.joint_states.Publish([&] { return ToJointState(agent, tick.now); });
}

void StatePublisher::PublishWeather(const Tick& tick, const WorldState& state) {
  weather_moves_ = state.weather_change_s > 0.0 || tick.simulator->options().day_length_s > 0.0;
  weather_.publish(
      ToWeatherMessage(state.atmosphere, state.weather_change_s, tick.now, tick.world_id()));
}

void StatePublisher::PublishMarkers(const Tick& tick, const WorldState& state) {
  markers_.Publish([&] {
    return ToMarkerArray(state, tick.simulator->scene(), *tick.simulator->options().species,
                         tick.now);
  });
}

}  // namespace latticeworld
