#ifndef LATTICEWORLD_SIMULATION_AGENTS_HOSTILITY_H_
#define LATTICEWORLD_SIMULATION_AGENTS_HOSTILITY_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/surroundings.h"

namespace latticeworld {

// True when the agent sees the other: near enough, nearer than the air lets it see, and no ground
// or solid thing between their eyes.
bool Sees(const Agent& agent, const Agent& other, const Surroundings& world, double distance_m);

// What an adversary does about robots and main agents: pursues the nearest one that it sees within
// the pursuit distance, goes where it last saw it, strikes when it reaches it, and gives up when it
// is far away or out of sight for some seconds. nullopt: nobody to hunt. Sets the behaviour to
// pursue or attack, tells pursued, attacked, hit and died.
std::optional<Steering> Hunt(Agent* agent, Surroundings* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_HOSTILITY_H_
