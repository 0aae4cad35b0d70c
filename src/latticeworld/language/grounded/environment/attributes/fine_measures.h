#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_MEASURES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_MEASURES_H_

#include <vector>

#include "latticeworld/language/grounded/environment/attributes/measure_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// Reads what measures ("18 m/s", "40 %", "twice its size") say of asset types, and takes those out
// of `measures`.
void ReadFineMeasures(const EnvironmentWords& words, std::vector<HeardMeasure>* measures,
                      NotedTokens* noted, HeardEnvironment* heard);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_MEASURES_H_
