#ifndef LATTICEWORLD_LANGUAGE_EXTENTS_H_
#define LATTICEWORLD_LANGUAGE_EXTENTS_H_

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// A share of the land in words.
struct ShareMatch {
  double value = 0.0;  // what is meant: "half" is 0.5, "most of" 0.65
  double least = 0.0;  // what a reader accepts for it: "half" is 0.4 .. 0.6
  double most = 1.0;   //
  bool mostly =
      false;  // says dominance rather than a number: "most of", "the bulk of", "the majority of"
  bool fraction = false;   // a number was said: "a third", "30 %", "one in five"
  bool ordinal = false;    // may also count: "the third", "a fifth" with no "of" after it
  bool of = false;         // "of" was among the words
  std::string name;        // of a fraction: "two thirds", "30 %"
  std::size_t tokens = 0;  // 0: no share starts here
};

// The share that starts at tokens[at]: "half", "a third of", "about two thirds", "30 percent",
// "20 to 30 %", "one in five", "at least a quarter of", "most of", "nearly all of", "the bulk
// of", "a bit of", "hardly any", "a sliver of"; "lots of forest" and "a little water", but not
// "lots of houses" and "a little lake".
ShareMatch MatchShare(const std::vector<Token>& tokens, std::size_t at);

// A size in words.
struct SizeMatch {
  double factor = 1.0;       // of the natural size of a piece: "tiny" 0.25, "vast" 3
  double least_share = 0.0;  // of the map, for what covers land: "large" and "vast" 0.08
  double width = 1.0;        // of a line: "narrow" 0.5, "wide" 2
  std::size_t tokens = 0;    // 0: no size starts here
};

// The size that starts at tokens[at]: "large", "very small", "medium-sized", "a bit bigger"
// (without its article), "good sized", "wide".
SizeMatch MatchSize(const std::vector<Token>& tokens, std::size_t at);

// How many there are, in words.
struct CountMatch {
  static constexpr int kUnbounded = std::numeric_limits<int>::max();
  int least = 0;
  int most = kUnbounded;
  std::size_t tokens = 0;  // 0: no count starts here
};

// The count that starts at tokens[at]: "7", "forty-two", "a dozen", "a couple of", "twin",
// "several", "a few", "many", "a single", "only one", "two or three", "3-4", "at least five", "up
// to four", "three or more", "between two and five". A bare article is no count. A share ("30 %",
// "half of") is none either.
CountMatch MatchCount(const std::vector<Token>& tokens, std::size_t at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_EXTENTS_H_
