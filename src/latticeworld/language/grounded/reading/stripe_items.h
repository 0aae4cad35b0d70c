#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_STRIPE_ITEMS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_STRIPE_ITEMS_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/places.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// "stripe", "bands", "column", "row" ...: what a map is cut into.
bool IsStripeNoun(std::string_view word);

// One of numbered parts of the map with what it holds: "the second stripe is grass", "band three:
// fields", "the leftmost column (woods)".
struct StripeItem {
  static constexpr int kNext = -1;  // "the next one"
  static constexpr int kLast = -2;

  int nth = 0;            // 1 ..; kNext, kLast; 0: told by its side alone
  bool sided = false;     // "the top one", "the first from the left"
  Heading side;           // of it; (0, 0): the middle one
  bool noun = false;      // a word for a part of the map was said
  bool numbered = false;  // by a number behind the noun: "band three"
  int parts = 0;          // "the second third": of three
  std::size_t begin = 0;  // tokens [begin, body) tell which, [body, end) what it holds
  std::size_t body = 0;
  std::size_t end = 0;
};

// The item that starts at tokens[at], after `before` (nullptr: it is the first). `declared`: the
// instruction speaks of stripes, so that "the top one" may be one. False: none starts here.
bool TakeStripeItem(const std::vector<Token>& tokens, std::size_t at, const StripeItem* before,
                    bool declared, StripeItem* item);

// Whether a class is named within the next few words, before any pause.
bool ClassSoon(const std::vector<Token>& tokens, std::size_t at, std::size_t words);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_STRIPE_ITEMS_H_
