#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_WORDS_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What the words that are neither classes nor places mean for a layout.
enum class LayoutWord {
  kNone,
  kFunction,   // "the", "of", "there"
  kAnd,        // "and", "or"
  kBreak,      // begins a new clause: "with", "but", "while", "there is"
  kMostly,     // "mostly", "dominated by"
  kCovers,     // "covers", "dominates", "covered with"
  kMore,       // "more", "vast", "dense"
  kLess,       // "small", "sparse"
  kFew,        // "a few", "some scattered"
  kMany,       // "many", "numerous"
  kSeveral,    // "several"
  kScattered,  // "scattered", "dotted with"
  kClustered,  // "clustered", "in one piece"
  kNo,         // "no", "without"
  kTreeless,   // a negation that names its class itself
  kRoadless,
  kWaterless,
  kUninhabited,
  kRest,          // "the rest", "everything else"
  kMoreThan,      // "more" (forest than ...)
  kLessThan,      // "less" (forest than ...)
  kNextTo,        // "next to", "near", "borders"
  kSurroundedBy,  // "surrounded by", "in the middle of"
  kSurrounds,     // "surrounds", "around"
  kBetween,
  kRuns,         // "runs", "flows", "crosses"
  kFrom,         // "from", "enters"
  kTo,           // "to", "towards", "leaves"
  kThrough,      // "through", "via"
  kConnects,     // "connects", "links"
  kConnectedBy,  // "connected by" a road
  kWinds,        // "winds", "meanders": runs, and winding
  kWinding,
  kStraight,
  kHorizontal,
  kVertical,
  kDiagonal,
  kEverywhere,  // "everywhere", "throughout"
  kHeights,     // "hilly": said of the relief, not of the layout
};

struct LayoutWordMatch {
  LayoutWord word = LayoutWord::kNone;
  std::size_t tokens = 0;
};

// The longest such phrase that starts at tokens[at].
LayoutWordMatch MatchLayoutWord(const std::vector<Token>& tokens, std::size_t at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_LAYOUT_WORDS_H_
