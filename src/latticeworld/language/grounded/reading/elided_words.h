#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_ELIDED_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_ELIDED_WORDS_H_

#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// The tokens with the words that writers leave out, each beside the words it belongs to:
// - the noun of a place that stood before: "the left half is forest, the right [half] town", "from
//   the top edge to the bottom one [edge]", "on the northern bank ..., on the southern [bank]";
// - "percent" after the numbers of a list that gives shares: "forest 60, water 30, rock 10";
// - the places of a list that goes round the map: "clockwise from the top left: rock, snow, ...".
// Words that are put in share the bytes of the word before them.
std::vector<Token> WithElidedWords(std::vector<Token> tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_ELIDED_WORDS_H_
