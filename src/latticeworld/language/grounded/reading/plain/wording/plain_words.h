#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_WORDING_PLAIN_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_WORDING_PLAIN_WORDS_H_

#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// The tokens with turns of phrase in plainer words:
// - what something owns: "the river's right bank" is "the right bank of the river";
// - comparisons of amounts: "twice as much wood as meadow" is "more wood than meadow";
// - verbs in two parts: "the road keeps the river company" is "the road follows the river";
// - places told by those that are taken: "fields in the NW and SE quadrant, forest in the other
//   two" is "... forest in the NE quadrant and SW quadrant"; the noun of such a list stands with
//   each of its places;
// - pointing outward: "beyond these the forest" is "elsewhere the forest".
// Words that are put in share the bytes of a word beside them.
std::vector<Token> WithPlainWords(std::vector<Token> tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_PLAIN_WORDING_PLAIN_WORDS_H_
