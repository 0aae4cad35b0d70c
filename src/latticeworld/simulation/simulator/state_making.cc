#include "latticeworld/simulation/simulator/state_making.h"

#include <map>
#include <utility>

#include "latticeworld/simulation/props/bumps.h"
#include "latticeworld/simulation/sensed.h"

namespace latticeworld {
namespace {

void Tell(const Bump& bump, AgentSnapshot* agent) {
  if (!HasSensors(*agent)) return;
  agent->contact_force_n = bump.force_n;
  agent->contact_direction =
      agent->orientation.conjugate() * (bump.point_m - agent->position_m).normalized();
}

JointReading ReadingOf(BodyId body, const JointName& joint, const PhysicsWorld& physics) {
  switch (joint.kind) {
    case JointName::Kind::kWheel:
      return physics.WheelOf(body, joint.index);
    case JointName::Kind::kSteering:
      return physics.SteeringOf(body, joint.index);
    case JointName::Kind::kLink:
      return physics.JointOf(body, joint.index);
  }
  return JointReading();
}

std::vector<JointSnapshot> JointSnapshotsOf(BodyId body, const std::vector<JointName>& joints,
                                            const PhysicsWorld& physics) {
  std::vector<JointSnapshot> snapshots;
  for (const JointName& joint : joints) {
    const JointReading reading = ReadingOf(body, joint, physics);
    JointSnapshot& snapshot = snapshots.emplace_back();
    snapshot.name = joint.name;
    snapshot.angle_rad = reading.angle_rad;
    snapshot.rate_radps = reading.rate_radps;
    snapshot.effort_nm = reading.effort_nm;
  }
  return snapshots;
}

// Fills a snapshot of an agent; the caller adds the joints.
AgentSnapshot SnapshotOf(const Agent& agent, const TeamPolicies& policies) {
  AgentSnapshot snapshot;
  snapshot.name = agent.name;
  snapshot.category = agent.species->category;
  snapshot.species = agent.species->name;
  snapshot.policy = policies.PolicyOf(agent);
  snapshot.team = agent.team;
  snapshot.controllable = agent.controllable;
  snapshot.behaviour = agent.behaviour;
  snapshot.health = agent.hit_points / agent.species->hit_points;
  snapshot.position_m = agent.motion.position_m;
  snapshot.orientation = agent.motion.orientation;
  const Eigen::Quaterniond base_from_map = agent.motion.orientation.conjugate();
  snapshot.linear_velocity_mps = base_from_map * agent.motion.linear_velocity_mps;
  snapshot.angular_velocity_radps = base_from_map * agent.motion.angular_velocity_radps;
  return snapshot;
}

// Sorted by name.
std::vector<AgentSnapshot> SnapshotsOf(const RunningWorld& world, const TeamPolicies& policies,
                                       const JointNames& joints) {
  const PhysicsWorld& physics = world.dynamic_scene.physics();
  std::vector<AgentSnapshot> snapshots;
  snapshots.reserve(world.agents.all().size());
  const std::map<BodyId, Bump> bumps = HardestBumps(physics.contacts());
  for (const auto& [name, id] : world.agents.ids()) {
    const Agent& agent = world.agents.all().at(id);
    AgentSnapshot& snapshot = snapshots.emplace_back(SnapshotOf(agent, policies));
    if (agent.controllable || policies.IsExternal(agent)) {
      snapshot.joints = JointSnapshotsOf(agent.body, joints.Of(*agent.species), physics);
    }
    const auto bump = bumps.find(agent.body);
    if (bump != bumps.end()) Tell(bump->second, &snapshot);
  }
  return snapshots;
}

}  // namespace

std::shared_ptr<const WorldState> StateOf(const RunningWorld& world, const TeamPolicies& policies,
                                          const JointNames& joints) {
  const DynamicScene& scene = world.dynamic_scene;
  auto state = std::make_shared<WorldState>();
  state->step = world.clock.step();
  state->time_s = world.clock.time_s();
  state->episode_step = world.clock.episode_step();
  state->episode_time_s = world.clock.episode_time_s();
  state->contacts = static_cast<int>(scene.physics().contacts().size());
  state->atmosphere = world.weather.now();
  state->weather_change_s = world.weather.remaining_s();
  state->agents = SnapshotsOf(world, policies, joints);
  state->props = scene.props().Snapshots();
  state->felled = scene.felling().Snapshots();
  if (!scene.props().is_as_begun()) state->standing = scene.props().standing();
  state->map_ground = world.map.ground();
  state->map_version = world.map.version();
  return state;
}

}  // namespace latticeworld
