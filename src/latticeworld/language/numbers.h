#ifndef LATTICEWORLD_LANGUAGE_NUMBERS_H_
#define LATTICEWORLD_LANGUAGE_NUMBERS_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

struct NumberMatch {
  int value = 0;
  std::size_t tokens = 0;  // 0: no number starts here
};

// A count that starts at tokens[at]: "9", "forty-two", "a hundred", "two hundred and five", "a pair
// of", "half a dozen", "three dozen". Values above a million are cut to a million; a fraction is
// rounded down.
NumberMatch MatchNumber(const std::vector<Token>& tokens, std::size_t at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_NUMBERS_H_
