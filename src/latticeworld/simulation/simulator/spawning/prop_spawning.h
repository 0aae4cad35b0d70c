#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_PROP_SPAWNING_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_PROP_SPAWNING_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// Puts a prop into the world and tells spawned; the answer is its name. Errors: see
// Simulator::SpawnProp; nothing changes then.
Result<std::string> AddProp(const Prop& prop, RunningWorld* world);
// Takes one out and tells removed. Errors: NOT_FOUND.
Status EraseProp(const std::string& name, RunningWorld* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SPAWNING_PROP_SPAWNING_H_
