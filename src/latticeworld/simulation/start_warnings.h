#ifndef LATTICEWORLD_SIMULATION_START_WARNINGS_H_
#define LATTICEWORLD_SIMULATION_START_WARNINGS_H_

#include <string>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

// A sentence for each agent of the scene that is of a larger species than the scene was made for
// and had no room at its start: where it begins in its place. state: at the start of an episode.
std::vector<std::string> StartWarnings(const Scene& scene, const WorldState& state,
                                       const SpeciesCatalogue& catalogue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_START_WARNINGS_H_
