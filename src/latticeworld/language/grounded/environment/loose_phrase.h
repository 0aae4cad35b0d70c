#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_LOOSE_PHRASE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_LOOSE_PHRASE_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// The longest phrase of a table that starts at a token, whether or not small words stand within:
// "the sun was just setting" is "sun setting". is_filler(at): whether the token is a small word.
template <typename Entry, typename IsFiller>
typename WordTable<Entry>::Match LoosePhraseAt(const WordTable<Entry>& table,
                                               const NotedTokens& noted, std::size_t at,
                                               IsFiller is_filler) {
  constexpr std::size_t kTokens = 6;  // of a phrase, not counting small words
  const auto exact = table.At(noted.tokens, at);
  if (noted.IsPause(at) || is_filler(at)) return exact;
  std::vector<Token> heavy;
  std::vector<std::size_t> ends;
  for (std::size_t i = at; !noted.IsPause(i) && heavy.size() < kTokens; ++i) {
    if (is_filler(i)) continue;
    heavy.push_back(noted.tokens[i]);
    ends.push_back(i + 1 - at);
  }
  auto loose = table.At(heavy, 0);
  if (loose.tokens < 2 || ends[loose.tokens - 1] <= exact.tokens) return exact;
  loose.tokens = ends[loose.tokens - 1];
  return loose;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_LOOSE_PHRASE_H_
