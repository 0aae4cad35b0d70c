#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_EMBODIMENT_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_EMBODIMENT_H_

#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// Gives the agent a new body at the place, whole health and a fresh mind, as at its start. A body
// that it had before is taken out of the world.
void Embody(WorldPoint place, Agent* agent, RunningWorld* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_EMBODIMENT_H_
