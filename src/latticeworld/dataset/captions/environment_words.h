#ifndef LATTICEWORLD_DATASET_CAPTIONS_ENVIRONMENT_WORDS_H_
#define LATTICEWORLD_DATASET_CAPTIONS_ENVIRONMENT_WORDS_H_

#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/dataset/captions/phrase_book.h"
#include "latticeworld/dataset/sources/environment_sample.h"

namespace latticeworld {

// An instruction that asks for the environment: season, time of day, weather, style, what is
// unusual of its fine values, and all agents with number, state and place. What is left out is what
// comes without words: summer, day, sunny weather, realistic style.
std::string WordEnvironment(const SampledEnvironment& sample, Voice voice, bool picture,
                            RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_ENVIRONMENT_WORDS_H_
