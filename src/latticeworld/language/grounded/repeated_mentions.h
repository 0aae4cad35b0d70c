#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_REPEATED_MENTIONS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_REPEATED_MENTIONS_H_

#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/mention.h"

namespace latticeworld {

// For each mention the index of the first one that says the same of the same thing in the same
// words; its own where it says something new.
std::vector<int> FirstOfRepeated(const std::vector<Mention>& mentions,
                                 std::string_view instruction);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_REPEATED_MENTIONS_H_
