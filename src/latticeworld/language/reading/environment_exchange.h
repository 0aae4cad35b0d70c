#ifndef LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_EXCHANGE_H_
#define LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_EXCHANGE_H_

#include <set>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Makes one reading of an environment of two. `reading` gets what only `second` says, and in these
// parts what `second` says in the place of its own, which `second` then has. Its sentences, its
// coverage, its warnings and what was not understood are those of what it then says. Agents are all
// of one reading. A value that is only hinted at, or only ruled out, takes no other's place. The
// layout and the catalogue of the request are not null.
void Exchange(const EnvironmentRequest& request, const std::set<ReadingPart>& parts,
              EnvironmentReading* reading, HeardEnvironment* second);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_EXCHANGE_H_
