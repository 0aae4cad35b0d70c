#include "latticeworld/language/grounded/environment/mending/amounts/mend_multiples.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

constexpr int kMostCounted = 100;  // of those who are compared with

// "twice as many sheep as there are horses"
struct Comparison {
  int times = 1;
  int of = 1;             // "half as many": one for two of them
  std::size_t many = 0;   // behind "as many"
  std::size_t as = 0;     // "as", behind the first noun
  std::size_t other = 0;  // the second noun
  std::size_t end = 0;    // behind it; 0: there is no comparison
};

std::size_t SpeciesAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                      std::size_t at) {
  return IsPauseAt(tokens, at) ? 0 : words.species.LengthAt(tokens, at);
}

Comparison ComparisonAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                        std::size_t at) {
  constexpr std::size_t kNoun_tokens = 4;
  Comparison found;
  std::size_t next = at;
  const NumberMatch number = MatchNumber(tokens, at);
  if (IsOneOf(WordAt(tokens, at), {"twice", "double"})) found.times = 2;
  if (IsOneOf(WordAt(tokens, at), {"thrice", "triple"})) found.times = 3;
  if (WordAt(tokens, at) == "half") found.of = 2;
  if (found.times > 1 || found.of > 1) {
    ++next;
  } else if (number.tokens > 0 && WordAt(tokens, at + number.tokens) == "times") {
    found.times = std::min(number.value, kMostCounted);
    next += number.tokens + 1;
  }
  while (IsOneOf(WordAt(tokens, next), {"just", "exactly", "about"})) ++next;
  if (WordAt(tokens, next) != "as" || WordAt(tokens, next + 1) != "many") return {};
  found.many = next + 2;
  if (WordAt(tokens, found.many) == "as") return {};  // a bound
  found.as = found.many;
  while (found.as < found.many + kNoun_tokens && WordAt(tokens, found.as) != "as" &&
         !IsPauseAt(tokens, found.as)) {
    ++found.as;
  }
  if (WordAt(tokens, found.as) != "as" || found.as == found.many) return {};
  found.other = found.as + 1;
  while (IsOneOf(WordAt(tokens, found.other), {"there", "are", "the"})) ++found.other;
  const std::size_t species = SpeciesAt(words, tokens, found.other);
  if (species > 0) found.end = found.other + species;
  return found;
}

// The name of the comparison's others, with a number or without one, before `end`.
bool IsNamedBefore(const std::vector<Token>& tokens, std::size_t other, std::size_t end) {
  for (std::size_t i = 0; i < end; ++i) {
    if (WordAt(tokens, i) == WordAt(tokens, other)) return true;
  }
  return false;
}

// How many of the others there are said to be, later; 0: nobody says it. `named`: with their name.
int CountBehind(const std::vector<Token>& tokens, const Comparison& found, bool* named) {
  constexpr std::size_t kAdjectives = 2;
  for (std::size_t next = found.end; next < tokens.size(); ++next) {
    const NumberMatch said = MatchNumber(tokens, next);
    if (said.tokens == 0) continue;
    const std::size_t end = next + said.tokens;
    const bool latter = WordAt(tokens, end) == "of" && WordAt(tokens, end + 2) == "latter";
    *named = false;
    for (std::size_t i = end; i <= end + kAdjectives && !IsPauseAt(tokens, i); ++i) {
      *named = *named || WordAt(tokens, i) == WordAt(tokens, found.other);
    }
    const bool counts = latter || *named || IsOneOf(WordAt(tokens, next - 1), {"are", "is"});
    return counts && said.value >= 1 && said.value <= kMostCounted ? said.value : 0;
  }
  return 0;
}

Token NumberLike(int number, const Token& beside) {
  return {TokenKind::kNumber, std::to_string(number), beside.begin, beside.end};
}

// "As many eagles as whales: four (of each)": four eagles and four whales.
bool CountBoth(const Comparison& found, std::size_t at, std::vector<Token>* tokens) {
  if (found.times != 1 || found.of != 1 || IsStopAt(*tokens, found.end)) return false;
  if (!IsPauseAt(*tokens, found.end)) return false;
  const NumberMatch number = MatchNumber(*tokens, found.end + 1);
  std::size_t end = found.end + 1 + number.tokens;
  if (WordAt(*tokens, end) == "of") ++end;
  if (IsOneOf(WordAt(*tokens, end), {"each", "both", "apiece"})) ++end;
  if (number.tokens == 0 || !IsPauseAt(*tokens, end)) return false;
  const Token count = NumberLike(number.value, (*tokens)[at]);
  EraseTokens(tokens, found.end, end - found.end);
  (*tokens)[found.as].text = "and";
  EraseTokens(tokens, found.as + 1, found.other - found.as - 1);
  InsertTokens(tokens, found.as + 1, {count});
  EraseTokens(tokens, at, found.many - at);
  InsertTokens(tokens, at, {count});
  return true;
}

}  // namespace

void MendMultiples(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const Comparison found = ComparisonAt(words, *tokens, at);
    if (found.end == 0 || IsNamedBefore(*tokens, found.other, at)) continue;
    if (CountBoth(found, at, tokens)) continue;
    bool named = false;
    const int count = CountBehind(*tokens, found, &named);
    const Token beside = (*tokens)[at];
    if (count > 0 && named) {
      // "..., and there are four horses" names them by itself.
      EraseTokens(tokens, found.as, found.end - found.as);
    } else if (count > 0) {
      // "as horses" would compare again.
      (*tokens)[found.as].text = "beside";
    } else {
      // "Twice as many warriors as goblins": warriors and goblins.
      (*tokens)[found.as].text = "and";
      EraseTokens(tokens, found.as + 1, found.other - found.as - 1);
    }
    EraseTokens(tokens, at, found.many - at);
    if (count > 0) {
      InsertTokens(tokens, at, {NumberLike(std::max(1, count * found.times / found.of), beside)});
    }
  }
}

}  // namespace latticeworld
