#include "latticeworld/language/grounded/environment/mending/mend_robots.h"

#include <cstddef>
#include <string>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// A share of a whole in words; `tokens` 0: there is none.
struct Share {
  int parts = 1;
  int of = 1;
  std::size_t tokens = 0;
};

Share ShareAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) == "half") return {1, 2, 1};
  const NumberMatch number = MatchNumber(tokens, at);
  if (number.tokens > 0 && IsOneOf(WordAt(tokens, at + number.tokens), {"percent"})) {
    return {number.value, 100, number.tokens + 1};
  }
  const bool article = IsOneOf(WordAt(tokens, at), {"a", "one"});
  if (!article && number.tokens != 1) return {};
  const int parts = article ? 1 : number.value;
  const std::string_view of = WordAt(tokens, at + 1);
  if (IsOneOf(of, {"third", "thirds"})) return {parts, 3, 2};
  if (IsOneOf(of, {"quarter", "quarters"})) return {parts, 4, 2};
  if (IsOneOf(of, {"fifth", "fifths"})) return {parts, 5, 2};
  if (IsOneOf(of, {"tenth", "tenths"})) return {parts, 10, 2};
  return {};
}

bool IsRobotKindAt(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(WordAt(tokens, at), {"wheeled", "aerial", "flying", "legged", "humanoid"});
}

// "Robots: 3 wheeled, two of them flying, the rest humanoid": 3 wheeled robots, two flying robots,
// the rest humanoid robots.
void NameKinds(std::vector<Token>* tokens) {
  bool robots = false;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    robots = robots || WordAt(*tokens, at) == "robots";
    if (!robots) continue;
    const Share share = ShareAt(*tokens, at);
    std::size_t part = share.tokens > 0 ? share.tokens : MatchNumber(*tokens, at).tokens;
    const bool rest = IsOneOf(WordAt(*tokens, at), {"rest", "others", "remainder"});
    if (rest) part = 1;
    std::size_t kind = at + part;
    if (rest && IsOneOf(WordAt(*tokens, kind), {"are", "is"})) ++kind;
    if (WordAt(*tokens, kind) == "of" && WordAt(*tokens, kind + 1) == "them") kind += 2;
    const std::size_t next = kind + 1;
    const bool ends = next >= tokens->size() || (*tokens)[next].kind != TokenKind::kWord ||
                      IsOneOf(WordAt(*tokens, next), {"and", "ones"});
    if (part == 0 || !ends || !IsRobotKindAt(*tokens, kind)) continue;
    if (WordAt(*tokens, next) == "ones") EraseTokens(tokens, next, 1);
    InsertTokens(tokens, next, {WordLike("robots", (*tokens)[kind])});
    if (share.tokens == 0 && !rest) EraseTokens(tokens, at + part, kind - at - part);
  }
}

// "Robots: three on wheels, two of them with four legs": three robots on wheels, two robots with
// four legs.
void NameParts(std::vector<Token>* tokens) {
  bool robots = false;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    robots = robots || WordAt(*tokens, at) == "robots";
    const std::size_t number = MatchNumber(*tokens, at).tokens;
    std::size_t on = at + number;
    if (!robots || number == 0) continue;
    if (WordAt(*tokens, on) == "of" && WordAt(*tokens, on + 1) == "them") on += 2;
    if (!IsOneOf(WordAt(*tokens, on), {"on", "with"})) continue;
    const std::size_t part = on + 1 + MatchNumber(*tokens, on + 1).tokens;
    const bool parts =
        IsOneOf(WordAt(*tokens, part), {"wheels", "legs", "rotors", "propellers", "wings"});
    if (!parts) continue;
    InsertTokens(tokens, on, {WordLike("robots", (*tokens)[at])});
    EraseTokens(tokens, at + number, on - at - number);
  }
}

// How many agents of any kind were counted last before `end` ("100 agents", "sixty animals"); 0:
// none.
int WholeBefore(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t end) {
  for (std::size_t at = end; at-- > 0;) {
    const NumberMatch number = MatchNumber(tokens, at);
    const std::size_t noun = at + number.tokens;
    if (number.tokens == 0 || noun >= end || IsPauseAt(tokens, noun)) continue;
    // "two hundred" rather than "hundred"
    if (at > 0 && MatchNumber(tokens, at - 1).tokens > number.tokens) continue;
    const bool range = at > 1 && IsOneOf(WordAt(tokens, at - 1), {"and", "to", "or"}) &&
                       MatchNumber(tokens, at - 2).tokens > 0;
    if (range) return 0;
    const auto kind = words.species.At(tokens, noun);
    if (kind.tokens > 0) return kind.rows.front()->categories.size() > 1 ? number.value : 0;
  }
  return 0;
}

Token NumberLike(int number, const Token& beside) {
  return {TokenKind::kNumber, std::to_string(number), beside.begin, beside.end};
}

// "100 agents, half of them sheep, 50 % goblins": 50 sheep, 50 goblins.
void CountShares(const EnvironmentWords& words, std::vector<Token>* tokens) {
  int whole = 0;  // that the shares of this sentence are of
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) whole = 0;
    const Share share = ShareAt(*tokens, at);
    std::size_t noun = at + share.tokens;
    if (share.tokens == 0 || share.parts >= share.of) continue;
    if (WordAt(*tokens, noun) == "of" && WordAt(*tokens, noun + 1) == "them") noun += 2;
    if (IsPauseAt(*tokens, noun)) continue;
    const bool opens = IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
    if (!opens || words.species.LengthAt(*tokens, noun) == 0) continue;
    if (whole == 0) whole = WholeBefore(words, *tokens, at);
    constexpr int kMostWhole = 1000000;
    if (whole < 2 || whole > kMostWhole) continue;
    const int part = (whole * share.parts + share.of / 2) / share.of;
    Token number = NumberLike(part, (*tokens)[at]);
    // The sign of percent is no more to be seen behind the number.
    number.end = (*tokens)[at + share.tokens - 1].end;
    EraseTokens(tokens, at, noun - at);
    InsertTokens(tokens, at, {number});
  }
}

// How many words say "in equal numbers", "half and half"; 0: none.
std::size_t EquallyAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) == "in" && WordAt(tokens, at + 1) == "equal" &&
      IsOneOf(WordAt(tokens, at + 2), {"numbers", "number", "parts", "shares", "measure"})) {
    return 3;
  }
  const bool halves = WordAt(tokens, at) == "half" && WordAt(tokens, at + 1) == "and" &&
                      WordAt(tokens, at + 2) == "half";
  return halves ? 3 : 0;
}

// "60 animals: sheep and horses in equal numbers": 30 sheep and 30 horses.
void CountEqually(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const std::size_t first = words.species.LengthAt(*tokens, at);
    const std::size_t second_at = at + first + 1;
    if (first == 0 || WordAt(*tokens, at + first) != "and") continue;
    const std::size_t second = words.species.LengthAt(*tokens, second_at);
    std::size_t equally = second_at + second;
    if (equally < tokens->size() && (*tokens)[equally].kind == TokenKind::kComma) ++equally;
    const std::size_t said = EquallyAt(*tokens, equally);
    const int whole = WholeBefore(words, *tokens, at);
    if (second == 0 || said == 0 || whole < 2 || IsPauseAt(*tokens, second_at)) continue;
    const Token beside = (*tokens)[at];
    EraseTokens(tokens, second_at + second, equally + said - second_at - second);
    InsertTokens(tokens, second_at, {NumberLike(whole / 2, beside)});
    InsertTokens(tokens, at, {NumberLike(whole - whole / 2, beside)});
  }
}

}  // namespace

void MendRobots(const EnvironmentWords& words, std::vector<Token>* tokens) {
  NameKinds(tokens);
  NameParts(tokens);
  CountShares(words, tokens);
  CountEqually(words, tokens);
}

}  // namespace latticeworld
