#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ENVIRONMENT_PARSER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ENVIRONMENT_PARSER_H_

#include <string_view>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"

namespace latticeworld {

// What an environment instruction says. Any UTF-8 text gives a reading; what it cannot read is kept
// in not_understood. Values that the catalogue adds are known by their names.
HeardEnvironment ParseEnvironmentInstruction(std::string_view instruction,
                                             const Catalogue& catalogue = *Catalogue::BuiltIn());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ENVIRONMENT_PARSER_H_
