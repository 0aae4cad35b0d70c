#ifndef LATTICEWORLD_LANGUAGE_READING_TEXT_WARNINGS_H_
#define LATTICEWORLD_LANGUAGE_READING_TEXT_WARNINGS_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// Puts before the warnings what is to be said of a text whoever reads it. One warning says that the
// text seems to be of another language: hardly any of its words of four or more letters is a common
// English one or one that the program knows. Another, of land, says that the text asks for more
// than the whole ("forest covers 300 %").
void WarnOfText(std::string_view text, SentenceKind kind, std::vector<std::string>* warnings);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_TEXT_WARNINGS_H_
