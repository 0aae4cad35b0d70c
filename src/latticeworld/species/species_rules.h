#ifndef LATTICEWORLD_SPECIES_SPECIES_RULES_H_
#define LATTICEWORLD_SPECIES_SPECIES_RULES_H_

#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// Adds what is wrong between the values of a species, each of which is legal by itself: a plan that
// its category does not have, a design that is missing or not its own, a body that could not stand.
void CheckSpecies(const Species& species, const std::string& pointer,
                  std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SPECIES_SPECIES_RULES_H_
