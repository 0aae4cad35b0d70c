#ifndef LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_OF_SENTENCES_H_
#define LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_OF_SENTENCES_H_

#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"

namespace latticeworld {

// What sentences of the small language say of an environment, each wish with the sentence that it
// comes from. `not_understood` holds the sentences that no form has.
HeardEnvironment EnvironmentOfSentences(const std::vector<std::string>& sentences,
                                        const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_ENVIRONMENT_OF_SENTENCES_H_
