#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"
#include "latticeworld/layout/symbolic_layout.h"

// What is measured in cells of the map, or in metres, and is no number of things.
namespace latticeworld {
namespace {

bool IsCell(std::string_view word) {
  return IsOneOf(word, {"cell", "cells", "tile", "tiles", "pixel", "pixels", "grid"});
}
bool IsLength(std::string_view word) {
  return IsOneOf(word, {"metre", "metres", "meter", "meters", "m", "km", "kilometre", "kilometres",
                        "kilometer", "kilometers", "feet", "foot", "ft", "yards", "yard"});
}
bool IsExtent(std::string_view word) {
  return IsOneOf(word, {"wide", "across", "long", "deep", "thick", "broad", "tall", "high"});
}

// "5 cells wide", "20 m across", "10 by 12 cells", "10 cells in diameter".
struct Span {
  std::size_t last = 0;  // the token behind it; 0: nothing of the kind
  int across = 0;        // cells; 0: it says nothing of an area
  int along = 0;
};

Span SpanAt(const std::vector<Token>& tokens, std::size_t at) {
  const NumberMatch first = MatchNumber(tokens, at);
  if (first.tokens == 0 || first.value < 1) return {};
  std::size_t next = at + first.tokens;
  Span span{0, first.value, first.value};
  bool area = false;
  // "two or three cells", "5 to 10 m"
  if (IsOneOf(WordAt(tokens, next), {"or", "to"}) && MatchNumber(tokens, next + 1).tokens > 0)
    next += 1 + MatchNumber(tokens, next + 1).tokens;
  if (IsOneOf(WordAt(tokens, next), {"by", "x"})) {
    const NumberMatch second = MatchNumber(tokens, next + 1);
    if (second.tokens == 0) return {};
    span.along = second.value;
    next += 1 + second.tokens;
    area = true;
  }
  const bool cells = IsCell(WordAt(tokens, next));
  if (!cells && !IsLength(WordAt(tokens, next))) return {};
  ++next;
  if (WordAt(tokens, next) == "in" && IsOneOf(WordAt(tokens, next + 1), {"diameter", "size"})) {
    next += 2;
    area = true;
  } else if (WordAt(tokens, next) == "in" &&
             IsOneOf(WordAt(tokens, next + 1), {"width", "length"})) {
    next += 2;
  } else if (IsExtent(WordAt(tokens, next))) {
    area = area || WordAt(tokens, next) == "across";
    ++next;
  } else if (!area) {
    return {};
  }
  span.last = next;
  if (!cells || !area) span.across = span.along = 0;
  return span;
}

// The class word that ends before `at`, or before the comma there.
ClassWordMatch NounBefore(const std::vector<Token>& tokens, std::size_t at) {
  if (at > 0 && tokens[at - 1].kind == TokenKind::kComma) --at;
  constexpr std::size_t kLongest = 3;
  for (std::size_t length = std::min(kLongest, at); length > 0; --length) {
    const ClassWordMatch match = MatchClassWord(tokens, at - length);
    if (match.word != nullptr && match.tokens == length) return match;
  }
  return {};
}

}  // namespace

void TurnSpans(std::vector<Token>* tokens) {
  constexpr double kRound = 0.785;  // of the square that a round thing fills
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const Span span = SpanAt(*tokens, at);
    if (span.last == 0) continue;
    std::size_t first = at;
    const bool about =
        first > 0 && IsOneOf(WordAt(*tokens, first - 1),
                             {"about", "around", "roughly", "approximately", "some"});
    if (about) --first;
    if (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"of", "measuring"})) --first;
    const ClassWordMatch noun = NounBefore(*tokens, first);
    const int percent =
        static_cast<int>(std::lround(100.0 * kRound * span.across * span.along /
                                     static_cast<double>(kLayoutSize * kLayoutSize)));
    const bool sized = noun.word != nullptr && !noun.plural &&
                       noun.word->shape != WordShape::kLine && percent >= 2 && percent <= 90;
    const Token beside = (*tokens)[first];
    EraseTokens(tokens, first, span.last - first);
    if (sized) {
      std::vector<Token> said = {
          WordLike("covering", beside),
          WordLike("about", beside),
          {TokenKind::kNumber, std::to_string(percent), beside.begin, beside.end}};
      for (const std::string_view word : {"percent", "of", "the", "map"})
        said.push_back(WordLike(word, beside));
      InsertTokens(tokens, first, said);
    } else if (first > 0 && first < tokens->size() &&
               (*tokens)[first - 1].kind == TokenKind::kComma && IsPauseAt(*tokens, first)) {
      EraseTokens(tokens, first - 1, 1);
    }
    at = first > 0 ? first - 1 : 0;
  }
}

}  // namespace latticeworld
