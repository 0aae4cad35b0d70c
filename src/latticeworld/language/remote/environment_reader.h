#ifndef LATTICEWORLD_LANGUAGE_REMOTE_ENVIRONMENT_READER_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_ENVIRONMENT_READER_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {

// Reads the environment of a whole answer: the JSON object in it, with thinking, prose and Markdown
// fences around. If there are several objects, the last legal one counts, or without one the
// longest (of equally long ones the last). The object itself is read strictly. Errors:
// INVALID_ARGUMENT with every violation, as ParseEnvironment gives them, or no_object when the
// answer holds nothing like an object.
Result<EnvironmentConfig> ReadEnvironmentAnswer(std::string_view text,
                                                const Catalogue& catalogue = *Catalogue::BuiltIn());
// Does the same, and makes legal what only the rules forbid (KeepToRules). It appends what was
// changed to *changes.
Result<EnvironmentConfig> ReadMendedEnvironmentAnswer(std::string_view text,
                                                      const Catalogue& catalogue,
                                                      std::vector<std::string>* changes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_ENVIRONMENT_READER_H_
