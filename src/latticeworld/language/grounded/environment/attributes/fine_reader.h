#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_READER_H_

#include <vector>

#include "latticeworld/language/grounded/environment/attributes/measure_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// Reads densities, variants, materials and continuous parameters into heard->fine: adjectives
// before a noun ("dense, mossy forest") or said of it ("the forest is dense"), names that say it by
// themselves ("poppies"), and measures ("wind of 12 m/s"). If two wishes are for the same property,
// the later counts. Measures that are used are removed from `measures`.
void ReadFine(const EnvironmentWords& words, std::vector<HeardMeasure>* measures,
              NotedTokens* noted, HeardEnvironment* heard);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_READER_H_
