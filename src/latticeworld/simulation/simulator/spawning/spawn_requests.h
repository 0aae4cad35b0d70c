#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_REQUESTS_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_REQUESTS_H_

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// The species that a request asks for. Errors: INVALID_ARGUMENT that names those that there are.
Result<const Species*> SpeciesFor(const SpawnRequest& request, const SpeciesCatalogue& catalogue);
// Whether a request can be met somewhere: its name, numbers, state, team and policy. Errors: see
// Simulator::Spawn. species: that of the request.
Status CheckRequest(const SpawnRequest& request, const Species& species, const RunningWorld& world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_REQUESTS_H_
