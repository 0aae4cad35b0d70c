#ifndef LATTICEWORLD_SIMULATION_AGENTS_LOCOMOTION_H_
#define LATTICEWORLD_SIMULATION_AGENTS_LOCOMOTION_H_

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/surroundings.h"

namespace latticeworld {

// The command within what the species can do.
VelocityCommand ClampToLimits(AgentCategory category, const VelocityCommand& command);

// Turns a wanted velocity into wheel rates, steps, thrust or strokes for the next step. A dead
// agent drives nothing; gravity, water and wind still act on it.
void Drive(Agent* agent, const VelocityCommand& wanted, Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_LOCOMOTION_H_
