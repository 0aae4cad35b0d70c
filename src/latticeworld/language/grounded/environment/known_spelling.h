#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_KNOWN_SPELLING_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_KNOWN_SPELLING_H_

#include <string_view>

namespace latticeworld {

// The word of the environment's tables that a slip of the pen stands for ("mornign": "morning"), or
// "" when the word is known, here or as common English, or no single word is near enough.
std::string_view MendedWord(std::string_view word);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_KNOWN_SPELLING_H_
