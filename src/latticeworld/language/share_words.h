#ifndef LATTICEWORLD_LANGUAGE_SHARE_WORDS_H_
#define LATTICEWORLD_LANGUAGE_SHARE_WORDS_H_

#include "latticeworld/language/phrase_table.h"

// This header is for shares.cc only. It has the words of shares of the land that are no numbers.
namespace latticeworld {

// The least share of a thing that is there at all.
inline constexpr double kLeastShareThere = 0.002;

// What is meant by words such as "most of", and what a reader accepts for them.
struct ShareAmount {
  double value;
  double least;
  double most;
  bool mostly = false;   // says dominance rather than a number
  bool of_mass = false;  // of what is counted it says how many: "lots of houses"
};
const PhraseTable<ShareAmount>& AmountWords();

// What the words before or after a number of a share make of its bounds.
enum class ShareBend { kAbout, kAtLeast, kAtMost, kNearly, kMore, kLess, kExactly };
// "about", "at least": before the number.
const PhraseTable<ShareBend>& BendWords();
// "or more": after it, as in "70 % or more".
const PhraseTable<ShareBend>& BendWordsAfter();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SHARE_WORDS_H_
