#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_COARSE_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_COARSE_READER_H_

#include <vector>

#include "latticeworld/language/grounded/environment/attributes/measure_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// Reads what is said and given away of terrain, season, style, weather and time of day into
// heard->coarse. What is said outright counts over hints, and of two statements the later one,
// with a warning. Agents and fine attributes must have been read: their tokens are no hints.
void ReadCoarse(const EnvironmentWords& words, const std::vector<HeardMeasure>& measures,
                NotedTokens* noted, HeardEnvironment* heard);

// The time of day at an hour of [0, 24).
TimeOfDay TimeAt(double hour);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_COARSE_READER_H_
