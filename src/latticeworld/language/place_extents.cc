#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "latticeworld/language/extents.h"
#include "latticeworld/language/place_phrases.h"

namespace latticeworld {
namespace {

// The nouns that say how much of a direction is meant. Plurals of them ask for several places.
struct ExtentNoun {
  std::string_view word;
  PlaceDepth depth;
};
constexpr ExtentNoun kExtentNouns[] = {
    {"half", PlaceDepth::kHalf},       {"halves", PlaceDepth::kHalf},
    {"third", PlaceDepth::kThird},     {"thirds", PlaceDepth::kThird},
    {"quarter", PlaceDepth::kQuarter}, {"quarters", PlaceDepth::kQuarter},
    {"fourth", PlaceDepth::kQuarter},  {"corner", PlaceDepth::kCorner},
    {"corners", PlaceDepth::kCorner},  {"edge", PlaceDepth::kEdge},
    {"edges", PlaceDepth::kEdge},      {"border", PlaceDepth::kEdge},
    {"borders", PlaceDepth::kEdge},    {"margin", PlaceDepth::kEdge},
    {"margins", PlaceDepth::kEdge},    {"boundary", PlaceDepth::kEdge},
    {"boundaries", PlaceDepth::kEdge}, {"rim", PlaceDepth::kEdge},
    {"rims", PlaceDepth::kEdge},       {"fringe", PlaceDepth::kEdge},
    {"fringes", PlaceDepth::kEdge},    {"outskirts", PlaceDepth::kEdge},
    {"limit", PlaceDepth::kEdge},      {"limits", PlaceDepth::kEdge},
    {"extremity", PlaceDepth::kEdge},  {"frontier", PlaceDepth::kEdge},
    {"shore", PlaceDepth::kEdge},      {"coast", PlaceDepth::kEdge},
    {"strip", PlaceDepth::kEdge},      {"stripe", PlaceDepth::kEdge},
    {"perimeter", PlaceDepth::kEdge},  {"band", PlaceDepth::kBand},
    {"belt", PlaceDepth::kBand},       {"bands", PlaceDepth::kBand},
    {"row", PlaceDepth::kRows},        {"rows", PlaceDepth::kRows},
    {"column", PlaceDepth::kColumns},  {"columns", PlaceDepth::kColumns},
    {"side", PlaceDepth::kSide},       {"sides", PlaceDepth::kSide},
    {"flank", PlaceDepth::kSide},      {"flanks", PlaceDepth::kSide},
    {"end", PlaceDepth::kSide},        {"ends", PlaceDepth::kSide},
    {"part", PlaceDepth::kUnsaid},     {"parts", PlaceDepth::kUnsaid},
    {"area", PlaceDepth::kUnsaid},     {"areas", PlaceDepth::kUnsaid},
    {"region", PlaceDepth::kUnsaid},   {"regions", PlaceDepth::kUnsaid},
    {"section", PlaceDepth::kUnsaid},  {"sections", PlaceDepth::kUnsaid},
    {"portion", PlaceDepth::kUnsaid},  {"portions", PlaceDepth::kUnsaid},
    {"zone", PlaceDepth::kUnsaid},     {"zones", PlaceDepth::kUnsaid},
    {"sector", PlaceDepth::kUnsaid},   {"sectors", PlaceDepth::kUnsaid},
    {"segment", PlaceDepth::kUnsaid},  {"bit", PlaceDepth::kUnsaid},
    {"reaches", PlaceDepth::kUnsaid},  {"stretches", PlaceDepth::kUnsaid},
    {"parcel", PlaceDepth::kUnsaid},   {"block", PlaceDepth::kUnsaid},
    {"square", PlaceDepth::kUnsaid},   {"ninth", PlaceDepth::kUnsaid},
    {"tip", PlaceDepth::kEdge},        {"lands", PlaceDepth::kUnsaid},
    {"land", PlaceDepth::kUnsaid},     {"spot", PlaceDepth::kUnsaid},
};

const ExtentNoun* FindExtentNoun(std::string_view word) {
  if (word.empty()) return nullptr;
  for (const ExtentNoun& noun : kExtentNouns) {
    if (noun.word == word) return &noun;
  }
  return nullptr;
}

}  // namespace

bool IsPluralOfPlace(std::string_view word) {
  return IsOneOf(word, {"halves",   "thirds",     "quarters", "corners", "edges",    "borders",
                        "margins",  "boundaries", "rims",     "fringes", "limits",   "sides",
                        "flanks",   "ends",       "parts",    "areas",   "regions",  "sections",
                        "portions", "zones",      "sectors",  "bands",   "quadrants"});
}

PlaceExtent TakeExtent(const Direction& direction, PlaceCursor* cursor) {
  PlaceExtent extent;
  // "the lower two thirds", "the top 20 %": but "third" alone is a noun below.
  const std::vector<Token>& tokens = cursor->tokens();
  if (const ShareMatch share = MatchShare(tokens, cursor->at());
      share.fraction && share.tokens > (share.of ? 2u : 1u)) {
    cursor->Skip(share.tokens - (share.of ? 1 : 0));
    const double fraction = std::clamp(share.value, 1.0 / 32.0, 1.0);
    for (const auto& [depth, value] : {std::pair<PlaceDepth, double>{PlaceDepth::kHalf, 0.5},
                                       {PlaceDepth::kThird, 1.0 / 3.0},
                                       {PlaceDepth::kQuarter, 0.25}}) {
      if (std::abs(fraction - value) < 1e-9) return {depth};
    }
    return {PlaceDepth::kFraction, fraction, share.name};
  }
  // "the top five rows" of a layout's 32.
  constexpr double kRows = 32.0;
  if (const CountMatch count = MatchCount(tokens, cursor->at()); count.tokens > 0) {
    const std::string_view unit = cursor->word(count.tokens);
    if (IsOneOf(unit, {"row", "rows", "column", "columns", "cells", "lines"})) {
      cursor->Skip(count.tokens + 1);
      const int rows = std::min(count.most, std::max(count.least, 3));
      const std::string name = std::to_string(rows) + " " + std::string(unit);
      const bool side = direction.heading.east != 0 || direction.heading.south != 0;
      const double fraction = std::min(1.0, rows / kRows);
      if (side) return {PlaceDepth::kFraction, fraction, name};
      return {unit == "columns" || unit == "column" ? PlaceDepth::kColumns : PlaceDepth::kRows};
    }
  }
  // "the middle horizontal band", "the central vertical strip"
  if (cursor->Take({"horizontal"})) {
    cursor->Take({"band", "strip", "third", "stripe", "belt", "rows", "row", "part"});
    return {PlaceDepth::kRows};
  }
  if (cursor->Take({"vertical"})) {
    cursor->Take({"band", "strip", "third", "stripe", "belt", "columns", "column", "part"});
    return {PlaceDepth::kColumns};
  }
  cursor->Take({"outer", "outermost"});
  // "the northern city limit"
  if (IsOneOf(cursor->word(), {"city", "town", "property", "site", "village", "map"}) &&
      IsOneOf(cursor->word(1), {"limit", "limits", "boundary", "border", "edge"})) {
    cursor->Skip(1);
  }
  // A noun gives the depth: "quarter", "edge", "corner".
  if (cursor->Take({"quadrant", "quadrants"})) {
    extent.depth = direction.heading.IsDiagonal() ? PlaceDepth::kQuarter : PlaceDepth::kUnsaid;
  } else if (const ExtentNoun* noun = FindExtentNoun(cursor->word())) {
    cursor->Skip(1);
    extent.depth = noun->depth;
  }
  return extent;
}

}  // namespace latticeworld
