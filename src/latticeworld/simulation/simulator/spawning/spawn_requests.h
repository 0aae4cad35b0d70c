#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_REQUESTS_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_REQUESTS_H_

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// Whether a request can be met somewhere: it is legal, there is room, and its name is new. Errors:
// see Simulator::Spawn.
Status CheckRequest(const SpawnRequest& request, const RunningWorld& world);
// The species that a legal request asks for.
const Species& SpeciesFor(const SpawnRequest& request, const SpeciesCatalogue& catalogue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_REQUESTS_H_
