#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Numbers of things between two bounds, numbered rows and halves, and what is the largest of all.
namespace latticeworld {
namespace {

// "More than two but fewer than six lakes", "at least 2 lakes but no more than 5": between 3 and 5
// lakes.
void TurnTwoBounds(std::vector<Token>* tokens, std::size_t at) {
  const auto bound = [&](std::size_t i, bool least, int* value) -> std::size_t {
    const std::string_view first = WordAt(*tokens, i), second = WordAt(*tokens, i + 1);
    std::size_t number = i + 2;
    int shift = 0;
    if (least) {
      if (first == "more" && second == "than")
        shift = 1;
      else if (!(first == "at" && second == "least"))
        return 0;
    } else if (IsOneOf(first, {"fewer", "less"}) && second == "than") {
      shift = -1;
    } else if (IsOneOf(first, {"no", "not"}) && second == "more" &&
               WordAt(*tokens, i + 2) == "than") {
      ++number;
    } else if (!(first == "at" && second == "most") && !(first == "up" && second == "to")) {
      return 0;
    }
    const NumberMatch match = MatchNumber(*tokens, number);
    *value = match.value + shift;
    return match.tokens == 0 ? 0 : number + match.tokens - i;
  };
  int least = 0, most = 0;
  const std::size_t first = bound(at, true, &least);
  if (first == 0) return;
  std::size_t noun = at + first;
  const std::size_t noun_length = MatchClassWord(*tokens, noun).tokens;
  std::size_t link = noun + noun_length;
  if (IsMark(*tokens, link)) ++link;
  if (!IsOneOf(WordAt(*tokens, link), {"but", "and", "though"})) return;
  const std::size_t second = bound(link + 1, false, &most);
  if (second == 0 || most < least) return;
  std::size_t end = link + 1 + second;
  if (noun_length == 0) {
    noun = end;
    if (MatchClassWord(*tokens, noun).tokens == 0) return;
  } else {
    if (WordAt(*tokens, end) == "of" && WordAt(*tokens, end + 1) == "them") end += 2;
    // "at least two lakes and at most three villages": of each of them.
    const ClassWordMatch other = MatchClassWord(*tokens, end);
    const ClassWord* one = MatchClassWord(*tokens, noun).word;
    if (other.word != nullptr &&
        (other.word->suburb != one->suburb || other.word->wild != one->wild)) {
      return;
    }
    end += other.tokens;
    if (!IsPauseAt(*tokens, end) && WordAt(*tokens, end) != "in") return;
  }
  const Token beside = (*tokens)[at];
  std::vector<Token> said =
      SaidLike("between " + std::to_string(least) + " and " + std::to_string(most), beside);
  for (const Token& token : TokensBetween(*tokens, noun, noun + noun_length)) said.push_back(token);
  EraseTokens(tokens, at, end - at);
  InsertTokens(tokens, at, said);
}

// "Water: 2 lakes": two lakes.
void TurnLabelledCount(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || !IsOneOf((*tokens)[at].text, {":", "="}) || at == 0) return;
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  const NumberMatch number = MatchNumber(*tokens, at + 1);
  if (named.empty() || named[0].end != at || number.tokens == 0 ||
      (named[0].begin > 0 && !IsPauseAt(*tokens, named[0].begin - 1))) {
    return;
  }
  const ClassWordMatch key = MatchClassWord(*tokens, named[0].begin);
  const ClassWordMatch value = MatchClassWord(*tokens, at + 1 + number.tokens);
  if (value.word == nullptr || value.word->suburb != key.word->suburb ||
      value.word->wild != key.word->wild) {
    return;
  }
  EraseTokens(tokens, named[0].begin, at + 1 - named[0].begin);
}

// "The first half (left) is town": the left half.
void TurnNamedHalf(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"first", "second", "one", "other"}) ||
      WordAt(*tokens, at + 1) != "half") {
    return;
  }
  std::size_t open = at + 2;
  if (WordAt(*tokens, open) == "of" && WordAt(*tokens, open + 1) == "the" &&
      IsMapWord(WordAt(*tokens, open + 2))) {
    open += 3;
  }
  if (open + 2 >= tokens->size() || (*tokens)[open].text != "(" ||
      SideWord(WordAt(*tokens, open + 1)).empty() || (*tokens)[open + 2].text != ")") {
    return;
  }
  const std::string side((*tokens)[open + 1].text);
  ReplaceTokens(tokens, at, open + 3 - at, {side, "half"});
}

// "Rows 1 to 10", "the first 16 columns": the upper third, the left half.
void TurnNumberedRows(std::vector<Token>* tokens, std::size_t at) {
  constexpr double kCells = 32.0;
  const bool rows = WordAt(*tokens, at) == "rows";
  if (!rows && WordAt(*tokens, at) != "columns") return;
  std::size_t begin = at, end = at + 1;
  double first = 1.0, last = kCells;
  const auto value = [&](std::size_t i) { return MatchNumber(*tokens, i).value * 1.0; };
  const std::size_t second =
      at + 2 + (IsOneOf(WordAt(*tokens, at + 2), {"to", "through"}) ? std::size_t{1} : 0);
  if (MatchNumber(*tokens, at + 1).tokens == 1 && MatchNumber(*tokens, second).tokens == 1) {
    first = value(at + 1);
    last = value(second);
    end = second + 1;
  } else if (at > 1 && MatchNumber(*tokens, at - 1).tokens == 1 &&
             IsOneOf(WordAt(*tokens, at - 2), {"first", "top", "last", "bottom"})) {
    const bool from_first = IsOneOf(WordAt(*tokens, at - 2), {"first", "top"});
    from_first ? last = value(at - 1) : first = kCells + 1.0 - value(at - 1);
    begin = at - 2;
  } else {
    return;
  }
  if (begin > 0 && WordAt(*tokens, begin - 1) == "the") --begin;
  constexpr std::pair<std::string_view, double> kParts[] = {
      {"quarter", 0.25}, {"third", 1.0 / 3.0}, {"half", 0.5}, {"two thirds", 2.0 / 3.0}};
  std::string_view part;
  for (const auto& [word, share] : kParts)
    if (std::abs((last + 1.0 - first) / kCells - share) < 0.05) part = word;
  if (part.empty() || (first > 1.0) == (last < kCells)) return;
  const std::string_view side =
      rows ? (first > 1.0 ? "lower" : "upper") : (first > 1.0 ? "right" : "left");
  const Token beside = (*tokens)[begin];
  EraseTokens(tokens, begin, end - begin);
  InsertTokens(tokens, begin,
               SaidLike("the " + std::string(side) + " " + std::string(part), beside));
}

// "Forest is the largest area", "the biggest part should be forest": mostly forest.
void TurnBiggestPart(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"is", "are"}) || WordAt(*tokens, at + 1) != "the" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"biggest", "largest", "greatest", "main"}) ||
      !IsOneOf(WordAt(*tokens, at + 3), {"part", "area", "share", "portion", "class"}) ||
      !IsPauseAt(*tokens, at + 4)) {
    return;
  }
  const std::vector<NamedThing> named = NamedBefore(*tokens, at);
  if (named.empty() || named[0].end != at) return;
  EraseTokens(tokens, at, 4);
  std::size_t begin = named[0].begin;
  if (begin > 0 && WordAt(*tokens, begin - 1) == "the") EraseTokens(tokens, --begin, 1);
  InsertTokens(tokens, begin, {WordLike("mostly", (*tokens)[begin])});
}

}  // namespace

void TurnNumbered(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnTwoBounds(tokens, at);
    TurnLabelledCount(tokens, at);
    TurnNamedHalf(tokens, at);
    TurnNumberedRows(tokens, at);
    TurnBiggestPart(tokens, at);
  }
}

}  // namespace latticeworld
