#include "latticeworld/language/grounded/environment/mend_counts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsCommaAt(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kComma;
}

// The token behind "I mean", "no", "or rather"; `at`: nothing of the kind.
std::size_t TakeRetraction(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kTwo = {{{"i", "mean"},
                                                                    {"i", "meant"},
                                                                    {"make", "that"},
                                                                    {"make", "it"},
                                                                    {"or", "rather"},
                                                                    {"no", "wait"},
                                                                    {"wait", "no"},
                                                                    {"no", "sorry"}}};
  for (const auto& [first, second] : kTwo)
    if (WordAt(tokens, at) == first && WordAt(tokens, at + 1) == second) return at + 2;
  for (const std::string_view word : {"no", "sorry", "wait", "actually", "correction"})
    if (WordAt(tokens, at) == word) return at + 1;
  return at;
}

void MendRetractions(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const NumberMatch first = MatchNumber(*tokens, at);
    if (first.tokens == 0) continue;
    std::size_t next = at + first.tokens;
    if (IsCommaAt(*tokens, next)) ++next;
    const std::size_t taken_back = TakeRetraction(*tokens, next);
    if (taken_back == next) continue;
    next = taken_back + (IsCommaAt(*tokens, taken_back) ? 1 : 0);
    const NumberMatch meant = MatchNumber(*tokens, next);
    if (meant.tokens == 0) continue;
    EraseTokens(tokens, at, next - at);
    if (IsCommaAt(*tokens, at + meant.tokens)) EraseTokens(tokens, at + meant.tokens, 1);
  }
}

// "Four white horses, no, five of them": five white horses.
void MendLateRetractions(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const std::size_t taken_back = TakeRetraction(*tokens, at);
    if (taken_back == at) continue;
    const std::size_t meant_at = taken_back + (IsCommaAt(*tokens, taken_back) ? 1 : 0);
    const NumberMatch meant = MatchNumber(*tokens, meant_at);
    const std::size_t of = meant_at + meant.tokens;
    if (meant.tokens == 0 || WordAt(*tokens, of) != "of" || WordAt(*tokens, of + 1) != "them")
      continue;
    // The number that it takes back.
    for (std::size_t first = at; first-- > 0 && (*tokens)[first].kind != TokenKind::kStop;) {
      const NumberMatch said = MatchNumber(*tokens, first);
      if (said.tokens == 0 || first + said.tokens > at) continue;
      const std::vector<Token> number = TokensBetween(*tokens, meant_at, of);
      const std::size_t begin = at - (IsCommaAt(*tokens, at - 1) ? 1 : 0);
      EraseTokens(tokens, begin, of + 2 - begin);
      EraseTokens(tokens, first, said.tokens);
      InsertTokens(tokens, first, number);
      break;
    }
  }
}

// "Twenty or so sheep", "twenty-odd sheep": about twenty. "A couple of dozen": two dozen.
void MendRoundNumbers(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (WordAt(*tokens, at) == "couple" && at > 0 && WordAt(*tokens, at - 1) == "a") {
      const std::size_t dozen = at + (WordAt(*tokens, at + 1) == "of" ? 2 : 1);
      if (WordAt(*tokens, dozen) == "dozen") ReplaceTokens(tokens, at - 1, dozen + 1 - at, {"two"});
    }
    const NumberMatch number = MatchNumber(*tokens, at);
    if (number.tokens == 0) continue;
    const std::size_t end = at + number.tokens;
    std::size_t round = 0;  // words
    if (WordAt(*tokens, end) == "or" &&
        (WordAt(*tokens, end + 1) == "so" || WordAt(*tokens, end + 1) == "thereabouts")) {
      round = 2;
    } else if (WordAt(*tokens, end) == "odd" || WordAt(*tokens, end) == "ish") {
      round = 1;
    }
    if (round == 0) continue;
    EraseTokens(tokens, end, round);
    InsertTokens(tokens, at, {WordLike("about", (*tokens)[at])});
    at += number.tokens;
  }
}

// "Robots: 3 wheeled, 2 aerial": three wheeled robots, two aerial robots.
void MendRobotKinds(std::vector<Token>* tokens) {
  bool robots = false;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    robots = robots || WordAt(*tokens, at) == "robots";
    if (!robots) continue;
    const NumberMatch number = MatchNumber(*tokens, at);
    const std::size_t kind = at + number.tokens;
    const std::size_t next = kind + 1;
    const bool ends = next >= tokens->size() || (*tokens)[next].kind != TokenKind::kWord ||
                      WordAt(*tokens, next) == "and" || WordAt(*tokens, next) == "ones";
    if (number.tokens == 0 || !ends) continue;
    for (const std::string_view word : {"wheeled", "aerial", "flying", "legged", "humanoid"}) {
      if (WordAt(*tokens, kind) != word) continue;
      if (WordAt(*tokens, next) == "ones") EraseTokens(tokens, next, 1);
      InsertTokens(tokens, next, {WordLike("robots", (*tokens)[kind])});
      break;
    }
  }
}

// Whether "now there are only three" follows, which says of how many are left.
bool SaysWhatIsLeft(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::size_t kReach = 4;
  while (at < tokens.size() && WordAt(tokens, at) != "now") ++at;
  for (std::size_t i = at + 1; i < std::min(at + 1 + kReach, tokens.size()); ++i) {
    const bool only = WordAt(tokens, i) == "only" || WordAt(tokens, i) == "just";
    if (only && MatchNumber(tokens, i + 1).tokens > 0) return true;
  }
  return false;
}

void MendFormer(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const bool used = WordAt(*tokens, at) == "used" && WordAt(*tokens, at + 1) == "to" &&
                      WordAt(*tokens, at + 2) == "be";
    if (!used || SaysWhatIsLeft(*tokens, at)) continue;
    EraseTokens(tokens, at + 1, 2);
    (*tokens)[at].text = "no";
  }
}

// The last number before `end` in its sentence, 0: none.
int NumberBefore(const std::vector<Token>& tokens, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && tokens[begin - 1].kind != TokenKind::kStop) --begin;
  int number = 0;
  for (; begin < end; ++begin)
    if (const NumberMatch match = MatchNumber(tokens, begin); match.tokens > 0)
      number = static_cast<int>(match.value);
  return number;
}

// Behind a colon, parts that make up the number before it and name no species of their own.
void MendParts(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t colon = 0; colon < tokens->size(); ++colon) {
    if (!IsCommaAt(*tokens, colon) || (*tokens)[colon].text != ":") continue;
    const int whole = NumberBefore(*tokens, colon);
    int sum = 0;
    std::vector<std::size_t> behind;  // each part's number
    for (std::size_t at = colon + 1; at < tokens->size(); ++at) {
      if ((*tokens)[at].kind == TokenKind::kStop) break;
      const bool opens = IsCommaAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
      const NumberMatch part = MatchNumber(*tokens, at);
      if (!opens || part.tokens == 0) continue;
      const std::size_t next = at + part.tokens;
      const bool other = words.species.LengthAt(*tokens, next) > 0 ||
                         words.kinds.LengthAt(*tokens, next) > 0 ||
                         words.assets.LengthAt(*tokens, next) > 0 || WordAt(*tokens, next).empty();
      if (other || WordAt(*tokens, next) == "of") {
        behind.clear();
        break;
      }
      sum += static_cast<int>(part.value);
      behind.push_back(next);
    }
    if (behind.size() < 2 || sum != whole) continue;
    std::reverse(behind.begin(), behind.end());
    for (const std::size_t at : behind) {
      const Token beside = (*tokens)[at];
      InsertTokens(tokens, at, {WordLike("of", beside), WordLike("them", beside)});
    }
  }
}

}  // namespace

void MendCounts(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendLateRetractions(tokens);
  MendRetractions(tokens);
  MendRoundNumbers(tokens);
  MendFormer(tokens);
  MendParts(words, tokens);
  MendRobotKinds(tokens);
}

}  // namespace latticeworld
