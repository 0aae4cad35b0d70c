#ifndef LATTICEWORLD_SIMULATION_AGENTS_PERCEPTION_H_
#define LATTICEWORLD_SIMULATION_AGENTS_PERCEPTION_H_

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/surroundings.h"

namespace latticeworld {

// Looks and listens around, and brings mind.memory up to date: sightings by who, forgotten after
// 30 s, of agents that are gone or dead at once. It sees what is in its field of view, nearer than
// its species, the air and the light let it see, with no ground, standing tree or building between
// their eyes, of many the nearest few; it hears what is loud enough (moves) and near enough through
// wind and rain.
void Perceive(Agent* agent, const Surroundings& world);

// Puts a sighting into its memory, in the place of what it remembered of the same one.
void Remember(Agent* agent, const Sighting& sighting);

// What it remembers of somebody; nullptr: nothing.
const Sighting* MemoryOf(const Agent& agent, AgentId who);
// The nearest enemy that it remembers to be within distance_m of it, not older than age_s; nullptr:
// none.
const Sighting* NearestEnemy(const Agent& agent, const Surroundings& world, double distance_m,
                             double age_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_PERCEPTION_H_
