#include "latticeworld_ros/episode/episode_record_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latticeworld {
namespace {

// Joints that were silent for longer did something that nobody knows.
constexpr double kMaxJointGap_s = 1.0;

double YawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

// "/world/robot/joint_states" -> "robot".
std::string AgentOf(const std::string& topic) {
  const std::size_t end = topic.rfind('/');
  if (end == std::string::npos || end == 0) return "";
  const std::size_t begin = topic.rfind('/', end - 1);
  return topic.substr(begin == std::string::npos ? 0 : begin + 1,
                      end - (begin == std::string::npos ? 0 : begin + 1));
}

}  // namespace

EpisodeRecordBuilder::EpisodeRecordBuilder(const latticeworld_msgs::EpisodeStart& start)
    : begin_(start.header.stamp), begin_step_(start.step) {
  record_.name = start.name;
  record_.world_id = start.world_id;
  record_.seed = start.seed;
}

void EpisodeRecordBuilder::Add(const latticeworld_msgs::AgentEvent& message) {
  if (message.header.stamp < begin_) return;
  EpisodeEvent event;
  event.time_s = Since(message.header.stamp);
  event.kind = message.kind;
  event.agent = message.agent;
  event.other = message.other;
  event.position_m = {message.position.x, message.position.y, message.position.z};
  for (const char* kind : {"spawned", "respawned", "frozen", "left_world"}) {
    if (event.kind == kind) put_s_[event.agent].push_back(event.time_s);
  }
  record_.events.push_back(std::move(event));
}

void EpisodeRecordBuilder::Add(const latticeworld_msgs::EpisodeEnd& message) {
  record_.ended_by = message.reason;
  if (message.header.stamp > begin_) {
    record_.duration_s = std::max(record_.duration_s, Since(message.header.stamp));
  }
}

bool EpisodeRecordBuilder::WasPut(const std::string& agent, double from_s, double to_s) const {
  const auto put = put_s_.find(agent);
  return put != put_s_.end() &&
         std::any_of(put->second.begin(), put->second.end(),
                     [&](double time_s) { return time_s > from_s && time_s <= to_s; });
}

void EpisodeRecordBuilder::Add(const latticeworld_msgs::AgentStates& message) {
  if (message.header.stamp < begin_) return;
  // A reset or restored snapshot goes on from elsewhere: both counts of steps tell.
  const bool goes_on = begun_ && message.step >= step_ && message.episode_step >= episode_step_ &&
                       message.step - step_ == message.episode_step - episode_step_;
  if (goes_on && message.step == step_) return;  // shown once more, while time stands still
  const double time_s = Since(message.header.stamp);
  for (const latticeworld_msgs::AgentState& state : message.agents) {
    AgentTrack& track = record_.tracks[state.name];
    track.name = state.name;
    track.species = state.species;
    track.team = state.team;
    track.controllable = state.controllable != 0;
    TrackPoint point;
    point.time_s = time_s;
    point.position_m = {state.pose.position.x, state.pose.position.y, state.pose.position.z};
    point.yaw_rad = YawOf(state.pose.orientation);
    const geometry_msgs::Vector3& velocity = state.twist.linear;
    point.speed_mps =
        std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y + velocity.z * velocity.z);
    point.health = state.health;
    point.behaviour = state.behaviour;
    point.continues = goes_on && !track.points.empty() && track.points.back().time_s == time_s_ &&
                      !WasPut(state.name, time_s_, time_s);
    track.points.push_back(std::move(point));
  }
  begun_ = true;
  step_ = message.step;
  episode_step_ = message.episode_step;
  time_s_ = time_s;
  record_.duration_s = std::max(record_.duration_s, time_s);
  record_.steps = std::max(record_.steps, message.step - std::min(begin_step_, message.step));
}

void EpisodeRecordBuilder::Add(const sensor_msgs::JointState& message, const std::string& topic) {
  if (message.header.stamp < begin_) return;
  const std::string agent = AgentOf(topic);
  const double time_s = Since(message.header.stamp);
  const auto known = record_.tracks.find(agent);
  if (known == record_.tracks.end()) return;  // of something else
  AgentTrack& track = known->second;
  track.joint_work_j = std::max(0.0, track.joint_work_j);
  const auto [before, first] = joints_s_.try_emplace(agent, time_s);
  const double elapsed_s = time_s - before->second;
  before->second = time_s;
  if (first || elapsed_s <= 0.0 || elapsed_s > kMaxJointGap_s) return;
  double power_w = 0.0;
  for (std::size_t i = 0; i < std::min(message.velocity.size(), message.effort.size()); ++i) {
    power_w += std::abs(message.velocity[i] * message.effort[i]);
  }
  if (std::isfinite(power_w)) track.joint_work_j += power_w * elapsed_s;
}

EpisodeRecord EpisodeRecordBuilder::Take() { return std::move(record_); }

}  // namespace latticeworld
