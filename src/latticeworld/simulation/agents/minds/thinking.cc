#include "latticeworld/simulation/agents/minds/thinking.h"

#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/policy.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {

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

void Think(Agent* agent, const std::string& policy, Surroundings* world) {
  if (!agent->able()) {
    agent->behaviour = agent->alive() ? Behaviour::kFallen : Behaviour::kDead;
    agent->mind.steering = StandHere(*agent);
    return;
  }
  if (agent->controllable) {
    TakeUp(agent, Behaviour::kControlled);
    agent->mind.steering = StandHere(*agent);
    return;
  }
  Perceive(agent, *world);
  const Policy* followed = FindPolicy(policy);
  if (followed == nullptr)
    followed = FindPolicy(UsualPolicy(agent->species->category, agent->state));
  agent->mind.steering = followed->Decide(agent, world);
}

VelocityCommand WantedVelocity(const Agent& agent, bool external, std::uint64_t episode_step) {
  if (!agent.able()) return {};
  if (!agent.controllable && !external) return Follow(agent.mind.steering, agent);
  if (agent.command.has_value() && episode_step < agent.command_until) return *agent.command;
  return {};
}

}  // namespace latticeworld
