#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_WORDS_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_WORDS_H_

#include <optional>
#include <string_view>

#include "latticeworld/layout/relief_wish.h"

namespace latticeworld {

// Returns the kind of relief that a word in the singular names ("hill", "hilly"), by
// data/relief_words.txt; nullopt where it names none.
std::optional<ReliefKind> ReliefOfWord(std::string_view word);

// Returns the kind of relief that a noun phrase in the singular names ("snow mountain", "mountain
// range"); nullopt where it names none.
std::optional<ReliefKind> ReliefOfNoun(std::string_view phrase);

// Returns whether the word means land as a whole: "terrain".
bool IsLandWord(std::string_view word);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_WORDS_H_
