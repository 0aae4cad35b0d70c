#ifndef LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_OF_SENTENCES_H_
#define LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_OF_SENTENCES_H_

#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"

namespace latticeworld {

// Returns what sentences of the small language say of an environment. Each wish keeps the sentence
// that it comes from. `not_understood` of the result holds the sentences that fit no form.
HeardEnvironment EnvironmentOfSentences(const std::vector<std::string>& sentences,
                                        const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_OF_SENTENCES_H_
