#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_PEACEFUL_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_PEACEFUL_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Pieces of behaviour trees (behaviour_tree.h) of agents that nobody disturbs. Those that ask for
// wings, fins or feet answer nullopt without.

// Stands at its home, and goes back there when something has moved it away.
std::optional<Steering> Idle(Agent* agent, Surroundings* world);
// Goes from place to place, wherever the last one leads to.
std::optional<Steering> Wander(Agent* agent, Surroundings* world);
// A loop of places around its home.
std::optional<Steering> Patrol(Agent* agent, Surroundings* world);
// Goes from one patch of grass to the next with its herd, and stands in between.
std::optional<Steering> Graze(Agent* agent, Surroundings* world);
// Swims from place to place through deep water.
std::optional<Steering> Swim(Agent* agent, Surroundings* world);
// Circles around its home above ground, water and trees.
std::optional<Steering> Soar(Agent* agent, Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_PEACEFUL_H_
