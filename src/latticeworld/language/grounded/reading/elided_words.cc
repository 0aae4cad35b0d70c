#include "latticeworld/language/grounded/reading/elided_words.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"

namespace latticeworld {
namespace {

bool IsStop(const std::vector<Token>& tokens, std::size_t at) {
  return at >= tokens.size() || tokens[at].kind == TokenKind::kStop;
}

bool IsPause(const std::vector<Token>& tokens, std::size_t at) {
  return IsStop(tokens, at) || tokens[at].kind == TokenKind::kComma;
}

std::string_view WordAt(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord
             ? std::string_view(tokens[at].text)
             : std::string_view();
}

// A word that is put in after `before`.
Token Added(std::string_view word, const Token& before) {
  return {TokenKind::kWord, std::string(word), before.end, before.end};
}

// "northern", "upper": only before a noun, so that one is left out where none follows.
bool IsAdjective(std::string_view word) {
  return word == "upper" || word == "lower" ||
         (word.size() > 6 && word.substr(word.size() - 3) == "ern");
}

bool IsHalfNoun(std::string_view noun) { return noun == "half" || noun == "third"; }
bool IsCornerNoun(std::string_view noun) {
  return noun == "corner" || noun == "quarter" || noun == "quadrant";
}

// The place that was named last with a noun of its own: "the western half".
struct NamedPlace {
  std::string noun;
  Heading heading;
};

// What is left out of "in the right", after `said`; empty: nothing.
std::string_view ElidedNoun(const NamedPlace& said, Heading heading, bool adjective) {
  const bool same = heading.east == said.heading.east && heading.south == said.heading.south;
  if (same || heading.IsDiagonal() != said.heading.IsDiagonal()) return {};
  const bool opposite = heading.east == -said.heading.east && heading.south == -said.heading.south;
  if (IsHalfNoun(said.noun) && opposite) return said.noun;
  if (IsCornerNoun(said.noun) && heading.IsDiagonal()) return said.noun;
  return adjective ? std::string_view(said.noun) : std::string_view();
}

bool IsCorrection(std::string_view word) {
  return IsOneOf(word, {"sorry", "no", "wait", "actually", "oops", "rather", "correction", "nope"});
}

// "the" and the like before a direction, or a preposition that needs no article.
bool OpensPlace(const std::vector<Token>& tokens, std::size_t at) {
  if (at == 0) return false;
  if (tokens[at - 1].kind == TokenKind::kComma) {
    return at >= 2 && IsCorrection(WordAt(tokens, at - 2));
  }
  return IsOneOf(WordAt(tokens, at - 1), {"the", "its", "in", "at", "on", "to"}) ||
         IsCorrection(WordAt(tokens, at - 1));
}

// A place may end before this word: it is no noun that the direction goes with.
bool MayFollowPlace(const std::vector<Token>& tokens, std::size_t at) {
  if (IsPause(tokens, at)) return true;
  return IsOneOf(
      WordAt(tokens, at),
      {"and",    "or",   "with", "while", "but",   "is",    "are",   "was",    "for",    "to",
       "has",    "have", "as",   "so",    "where", "which", "then",  "there",  "by",     "belongs",
       "should", "must", "will", "can",   "goes",  "stays", "holds", "please", "instead"});
}

// "north of", "north and south of": a direction from something, and no place.
bool IsOfSomething(const std::vector<Token>& tokens, std::size_t at) {
  while (IsOneOf(WordAt(tokens, at), {"and", "or"})) {
    ++at;
    if (WordAt(tokens, at) == "the" || WordAt(tokens, at) == "to") ++at;
    if (WordAt(tokens, at) == "the") ++at;
    PlaceCursor cursor(tokens, at);
    if (!TakeDirection(&cursor).found) return false;
    at = cursor.at();
  }
  return IsOneOf(WordAt(tokens, at), {"of", "from"});
}

std::vector<Token> WithPlaceNouns(std::vector<Token> tokens) {
  std::vector<Token> whole;
  std::optional<NamedPlace> said;
  for (std::size_t at = 0; at < tokens.size();) {
    if (IsStop(tokens, at)) {
      std::size_t next = at + 1;  // "corner ... sorry, the other": dots are stops
      while (next < tokens.size() && IsStop(tokens, next)) ++next;
      if (!IsCorrection(WordAt(tokens, next))) said.reset();
      whole.push_back(tokens[at++]);
      continue;
    }
    PlaceCursor cursor(tokens, at);
    const Direction direction = TakeDirection(&cursor);
    if (!direction.found || (direction.heading.east == 0 && direction.heading.south == 0)) {
      whole.push_back(tokens[at++]);
      continue;
    }
    const std::size_t end = cursor.at();
    const std::string_view next = WordAt(tokens, end);
    const bool opens = OpensPlace(tokens, at);
    const bool adjective = IsAdjective(WordAt(tokens, end - 1));
    for (; at < end; ++at) whole.push_back(tokens[at]);
    if (IsOneOf(next, {"half", "third", "quarter", "quadrant", "corner", "edge", "side", "border",
                       "boundary", "bank", "shore", "end", "part", "limit", "margin", "rim"})) {
      said = NamedPlace{std::string(next), direction.heading};
      continue;
    }
    if (!said.has_value() || !opens) continue;
    // "in the upper half forest, in the lower one fields"
    const bool in = whole.size() >= 3 &&
                    IsOneOf(whole[whole.size() - 3].text, {"in", "on", "at"}) &&
                    MatchClassWord(tokens, end + 1).word != nullptr;
    const bool one = next == "one" && (in || MayFollowPlace(tokens, end + 1));
    if (!one && (!MayFollowPlace(tokens, end) || IsOfSomething(tokens, end))) continue;
    const std::string noun(ElidedNoun(*said, direction.heading, adjective || one));
    if (noun.empty()) continue;
    if (one) {
      tokens[at].text = noun;
      whole.push_back(tokens[at++]);
    } else {
      whole.push_back(Added(noun, whole.back()));
    }
    said->heading = direction.heading;
  }
  return whole;
}

// "farmland 45, grass 25, forest 30": numbers that make a hundred together, each beside a class,
// are shares of it.
std::vector<Token> WithPercent(std::vector<Token> tokens) {
  constexpr int kLeastNumbers = 3;
  int sum = 0;
  int numbers = 0;
  const auto is_bare = [&](std::size_t at) {
    const bool before = at > 0 && tokens[at - 1].kind != TokenKind::kNumber;
    const bool after = IsPause(tokens, at + 1) || WordAt(tokens, at + 1) == "and";
    return tokens[at].kind == TokenKind::kNumber && before && after &&
           tokens[at].text.find('.') == std::string::npos && tokens[at].text.size() <= 2;
  };
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (!is_bare(at)) continue;
    sum += std::atoi(tokens[at].text.c_str());
    ++numbers;
  }
  if (numbers < kLeastNumbers || sum < 98 || sum > 102) return tokens;
  std::vector<Token> whole;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const bool bare = is_bare(at);
    whole.push_back(tokens[at]);
    if (bare) whole.push_back(Added("percent", tokens[at]));
  }
  return whole;
}

constexpr std::array<Heading, 8> kRound = {
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

std::vector<std::string_view> WordsOf(Heading heading) {
  std::vector<std::string_view> words = {"in", "the"};
  if (heading.south != 0) words.push_back(heading.south < 0 ? "top" : "bottom");
  if (heading.east != 0) words.push_back(heading.east < 0 ? "left" : "right");
  if (heading.IsDiagonal()) words.push_back("corner");
  return words;
}

// "clockwise from the top left: rock, snow, water, trees": the first corner, the next, ...
std::vector<Token> WithRounds(std::vector<Token> tokens) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const std::string_view word = WordAt(tokens, at);
    const bool back = IsOneOf(word, {"anticlockwise", "counterclockwise", "widdershins"});
    if (word != "clockwise" && !back) continue;
    std::size_t next = at + 1;
    while (IsOneOf(WordAt(tokens, next),
                   {"from", "starting", "beginning", "at", "in", "with", "the"})) {
      ++next;
    }
    PlaceCursor cursor(tokens, next);
    const Direction start = TakeDirection(&cursor);
    if (!start.found) continue;
    next = cursor.at();
    if (IsOneOf(WordAt(tokens, next), {"corner", "side", "edge"})) ++next;
    if (next >= tokens.size() || tokens[next].kind != TokenKind::kComma) continue;
    std::size_t step = 0;
    while (step < kRound.size() && !(kRound[step].east == start.heading.east &&
                                     kRound[step].south == start.heading.south)) {
      ++step;
    }
    if (step == kRound.size()) continue;
    // What stands before the list only tells how it goes.
    std::size_t begin = at;
    while (begin > 0 && !IsStop(tokens, begin - 1)) --begin;
    std::vector<Token> whole(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(begin));
    std::size_t i = next + 1;
    for (int items = 0; items < 4 && !IsStop(tokens, i); ++items) {
      const Token before = tokens[i - 1];
      for (; !IsPause(tokens, i) && WordAt(tokens, i) != "and"; ++i) whole.push_back(tokens[i]);
      for (const std::string_view said : WordsOf(kRound[step]))
        whole.push_back(Added(said, whole.empty() ? before : whole.back()));
      while (!IsStop(tokens, i) &&
             (tokens[i].kind == TokenKind::kComma || WordAt(tokens, i) == "and")) {
        whole.push_back(tokens[i++]);
      }
      step = (step + (back ? kRound.size() - 2 : 2)) % kRound.size();
    }
    whole.insert(whole.end(), tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end());
    return whole;
  }
  return tokens;
}

}  // namespace

std::vector<Token> WithElidedWords(std::vector<Token> tokens) {
  return WithPlaceNouns(WithPercent(WithRounds(std::move(tokens))));
}

}  // namespace latticeworld
