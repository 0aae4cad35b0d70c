#ifndef LATTICEWORLD_SIMULATION_AGENTS_PATH_FOLLOWING_H_
#define LATTICEWORLD_SIMULATION_AGENTS_PATH_FOLLOWING_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/surroundings.h"

namespace latticeworld {

class Digest;

// The corner to head for next on the way to the place. Keeps mind.path: finds a way where there is
// none or the one that there is has become useless (the place is elsewhere, something fell across
// it, the agent strayed from it or gets no nearer to its corner for 2 s), no more than once a
// second, and drops corners that are behind. nullopt: no way leads anywhere.
std::optional<WorldPoint> NextCorner(Agent* agent, Surroundings* world, WorldPoint place);

// All of it that the future depends on.
void AddTo(Digest* digest, const PathPlan& plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_PATH_FOLLOWING_H_
