#include "latticeworld/language/grounded/reading/stripes.h"

#include <string_view>

#include "latticeworld/language/grounded/reading/band_words.h"
#include "latticeworld/language/grounded/reading/stripe_items.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsNone(Heading heading) { return heading.east == 0 && heading.south == 0; }

// "stripes of equal width", "equally wide", "each a quarter of the width"
bool SaysEqual(const std::vector<Token>& tokens) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const std::string_view word = WordAt(tokens, at);
    if (IsOneOf(word, {"equal", "equally", "equal-sized"})) return true;
    if (word == "same" && IsOneOf(WordAt(tokens, at + 1), {"width", "height", "size", "breadth"})) {
      return true;
    }
    if (word != "each") continue;
    for (std::size_t i = at + 1; i < at + 6 && !IsPauseAt(tokens, i); ++i) {
      const bool part = IsOneOf(WordAt(tokens, i), {"third", "quarter", "fifth", "half"});
      if (part && IsOneOf(WordAt(tokens, i - 1), {"a", "one"})) return true;
    }
  }
  return false;
}

}  // namespace

void FindWay(const std::vector<Token>& tokens, std::size_t begin, std::size_t end,
             Stripes* stripes) {
  for (std::size_t at = begin; at < end && IsNone(stripes->way); ++at) {
    const std::string_view word = WordAt(tokens, at);
    const AxisMatch axis = MatchAxis(tokens, at);
    if (axis.tokens > 0) {
      std::size_t first = at;
      while (first > begin && IsOneOf(WordAt(tokens, first - 1), {"from", "the", "in", "order"})) {
        --first;
      }
      // Stripes that run from north to south lie side by side.
      const bool along = IsOneOf(WordAt(tokens, first - 1), {"running", "run", "runs", "stretching",
                                                             "extending", "stretch", "oriented"}) ||
                         axis.tokens == 2;
      if (along) {
        stripes->usual = axis.to.east != 0 ? Heading{0, 1} : Heading{1, 0};
        continue;
      }
      if (axis.to.IsDiagonal()) continue;
      if (first > begin && IsOneOf(WordAt(tokens, first - 1), {"going", "reading", "moving"})) {
        --first;
      }
      stripes->way = axis.to;
      stripes->way_begin = first;
      stripes->way_end = at + axis.tokens;
      return;
    }
    // "counted from the top", "from the west: ..."
    const bool starts = IsOneOf(word, {"counted", "counting", "starting", "beginning", "reading"});
    std::size_t from = at + (starts ? 1 : 0);
    const bool bare = WordAt(tokens, from) == "from" ||
                      (starts && IsOneOf(WordAt(tokens, from), {"at", "in", "on", "with"}));
    if (bare) {
      ++from;
      if (WordAt(tokens, from) == "the") ++from;
      PlaceCursor cursor(tokens, from);
      const Direction side = TakeDirection(&cursor);
      std::size_t next = cursor.at();
      if (IsOneOf(WordAt(tokens, next), {"side", "edge", "end"})) ++next;
      if (side.found && !side.heading.IsDiagonal() && !IsNone(side.heading) &&
          (starts || IsPauseAt(tokens, next))) {
        stripes->way = {-side.heading.east, -side.heading.south};
        stripes->way_begin = at;
        stripes->way_end = next;
        return;
      }
    }
    const bool goes = IsOneOf(word, {"going", "moving", "walking", "heading"});
    if (goes && IsOneOf(WordAt(tokens, at + 1), {"down", "up"})) {
      stripes->way = {0, WordAt(tokens, at + 1) == "down" ? 1 : -1};
      stripes->way_begin = at;
      stripes->way_end = at + 2;
    }
    if (IsOneOf(word, {"vertical", "vertically", "upright"}) ||
        (word == "side" && WordAt(tokens, at + 1) == "by")) {
      stripes->usual = {1, 0};
    }
    if (IsOneOf(word, {"horizontal", "horizontally", "stacked", "across"})) stripes->usual = {0, 1};
  }
}

Stripes FindStripes(const std::vector<Token>& tokens) {
  constexpr std::size_t kReach = 4;  // words between the number and the noun
  Stripes stripes;
  for (std::size_t at = 0; at < tokens.size() && !stripes.said; ++at) {
    const std::string_view word = WordAt(tokens, at);
    const bool parts = IsOneOf(word, {"thirds", "quarters", "fifths"});
    if (!parts && !(IsStripeNoun(word) && Singular(word) != word)) continue;
    int count = word == "thirds" ? 3 : word == "quarters" ? 4 : word == "fifths" ? 5 : 0;
    bool laid = false;
    for (std::size_t i = at; i > 0 && i + kReach >= at && !IsPauseAt(tokens, i - 1); --i) {
      laid =
          laid || IsOneOf(WordAt(tokens, i - 1), {"horizontal", "vertical", "equal", "parallel"});
      const NumberMatch number = MatchNumber(tokens, i - 1);
      if (number.tokens == 0 || parts) continue;
      count = number.value;
      break;
    }
    const bool weak = IsOneOf(word, {"parts", "sections", "zones", "steps"});
    if (parts && !laid) continue;
    if (!parts && count < 2 && (weak || !laid)) continue;
    if (count > Band::kMost) continue;
    stripes.said = true;
    stripes.count = count;
    stripes.noun = at;
    stripes.usual = IsOneOf(word, {"columns", "stripes", "strips", "panels", "slices"})
                        ? Heading{1, 0}
                        : Heading{0, 1};
  }
  stripes.equal = SaysEqual(tokens);
  // "From left to right: houses, fields, wood. Equal widths."
  for (std::size_t at = 0; at < tokens.size() && stripes.equal && !stripes.said; ++at) {
    if (at > 0 && !IsStopAt(tokens, at - 1)) continue;
    const std::size_t from = at + (WordAt(tokens, at) == "from" ? 1 : 0);
    const AxisMatch axis = MatchAxis(tokens, from);
    if (axis.tokens < 3 || axis.to.IsDiagonal()) continue;
    stripes.said = true;
    stripes.noun = from + axis.tokens - 1;
    stripes.way = axis.to;
  }
  return stripes;
}

}  // namespace latticeworld
