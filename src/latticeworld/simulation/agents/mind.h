#ifndef LATTICEWORLD_SIMULATION_AGENTS_MIND_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MIND_H_

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/surroundings.h"

namespace latticeworld {

class Digest;

// What an agent in a state does as long as nobody is there to hunt.
Behaviour BehaviourIn(AgentState state);

// One thought: decides what the agent does and steers for until the next one.
void Think(Agent* agent, Surroundings* world);

// What the agent wants to move like in the next step: its command while one holds, else what it
// steers for.
VelocityCommand WantedVelocity(const Agent& agent, std::uint64_t episode_step);

// All of an agent that its future depends on; its body is the physics world's.
void AddTo(Digest* digest, const Agent& agent);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MIND_H_
