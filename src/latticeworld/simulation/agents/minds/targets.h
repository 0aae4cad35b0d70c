#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_TARGETS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_TARGETS_H_

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// What choosers of targets are made of.

// Returns where somebody was perceived last.
WorldPoint PlaceOf(const Sighting& sighting);
double AgeOf(const Sighting& sighting, const Surroundings& world);  // [s]

// The nearest enemy that it sees at this moment within distance_m and could ever get at: nothing
// that flies over its head. nullptr: none.
const Sighting* NearestSeenEnemy(const Agent& agent, const Surroundings& world, double distance_m);
// The enemy that struck it in the last second; nullptr: none.
const Sighting* Striker(const Agent& agent, const Surroundings& world);

// Drops the target that is forgotten (or dead) or further away than farthest_m; takes a striker
// for the target when the one that it has is out of its reach; without one, takes the nearest
// enemy seen within take_m.
void KeepOrTakeTarget(Agent* agent, const Surroundings& world, double take_m, double farthest_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_TARGETS_H_
