#include "latticeworld/simulation/agents/mind.h"

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/agents/behaviours.h"
#include "latticeworld/simulation/agents/hostility.h"
#include "latticeworld/simulation/agents/steering.h"

namespace latticeworld {
namespace {

Steering LiveBy(AgentState state, Agent* agent, Surroundings* world) {
  agent->behaviour = BehaviourIn(state);
  switch (agent->behaviour) {
    case Behaviour::kGraze:
      return Graze(agent, world);
    case Behaviour::kSwim:
      return Swim(agent, world);
    case Behaviour::kSoar:
      return Soar(agent, world);
    case Behaviour::kPatrol:
      return Patrol(agent, world);
    default:
      return Rest(*agent);
  }
}

void AddPoint(Digest* digest, WorldPoint point) {
  digest->Add(point.x_m);
  digest->Add(point.y_m);
}
void AddVelocity(Digest* digest, const VelocityCommand& velocity) {
  for (int i = 0; i < 3; ++i) digest->Add(velocity.linear_mps[i]);
  digest->Add(velocity.yaw_rate_radps);
}

}  // namespace

Behaviour BehaviourIn(AgentState state) {
  switch (state) {
    case AgentState::kIdle:
      return Behaviour::kIdle;
    case AgentState::kGrazing:
      return Behaviour::kGraze;
    case AgentState::kSwimming:
      return Behaviour::kSwim;
    case AgentState::kFlying:
      return Behaviour::kSoar;
    case AgentState::kPatrolling:
    case AgentState::kPursuing:  // until there is somebody to pursue or attack
    case AgentState::kAttacking:
      return Behaviour::kPatrol;
  }
  return Behaviour::kIdle;
}

void Think(Agent* agent, Surroundings* world) {
  if (!agent->alive()) {
    agent->behaviour = Behaviour::kDead;
    return;
  }
  if (agent->controllable) {
    agent->behaviour = Behaviour::kControlled;
    return;
  }
  if (agent->team == 2) {
    if (const auto hunting = Hunt(agent, world)) {
      agent->mind.steering = *hunting;
      return;
    }
  }
  agent->mind.steering = LiveBy(agent->state, agent, world);
}

VelocityCommand WantedVelocity(const Agent& agent, std::uint64_t episode_step) {
  if (!agent.alive()) return {};
  if (!agent.controllable) return Follow(agent.mind.steering, agent);
  if (agent.command.has_value() && episode_step < agent.command_until) return *agent.command;
  return {};
}

void AddTo(Digest* digest, const Agent& agent) {
  digest->Add(agent.id);
  digest->AddText(agent.name);
  digest->Add(agent.category);
  digest->Add(agent.state);
  digest->Add(agent.team);
  digest->Add(agent.controllable);
  digest->Add(agent.body);
  digest->Add(agent.hit_points);
  digest->Add(agent.behaviour);
  digest->Add(agent.command.has_value());
  if (agent.command.has_value()) AddVelocity(digest, *agent.command);
  digest->Add(agent.command_until);
  AddVelocity(digest, agent.driven);
  digest->Add(agent.next_collision);

  const Mind& mind = agent.mind;
  for (const std::uint64_t word : mind.random.state()) digest->Add(word);
  AddPoint(digest, mind.home);
  digest->Add(mind.home_z_m);
  digest->Add(static_cast<std::uint64_t>(mind.route.size()));
  for (const WorldPoint& place : mind.route) AddPoint(digest, place);
  digest->Add(static_cast<std::uint64_t>(mind.next_place));
  digest->Add(mind.goal.has_value());
  if (mind.goal.has_value()) AddPoint(digest, *mind.goal);
  digest->Add(mind.goal_until);
  digest->Add(mind.pause_until);
  digest->Add(mind.turn_side);
  digest->Add(mind.target);
  AddPoint(digest, mind.target_seen_at);
  digest->Add(mind.target_seen_step);
  digest->Add(mind.next_blow);
  digest->Add(mind.steering.heading_rad);
  digest->Add(mind.steering.speed_mps);
  digest->Add(mind.steering.base_z_m.has_value());
  if (mind.steering.base_z_m.has_value()) digest->Add(*mind.steering.base_z_m);
  digest->Add(mind.steering.hold.has_value());
  if (mind.steering.hold.has_value()) AddPoint(digest, *mind.steering.hold);
}

}  // namespace latticeworld
