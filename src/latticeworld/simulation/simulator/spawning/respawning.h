#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_RESPAWNING_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_RESPAWNING_H_

#include "latticeworld/simulation/simulator/running_world.h"
#include "latticeworld/simulation/simulator/stray_watch.h"

namespace latticeworld {

// Those who died long enough ago come back at their start, or near it, as their species says; tells
// respawned.
void RespawnAgents(const StrayWatch& strays, RunningWorld* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_RESPAWNING_H_
