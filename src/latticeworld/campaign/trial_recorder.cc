#include "latticeworld/campaign/trial_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

constexpr double kNear_m = 40.0;  // others farther than this are not looked at

const AgentSnapshot* Find(const WorldState& state, const std::string& name) {
  const auto found = std::lower_bound(
      state.agents.begin(), state.agents.end(), name,
      [](const AgentSnapshot& agent, const std::string& text) { return agent.name < text; });
  return found != state.agents.end() && found->name == name ? &*found : nullptr;
}

}  // namespace

double TrialRecorder::TimeToCollisionOf(const WorldState& state, const AgentSnapshot& robot) const {
  const auto species_of = [this](const AgentSnapshot& agent) -> const Species& {
    const Species* found = catalogue_->Find(agent.species);
    return found != nullptr ? *found : catalogue_->Of(agent.category);
  };
  const Species& own = species_of(robot);
  const Eigen::Vector3d own_mps = robot.orientation * robot.linear_velocity_mps;
  double least_s = std::numeric_limits<double>::infinity();
  for (const AgentSnapshot& other : state.agents) {
    const Eigen::Vector3d apart_m = other.position_m - robot.position_m;
    if (other.name == robot.name || apart_m.head<2>().squaredNorm() > kNear_m * kNear_m) continue;
    const Species& species = species_of(other);
    // One above the other never meets it.
    if (apart_m.z() > own.height_m || -apart_m.z() > species.height_m) continue;
    const Eigen::Vector3d other_mps = other.orientation * other.linear_velocity_mps;
    least_s = std::min(least_s, TimeToCollision(apart_m.head<2>(), (other_mps - own_mps).head<2>(),
                                                own.radius_m + species.radius_m));
  }
  return least_s;
}

void TrialRecorder::Watch(const WorldState& state, const std::vector<Event>& events,
                          double step_s) {
  const AgentSnapshot* robot = Find(state, robot_);
  if (robot == nullptr) {
    record_.survived = false;
    return;
  }
  for (const JointSnapshot& joint : robot->joints)
    work_j_ += std::abs(joint.effort_nm * joint.rate_radps) * step_s;
  if (robot->contact_force_n >= kContactForce_n) {
    if (state.episode_time_s - last_press_s_ > kContactPause_s)
      record_.collision_times_s.push_back(state.episode_time_s);
    last_press_s_ = state.episode_time_s;
  }
  for (const Event& event : events) {
    if (event.other == robot_ && event.kind == EventKind::kPursued) ++interventions_.pursuits;
    if (event.other == robot_ && event.kind == EventKind::kAttacked) ++interventions_.attacks;
    if (event.agent != robot_) continue;
    if (event.kind == EventKind::kHit) ++interventions_.hits;
    if (event.kind == EventKind::kDied || event.kind == EventKind::kDrowned ||
        event.kind == EventKind::kLeftWorld || event.kind == EventKind::kRemoved) {
      record_.survived = false;
      death_ += (death_.empty() ? "" : ", ") + std::string(NameOf(event.kind));
      if (!event.other.empty()) death_ += " by " + event.other;
    }
  }
  record_.adversary_hits = interventions_.hits;
}

void TrialRecorder::Sample(const WorldState& state) {
  const AgentSnapshot* robot = Find(state, robot_);
  if (robot == nullptr) return;
  TrialSample sample;
  sample.time_s = state.episode_time_s;
  sample.position_m = robot->position_m;
  const Eigen::Vector3d forward = robot->orientation * Eigen::Vector3d::UnitX();
  sample.yaw_rad = std::atan2(forward.y(), forward.x());
  const double since_s =
      record_.samples.empty() ? 0.0 : sample.time_s - record_.samples.back().time_s;
  if (!record_.samples.empty() && since_s <= 0.0) return;
  sample.power_w = since_s > 0.0 ? work_j_ / since_s : 0.0;
  work_j_ = 0.0;
  sample.time_to_collision_s = TimeToCollisionOf(state, *robot);
  record_.samples.push_back(sample);
}

}  // namespace latticeworld
