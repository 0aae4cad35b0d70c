#include <map>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/simulation/props/bumps.h"
#include "latticeworld/simulation/sensed.h"
#include "latticeworld/simulation/simulator/simulator_impl.h"

namespace latticeworld {

namespace {

void Tell(const Bump& bump, AgentSnapshot* agent) {
  if (!HasSensors(*agent)) return;
  agent->contact_force_n = bump.force_n;
  agent->contact_direction =
      agent->orientation.conjugate() * (bump.point_m - agent->position_m).normalized();
}

}  // namespace

const std::vector<JointName>& SimulatorImpl::JointsOfSpecies(const Species& species) const {
  const auto found = joints_.find(&species);
  if (found != joints_.end()) return found->second;
  return joints_.emplace(&species, JointsOf(species)).first->second;
}

std::vector<JointSnapshot> SimulatorImpl::JointSnapshotsOf(const Agent& agent) const {
  std::vector<JointSnapshot> snapshots;
  for (const JointName& joint : JointsOfSpecies(*agent.species)) {
    JointReading reading;
    switch (joint.kind) {
      case JointName::Kind::kWheel:
        reading = physics_->WheelOf(agent.body, joint.index);
        break;
      case JointName::Kind::kSteering:
        reading = physics_->SteeringOf(agent.body, joint.index);
        break;
      case JointName::Kind::kLink:
        reading = physics_->JointOf(agent.body, joint.index);
        break;
    }
    snapshots.push_back({joint.name, reading.angle_rad, reading.rate_radps, reading.effort_nm});
  }
  return snapshots;
}

AgentSnapshot SimulatorImpl::SnapshotOf(const Agent& agent) const {
  AgentSnapshot snapshot;
  snapshot.name = agent.name;
  snapshot.category = agent.species->category;
  snapshot.species = agent.species->name;
  snapshot.policy = PolicyOf(agent);
  snapshot.team = agent.team;
  snapshot.controllable = agent.controllable;
  snapshot.behaviour = agent.behaviour;
  snapshot.health = agent.hit_points / agent.species->hit_points;
  snapshot.position_m = agent.motion.position_m;
  snapshot.orientation = agent.motion.orientation;
  const Eigen::Quaterniond base_from_map = agent.motion.orientation.conjugate();
  snapshot.linear_velocity_mps = base_from_map * agent.motion.linear_velocity_mps;
  snapshot.angular_velocity_radps = base_from_map * agent.motion.angular_velocity_radps;
  if (agent.controllable || IsExternal(agent)) snapshot.joints = JointSnapshotsOf(agent);
  return snapshot;
}

std::shared_ptr<const WorldState> SimulatorImpl::State() const {
  if (state_ != nullptr) return state_;
  auto state = std::make_shared<WorldState>();
  state->step = step_;
  state->time_s = static_cast<double>(step_) * options_.step_s;
  state->episode_step = episode_step_;
  state->episode_time_s = static_cast<double>(episode_step_) * options_.step_s;
  state->contacts = static_cast<int>(physics_->contacts().size());
  state->atmosphere = weather_->now();
  state->weather_change_s = weather_->remaining_s();
  state->agents.reserve(agents_.size());
  const std::map<BodyId, Bump> bumps = HardestBumps(physics_->contacts());
  for (const auto& [name, id] : ids_) {
    const Agent& agent = agents_.at(id);
    state->agents.push_back(SnapshotOf(agent));
    const auto bump = bumps.find(agent.body);
    if (bump != bumps.end()) Tell(bump->second, &state->agents.back());
  }
  state->props = props_->Snapshots();
  state->felled = felling_->Snapshots();
  if (!props_->is_as_begun()) state->standing = props_->standing();
  state->map_ground = map_ground_;
  state->map_version = map_version_;
  state_ = std::move(state);
  return state_;
}

std::vector<Event> SimulatorImpl::TakeEvents() { return std::exchange(events_, {}); }

std::string SimulatorImpl::StateHash() const {
  Digest digest;
  digest.Add(seed_);
  digest.Add(episode_step_);
  digest.Add(options_.step_s);
  digest.Add(options_.command_timeout_s);
  digest.Add(options_.pursuit_distance_m);
  weather_->AddTo(&digest);
  digest.Add(map_version_);
  const GroundState map_ground = map_ground_.value_or(scene_->atmosphere.ground());
  for (const double value : {map_ground.wetness, map_ground.snow_depth_m, map_ground.blown_sand})
    digest.Add(value);
  digest.Add(last_agent_);
  for (const std::uint64_t word : spawn_random_.state()) digest.Add(word);
  digest.Add(static_cast<std::uint64_t>(agents_.size()));
  for (const auto& [id, agent] : agents_) AddTo(&digest, agent);
  digest.Add(static_cast<std::uint64_t>(frozen_until_.size()));
  for (const auto& [id, until] : frozen_until_) {
    digest.Add(id);
    digest.Add(until);
  }
  digest.Add(static_cast<std::uint64_t>(strays_.size()));
  for (const auto& [name, stray] : strays_) {
    digest.AddText(name);
    digest.Add(stray.since);
    digest.Add(stray.until);
  }
  digest.Add(static_cast<std::uint64_t>(slowed_until_.size()));
  for (const auto& [body, until] : slowed_until_) {
    digest.Add(body);
    digest.Add(until);
  }
  digest.Add(static_cast<std::uint64_t>(team_policies_.size()));
  for (const auto& [team, policy] : team_policies_) {
    digest.Add(team);
    digest.AddText(policy);
  }
  felling_->AddTo(&digest);
  props_->AddTo(&digest);
  physics_->AddTo(&digest);
  return digest.Hex();
}

}  // namespace latticeworld
