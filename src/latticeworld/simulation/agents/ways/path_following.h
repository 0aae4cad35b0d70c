#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_FOLLOWING_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_FOLLOWING_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// The corner to head for next on the way to the place. Keeps mind.path: finds a way where there is
// none or the one that there is has become useless (the place is elsewhere, something came to lie
// across it, the map has changed and it is a detour, the agent strayed from it or gets no nearer to
// its corner for 2 s), no more than once a second, and drops corners that are behind. nullopt: no
// way leads anywhere.
std::optional<WorldPoint> NextCorner(Agent* agent, Surroundings* world, WorldPoint place);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_FOLLOWING_H_
