#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_WAY_SLOPES_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_WAY_SLOPES_H_

#include <string>
#include <string_view>

#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// A text without the slopes that it says of ways ("of 15 degrees"), of which ReadRelief reads:
// rules for land would take their numbers for those of ways.
std::string WithoutWaySlopes(std::string_view text, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_WAY_SLOPES_H_
