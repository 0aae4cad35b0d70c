#ifndef LATTICEWORLD_LANGUAGE_REMOTE_ENVIRONMENT_READER_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_ENVIRONMENT_READER_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {

// The environment of a whole answer: the JSON object in it, with thinking, prose and Markdown
// fences around. Of several objects the last legal one counts, or without one the longest (of
// equally long ones the last). The object itself is read strictly. Errors: INVALID_ARGUMENT with
// every violation, as ParseEnvironment gives them, or no_object when there is nothing like one.
Result<EnvironmentConfig> ReadEnvironmentAnswer(std::string_view text,
                                                const Catalogue& catalogue = *Catalogue::BuiltIn());
// The same, with what only the rules forbid made legal (KeepToRules); `changes`: what was changed.
Result<EnvironmentConfig> ReadMendedEnvironmentAnswer(std::string_view text,
                                                      const Catalogue& catalogue,
                                                      std::vector<std::string>* changes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_ENVIRONMENT_READER_H_
