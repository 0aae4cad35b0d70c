#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Keys and values, and digits in the place of words.
namespace latticeworld {
namespace {

bool IsMarkAt(const std::vector<Token>& tokens, std::size_t at, std::string_view mark) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kComma && tokens[at].text == mark;
}

bool IsCount(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() &&
         (tokens[at].kind == TokenKind::kNumber ||
          IsOneOf(tokens[at].text, {"one", "two", "three", "four", "five", "six", "seven", "eight",
                                    "nine", "ten", "eleven", "twelve"}));
}

bool IsZero(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kNumber && tokens[at].text == "0";
}

// "Streets? None.": streets: none.
void TurnAskedAndDenied(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !IsStopAt(*tokens, at) || at >= tokens->size() || (*tokens)[at].text != "?" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"none", "no", "never", "nope", "nowhere"})) {
    return;
  }
  std::size_t end = at + 2;
  if (WordAt(*tokens, end) == "at" && WordAt(*tokens, end + 1) == "all") end += 2;
  std::size_t begin = at;
  while (begin > 0 && !IsPauseAt(*tokens, begin - 1)) --begin;
  // "should there be houses? no, fields" is more than a key and its value.
  if (!IsStopAt(*tokens, end) || at - begin > 3) return;
  (*tokens)[at].kind = TokenKind::kComma;
  (*tokens)[at].text = ":";
  ReplaceTokens(tokens, at + 1, end - at - 1, {"none"});
}

// "Three ponds at least", "5 clusters of huts minimum", "two hamlets at most": at least three, at
// least 5, at most two.
void TurnBoundsBehind(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  const bool two = word == "at" && IsOneOf(WordAt(*tokens, at + 1), {"least", "most"});
  const bool least = two ? WordAt(*tokens, at + 1) == "least" : IsOneOf(word, {"minimum", "min"});
  const bool most =
      two ? WordAt(*tokens, at + 1) == "most" : IsOneOf(word, {"maximum", "max", "tops"});
  const std::size_t length = two ? 2 : 1;
  if ((!least && !most) || !IsPauseAt(*tokens, at + length)) return;
  std::size_t number = at;
  while (number > 0 && at - number < 4 && !IsPauseAt(*tokens, number - 1) &&
         (number == at || !IsCount(*tokens, number))) {
    --number;
  }
  // "a hamlet, two at most"
  const bool alone = number > 0 && IsPauseAt(*tokens, number - 1);
  if (number == at || (at - number < 2 && !alone) || !IsCount(*tokens, number)) return;
  if (number > 0 && IsOneOf(WordAt(*tokens, number - 1), {"least", "most", "than"})) return;
  const Token beside = (*tokens)[number];
  EraseTokens(tokens, at, length);
  InsertTokens(tokens, number,
               {WordLike("at", beside), WordLike(least ? "least" : "most", beside)});
}

// "Bare rock: 0", "trees=off", "snow = 0 %", "houses: no": none.
void TurnOff(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMarkAt(*tokens, at, ":") && !IsMarkAt(*tokens, at, "=") && !IsMarkAt(*tokens, at, "-"))
    return;
  const std::size_t value = at + 1;
  if (WordAt(*tokens, value + 1) == "percent" && IsZero(*tokens, value))
    EraseTokens(tokens, value + 1, 1);
  if (value >= tokens->size() || !IsPauseAt(*tokens, value + 1)) return;
  // "in the north - no, sorry, in the south"
  if (WordAt(*tokens, value) == "no" && !IsStopAt(*tokens, value + 1)) return;
  const bool zero = IsZero(*tokens, value);
  if (zero || IsOneOf(WordAt(*tokens, value), {"off", "zero", "no", "false", "forbidden"}))
    ReplaceTokens(tokens, value, 1, {"none"});
}

// Whether a thing stands at `at`, or behind one adjective there.
bool IsThingNear(const std::vector<Token>& tokens, std::size_t at) {
  if (MatchClassWord(tokens, at).tokens > 0) return true;
  return !WordAt(tokens, at).empty() && MatchClassWord(tokens, at + 1).tokens > 0 &&
         !IsOneOf(WordAt(tokens, at), {"percent", "by", "x", "to", "or", "and", "cells", "squares",
                                       "metres", "meters", "cell", "m", "wide"});
}

// "The other 2", "all 4 corners", "on 3 sides of it", "2 straight roads", "cuts it in 2": the words
// of such numbers are part of phrases.
void TurnDigits(std::vector<Token>* tokens, std::size_t at) {
  constexpr std::string_view kWords[] = {"two", "three", "four",  "five",
                                         "six", "seven", "eight", "nine"};
  Token& token = (*tokens)[at];
  if (token.kind != TokenKind::kNumber || token.text.size() != 1 || token.text[0] < '2') return;
  const bool counted =
      IsOneOf(WordAt(*tokens, at + 1), {"sides", "corners", "edges", "borders", "quarters",
                                        "quadrants", "halves", "parts", "banks", "ends", "of"});
  const bool meant = at > 0 && IsOneOf(WordAt(*tokens, at - 1),
                                       {"the", "other", "first", "last", "all", "those", "these"});
  const bool cut =
      at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"in", "into"}) && IsPauseAt(*tokens, at + 1);
  const bool side = at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"by", "x"});  // "5 by 5 lake"
  const bool thing = !side && IsThingNear(*tokens, at + 1);
  if (!counted && !meant && !cut && !thing) return;
  token.text = kWords[token.text[0] - '2'];
  token.kind = TokenKind::kWord;
}

// "More than half of the map is forest": that is a number, not only more than of all else.
void TurnMoreThanHalf(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "half" || at < 2 || WordAt(*tokens, at - 1) != "than" ||
      WordAt(*tokens, at - 2) != "more") {
    return;
  }
  std::size_t whole = at + 1;
  while (IsOneOf(WordAt(*tokens, whole), {"of", "the", "this"})) ++whole;
  if (!IsMapWord(WordAt(*tokens, whole)) && WordAt(*tokens, whole) != "it") return;
  ReplaceTokens(tokens, at, 1, {"50", "percent"});
  (*tokens)[at].kind = TokenKind::kNumber;
}

}  // namespace

void TurnLabels(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnDigits(tokens, at);
    TurnAskedAndDenied(tokens, at);
    TurnOff(tokens, at);
    TurnBoundsBehind(tokens, at);
    TurnMoreThanHalf(tokens, at);
  }
}

}  // namespace latticeworld
