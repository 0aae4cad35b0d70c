#ifndef LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_ENVIRONMENT_ENVIRONMENT_COUNTRY_H_
#define LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_ENVIRONMENT_ENVIRONMENT_COUNTRY_H_

#include <string>

#include "latticeworld/language/generator.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// Grassland; a lake in the upper left, forest in the lower right, a village in the center, a road
// along the west edge, fields in the upper right.
SymbolicLayout Country();

// What the grounded back end answers there.
EnvironmentAnswer GenerateInCountry(const std::string& instruction, double size_m = 512.0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LANGUAGE_GROUNDED_ENVIRONMENT_ENVIRONMENT_COUNTRY_H_
