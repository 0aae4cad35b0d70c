#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_WORDS_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_WORDS_H_

#include <optional>
#include <string_view>

#include "latticeworld/layout/relief_wish.h"

namespace latticeworld {

// The kind of relief that a word in the singular names: "hill", "hilly"; data/relief_words.txt.
std::optional<ReliefKind> ReliefOfWord(std::string_view word);

// The kind that a noun phrase in the singular names: "snow mountain", "mountain range".
std::optional<ReliefKind> ReliefOfNoun(std::string_view phrase);

// Whether the word means land as a whole: "terrain".
bool IsLandWord(std::string_view word);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_WORDS_H_
