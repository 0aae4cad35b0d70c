#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_COUNT_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_COUNT_READER_H_

#include <cstddef>

#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// How many, in words.
struct Count {
  int least = 0;
  int value = 0;
  int most = 0;
  std::size_t tokens = 0;  // 0: no count starts here
};

// The product, or a million where it is more: enough to say "no bound".
int CappedProduct(int a, int b);

// The count that starts at tokens[at]: "nine", "about thirty", "at least four", "between five and
// ten", "3-5", "several", "two flocks of", "a herd of a dozen". A bare article is none, nor is a
// number that is measured in something.
Count ReadCount(const NotedTokens& noted, const EnvironmentWords& words, std::size_t at);

// What "pack" counts in "a goblin pack"; no tokens: the word is no collective noun.
Count ReadCollective(const NotedTokens& noted, const EnvironmentWords& words, std::size_t at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_COUNT_READER_H_
