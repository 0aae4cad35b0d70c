#ifndef LATTICEWORLD_SIMULATION_SENSED_H_
#define LATTICEWORLD_SIMULATION_SENSED_H_

#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

// Whether an agent carries sensors: it is controllable, or decided for from outside.
bool HasSensors(const AgentSnapshot& agent);

// What sensors meet of a state, as it is at that moment: falling trees as they fall. Steps and time
// are those of the episode, so that an episode is sensed alike however long the simulator ran
// before. catalogue: of the simulator; an agent of a species that it does not have is as large as
// its category's own.
SensedWorld Sensed(const WorldState& state, const SpeciesCatalogue& catalogue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SENSED_H_
