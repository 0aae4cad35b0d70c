#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_PERCEPTION_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_PERCEPTION_H_

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Looks and listens around, and brings mind.memory up to date: sightings by who, forgotten after
// 30 s, of agents that are gone or dead at once. It sees what is in its field of view, nearer than
// its species, the air and the light let it see, with no ground, standing tree or building between
// their eyes, of many the nearest few; it hears what is loud enough (moves) and near enough through
// wind and rain.
void Perceive(Agent* agent, const Surroundings& world);

// Puts a sighting into its memory, in the place of what it remembered of the same one.
void Remember(Agent* agent, const Sighting& sighting);
// The same of what another one perceived and tells it of.
void RememberHearsay(Agent* agent, const Sighting& sighting);

// What it remembers of somebody; nullptr: nothing.
const Sighting* MemoryOf(const Agent& agent, AgentId who);
// The nearest to the agent of those that it remembers within distance_m of it that pass the test
// (bool(const Sighting&)), which is asked about no others; nullptr: none.
template <typename Passes>
const Sighting* NearestOf(const Agent& agent, double distance_m, const Passes& passes) {
  const Sighting* nearest = nullptr;
  for (const Sighting& sighting : agent.mind.memory) {
    const double range_m = (sighting.position_m - agent.motion.position_m).norm();
    if (range_m > distance_m || !passes(sighting)) continue;
    distance_m = range_m;
    nearest = &sighting;
  }
  return nearest;
}
// The nearest of all that it remembers to be within distance_m of it, not older than age_s, whoever
// they are; nullptr: none.
const Sighting* NearestKnown(const Agent& agent, const Surroundings& world, double distance_m,
                             double age_s);
// The nearest enemy that it remembers to be within distance_m of it, not older than age_s; nullptr:
// none.
const Sighting* NearestEnemy(const Agent& agent, const Surroundings& world, double distance_m,
                             double age_s);

// Whether a blow hit it in so many last seconds.
bool WasHit(const Agent& agent, const Surroundings& world, double within_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_PERCEPTION_H_
