#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_FEAR_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_FEAR_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Pieces of behaviour trees (behaviour_tree.h) that get an agent away from others.

// Runs from a place: away from it as directly as the ground lets it.
Steering RunFrom(Agent* agent, Surroundings* world, WorldPoint danger);

// Runs from enemies (animals: from all that hunt) that come near and from who struck it, until some
// seconds after they are gone. An alarm spreads through a herd.
std::optional<Steering> Flee(Agent* agent, Surroundings* world);

// Fewer hit points are left than its kind fights on with.
bool IsHurt(const Agent& agent, const Surroundings& world);
// Keeps away from the enemies that it knows of; nullopt where it knows of none.
std::optional<Steering> Retreat(Agent* agent, Surroundings* world);
// Leads it away from its target for some seconds after a blow of its own that may have landed.
std::optional<Steering> Withdraw(Agent* agent, Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_PIECES_FEAR_H_
