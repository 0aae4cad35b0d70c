#ifndef LATTICEWORLD_LANGUAGE_READING_FOREIGN_TEXT_H_
#define LATTICEWORLD_LANGUAGE_READING_FOREIGN_TEXT_H_

#include <string_view>

namespace latticeworld {

// Whether a text seems to be of another language: hardly any of its words, of four or more, is a
// common English one or a noun of land.
bool SeemsForeign(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_FOREIGN_TEXT_H_
