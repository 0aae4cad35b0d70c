#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_THINKING_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_THINKING_H_

#include <string>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

class Digest;

// What an agent in a state shows before its first thought.
Behaviour BehaviourIn(AgentState state);

// One thought: looks around and decides what the agent does and steers for until the next one.
// policy: what it follows now (its own, its team's or its usual one).
void Think(Agent* agent, const std::string& policy, Surroundings* world);

// What the agent wants to move like in the next step: its command while one holds, else what it
// steers for. external: its policy is "external".
VelocityCommand WantedVelocity(const Agent& agent, bool external, std::uint64_t episode_step);

// Strikes the blow that the agent's thoughts or its command ask for, if who it is meant for is in
// front of it and within its reach and its last blow is long enough ago. A commanded blow that
// finds nobody is over. Tells attacked, hit, knocked_over and died.
void Fight(Agent* agent, Surroundings* world);

// All of an agent that its future depends on; its body is the physics world's.
void AddTo(Digest* digest, const Agent& agent);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_THINKING_H_
