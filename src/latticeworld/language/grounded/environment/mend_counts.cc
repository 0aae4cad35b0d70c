#include "latticeworld/language/grounded/environment/mend_counts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

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
  MendRetractions(tokens);
  MendFormer(tokens);
  MendParts(words, tokens);
}

}  // namespace latticeworld
