#ifndef LATTICEWORLD_SIMULATION_AGENTS_BEHAVIOURS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BEHAVIOURS_H_

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/surroundings.h"

namespace latticeworld {

// Each gives what the agent steers for until its next thought.

Steering Rest(const Agent& agent);
// Walks or flies a loop of places around its home, each in reach of the one before.
Steering Patrol(Agent* agent, Surroundings* world);
// Wanders from one patch of grass to the next near its herd and stands in between.
Steering Graze(Agent* agent, Surroundings* world);
// From place to place through deep water.
Steering Swim(Agent* agent, Surroundings* world);
// Circles around its home above ground, water and trees.
Steering Soar(Agent* agent, Surroundings* world);
// Goes to a place at a speed; wings keep their altitude.
Steering Travel(Agent* agent, Surroundings* world, WorldPoint place, double speed_mps);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BEHAVIOURS_H_
