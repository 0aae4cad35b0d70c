#include "latticeworld/language/grounded/environment/mending/amounts/mend_ranges.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

constexpr int kMost = 1000000;          // agents that are counted so
constexpr std::size_t kNounTokens = 3;  // from a number to its noun

Token NumberLike(int number, const Token& beside) {
  return {TokenKind::kNumber, std::to_string(number), beside.begin, beside.end};
}

// A whole number that counts; `tokens` 0: none.
NumberMatch CountAt(const std::vector<Token>& tokens, std::size_t at) {
  const NumberMatch number = MatchNumber(tokens, at);
  const bool fraction = number.tokens == 1 && tokens[at].text.find('.') != std::string::npos;
  return number.tokens == 0 || fraction || number.value > kMost ? NumberMatch{} : number;
}

// How many tokens from `at` to the end of the noun of agents that is counted there; 0: none is.
std::size_t NounAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                   std::size_t at) {
  for (std::size_t noun = at; noun < at + kNounTokens && !IsPauseAt(tokens, noun); ++noun) {
    if (const std::size_t species = words.species.LengthAt(tokens, noun); species > 0) {
      return noun + species - at;
    }
    const bool other = words.assets.LengthAt(tokens, noun) > 0 ||
                       MatchNumber(tokens, noun).tokens > 0 ||
                       words.RoleAt(Role::kIn, tokens, noun) > 0;
    if (other || IsOneOf(WordAt(tokens, noun), {"but", "and", "or"})) return 0;
  }
  return 0;
}

// "5+ drones": at least 5.
void SayPlus(std::string_view instruction, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const Token number = (*tokens)[at];
    if (number.kind != TokenKind::kNumber || number.end > instruction.size()) continue;
    const std::string_view behind = instruction.substr(number.end);
    const bool plus = behind.size() > 1 && behind[0] == '+' && behind[1] == ' ' &&
                      WordAt(*tokens, at + 1) == "and" && MatchNumber(*tokens, at + 2).tokens == 0;
    if (!plus) continue;
    EraseTokens(tokens, at + 1, 1);
    InsertTokens(tokens, at, {WordLike("at", number), WordLike("least", number)});
    at += 2;
  }
}

// The words of "plus or minus", "give or take"; 0: there are none. `gap`: the text before the
// number at `at`, where the signs are no words.
std::size_t GiveOrTakeAt(const std::vector<Token>& tokens, std::size_t at, std::string_view gap) {
  const std::string_view word = WordAt(tokens, at);
  if (word == "\xC2\xB1") return 1;
  if (word == "give" && WordAt(tokens, at + 1) == "or" && WordAt(tokens, at + 2) == "take") {
    return 3;
  }
  if (word == "and" && (gap.find("+/-") != gap.npos || gap.find("+-") != gap.npos)) return 1;
  if (word != "plus") return 0;
  const bool joint = IsOneOf(WordAt(tokens, at + 1), {"or", "and"});
  return WordAt(tokens, at + (joint ? 2 : 1)) == "minus" ? (joint ? 3 : 2) : 0;
}

// "A hundred sheep, give or take ten", "100 plus or minus 10 % sheep": between 90 and 110 sheep.
void SayTolerances(const EnvironmentWords& words, std::string_view instruction,
                   std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const NumberMatch number = CountAt(*tokens, at);
    if (number.tokens == 0) continue;
    const std::size_t end = at + number.tokens;
    const std::size_t noun = NounAt(words, *tokens, end);
    for (const std::size_t after : {end, end + noun}) {
      const std::size_t comma = after < tokens->size() && (*tokens)[after].text == "," ? 1 : 0;
      const std::size_t from = (*tokens)[after - 1].end;
      const std::size_t to = after + 1 < tokens->size() ? (*tokens)[after + 1].begin : from;
      const std::string_view gap =
          from < to && to <= instruction.size() ? instruction.substr(from, to - from) : "";
      const std::size_t said = GiveOrTakeAt(*tokens, after + comma, gap);
      const std::size_t second = after + comma + said;
      NumberMatch off = said > 0 ? CountAt(*tokens, second) : NumberMatch{};
      if (off.tokens == 0) continue;
      std::size_t last = second + off.tokens;
      // "give or take one or two"
      if (IsOneOf(WordAt(*tokens, last), {"or", "to"})) {
        const NumberMatch more = CountAt(*tokens, last + 1);
        if (more.tokens > 0 && more.value > off.value) {
          off = more;
          last += 1 + more.tokens;
        }
      }
      if (WordAt(*tokens, last) == "percent") {
        off.value = static_cast<int>((1LL * number.value * off.value + 50) / 100);
        ++last;
      }
      const std::size_t other = NounAt(words, *tokens, last);
      const bool counts = noun > 0 || other > 0;
      // "ten sheep plus minus two goblins" are of two kinds.
      if (noun > 0 && other > 0) continue;
      if (off.value >= number.value || !counts) continue;
      const Token beside = (*tokens)[at];
      EraseTokens(tokens, after, last - after);
      EraseTokens(tokens, at, number.tokens);
      InsertTokens(tokens, at,
                   {WordLike("between", beside), NumberLike(number.value - off.value, beside),
                    WordLike("and", beside), NumberLike(number.value + off.value, beside)});
      if (at > 0 && words.RoleAt(Role::kAbout, *tokens, at - 1) == 1) {
        EraseTokens(tokens, at - 1, 1);
      }
      at += 3;
      break;
    }
  }
}

// A bound and its number: the least or the most that is allowed.
struct Bound {
  int least = 0;  // 0: none
  int most = 0;
  std::size_t tokens = 0;  // 0: there is no bound
};

Bound BoundAt(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at) {
  if (IsPauseAt(tokens, at)) return {};
  Bound longest;
  std::size_t length = 0;
  for (const Role role : {Role::kAtLeast, Role::kMoreThan, Role::kAtMost, Role::kFewerThan}) {
    std::size_t said = words.RoleAt(role, tokens, at);
    if (role == Role::kAtLeast && IsOneOf(WordAt(tokens, at), {"min"})) said = 1;
    if (role == Role::kAtMost && IsOneOf(WordAt(tokens, at), {"max"})) said = 1;
    const NumberMatch number = CountAt(tokens, at + said);
    if (said <= length || number.tokens == 0) continue;
    length = said;
    longest = {0, 0, said + number.tokens};
    if (role == Role::kAtLeast) longest.least = number.value;
    if (role == Role::kMoreThan) longest.least = number.value + 1;
    if (role == Role::kAtMost) longest.most = number.value;
    if (role == Role::kFewerThan) longest.most = number.value - 1;
  }
  return longest;
}

// Whether a bound that has no noun of its own may end here: "at most 10 in all", "at most 10 are
// asleep"; but not in "at most 10 trees", "at most 8 m/s".
bool MayEndAt(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at) {
  if (IsPauseAt(tokens, at)) return true;
  return IsOneOf(WordAt(tokens, at), {"are", "is", "and", "should", "must", "while", "who"}) ||
         words.states.LengthAt(tokens, at) > 0 || words.RoleAt(Role::kIn, tokens, at) > 0 ||
         words.RoleAt(Role::kNear, tokens, at) > 0 ||
         (WordAt(tokens, at) == "in" && IsOneOf(WordAt(tokens, at + 1), {"all", "total"})) ||
         IsOneOf(WordAt(tokens, at), {"altogether", "overall"});
}

// "At least 5 but at most 10 sheep", "more than ten sheep, but no more than twenty": between 5 and
// 10 sheep, between 11 and 20 sheep.
void JoinBounds(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const Bound first = BoundAt(words, *tokens, at);
    if (first.tokens == 0) continue;
    const std::size_t noun_at = at + first.tokens;
    const std::size_t noun = NounAt(words, *tokens, noun_at);
    std::size_t next = noun_at + noun;
    if (next < tokens->size() && (*tokens)[next].text == ",") ++next;
    while (IsOneOf(WordAt(*tokens, next), {"but", "and", "or", "yet", "though", "also"})) ++next;
    const Bound second = BoundAt(words, *tokens, next);
    const int least = std::max(first.least, second.least);
    const int most = std::max(first.most, second.most);
    const bool sides = first.least + second.least == least && first.most + second.most == most;
    if (second.tokens == 0 || !sides || least == 0 || least >= most) continue;
    std::size_t end = next + second.tokens;
    const std::size_t own = NounAt(words, *tokens, end);
    if (noun > 0 && IsOneOf(WordAt(*tokens, end), {"of"}) && WordAt(*tokens, end + 1) == "them") {
      end += 2;
    }
    // Two kinds are bounded apart: "at least 5 sheep and at most 10 goblins".
    if ((noun > 0) == (own > 0) && !(noun == 0 && IsPauseAt(*tokens, end))) continue;
    if (noun > 0 && own == 0 && !MayEndAt(words, *tokens, end)) continue;
    const Token beside = (*tokens)[at];
    EraseTokens(tokens, noun_at + noun, end - noun_at - noun);
    EraseTokens(tokens, at, first.tokens);
    InsertTokens(tokens, at,
                 {WordLike("between", beside), NumberLike(least, beside), WordLike("and", beside),
                  NumberLike(most, beside)});
    at += 3;
  }
}

// "The total number of agents must not exceed 40", "the number of sheep should be at least ten": at
// most 40 agents in total, at least ten sheep.
void SayNumberOf(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const bool number = IsOneOf(WordAt(*tokens, at), {"number", "count"}) &&
                        WordAt(*tokens, at + 1) == "of" && !IsPauseAt(*tokens, at + 2);
    const std::size_t species = number ? words.species.LengthAt(*tokens, at + 2) : 0;
    if (species == 0) continue;
    std::size_t next = at + 2 + species;
    bool denied = false;
    while (IsOneOf(WordAt(*tokens, next), {"must", "should", "may", "can", "shall", "will", "is",
                                           "be", "to", "stay", "remain", "has", "not", "never"})) {
      // "no more than" is a bound of its own.
      if (words.RoleAt(Role::kAtMost, *tokens, next) > 1) break;
      if (words.RoleAt(Role::kAtLeast, *tokens, next) > 1) break;
      denied = denied || IsOneOf(WordAt(*tokens, next), {"not", "never"});
      ++next;
    }
    const bool exceeds = denied && WordAt(*tokens, next) == "exceed";
    const std::size_t count = exceeds ? CountAt(*tokens, next + 1).tokens : 0;
    const Bound bound = denied ? Bound{} : BoundAt(words, *tokens, next);
    const std::size_t end = next + std::max(bound.tokens, count > 0 ? count + 1 : 0);
    if (end == next || !(IsPauseAt(*tokens, end) || WordAt(*tokens, end) == "and")) continue;
    std::size_t first = at;
    while (first > 0 && IsOneOf(WordAt(*tokens, first - 1), {"the", "total", "overall", "whole"})) {
      --first;
    }
    const Token beside = (*tokens)[at];
    std::vector<Token> said = TokensBetween(*tokens, next + (exceeds ? 1 : 0), end);
    if (exceeds) said.insert(said.begin(), {WordLike("at", beside), WordLike("most", beside)});
    for (std::size_t i = at + 2; i < at + 2 + species; ++i) said.push_back((*tokens)[i]);
    const std::size_t categories =
        words.species.At(*tokens, at + 2).rows.front()->categories.size();
    if (categories == EnumNames(AgentCategory{}).size()) {
      said.push_back(WordLike("in", beside));
      said.push_back(WordLike("total", beside));
    }
    EraseTokens(tokens, first, end - first);
    InsertTokens(tokens, first, said);
    at = first + said.size() - 1;
  }
}

}  // namespace

void MendRanges(const EnvironmentWords& words, std::string_view instruction,
                std::vector<Token>* tokens) {
  SayPlus(instruction, tokens);
  SayTolerances(words, instruction, tokens);
  JoinBounds(words, tokens);
  SayNumberOf(words, tokens);
}

}  // namespace latticeworld
