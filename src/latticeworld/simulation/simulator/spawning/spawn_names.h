#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_NAMES_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_NAMES_H_

#include <string>

#include "latticeworld/common/status.h"
#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// OK for a name that neither an agent nor a prop has. Errors: ALREADY_EXISTS.
Status CheckNewName(const std::string& name, const RunningWorld& world);
// The first of "<kind>_1", "<kind>_2" ... that is not in use.
std::string NewNameFor(const std::string& kind, const RunningWorld& world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_SPAWN_NAMES_H_
