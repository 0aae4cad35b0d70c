#include "latticeworld/language/grounded/environment/mending/amounts/mend_numerals.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

constexpr std::array<std::string_view, 13> kNumberWords = {
    "zero",  "one",   "two",  "three", "four",   "five",  "six",
    "seven", "eight", "nine", "ten",   "eleven", "twelve"};

// "Two point five metres": 2.5 metres.
void MendPoints(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const NumberMatch whole = MatchNumber(*tokens, at);
    const std::size_t point = at + whole.tokens;
    if (whole.tokens == 0 || WordAt(*tokens, point) != "point") continue;
    std::string decimal = std::to_string(whole.value) + ".";
    std::size_t end = point + 1;
    for (; end < tokens->size(); ++end) {
      const NumberMatch digit = MatchNumber(*tokens, end);
      if (digit.tokens != 1 || digit.value > 9) break;
      decimal += std::to_string(digit.value);
    }
    if (end == point + 1) continue;
    const Token number = {TokenKind::kNumber, decimal, (*tokens)[at].begin, (*tokens)[end - 1].end};
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, {number});
  }
}

// "On 4 legs", "all 4 corners", "between the 2": with words for such small numbers.
void MendDigits(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    Token& token = (*tokens)[at];
    if (token.kind != TokenKind::kNumber || token.text.size() > 2 ||
        token.text.find('.') != std::string::npos) {
      continue;
    }
    const std::size_t value = static_cast<std::size_t>(MatchNumber(*tokens, at).value);
    if (value == 0 || value >= kNumberWords.size()) continue;
    const bool parts =
        IsOneOf(WordAt(*tokens, at + 1), {"legs", "wheels", "rotors", "corners", "sides", "edges"});
    const bool named = at > 1 && IsOneOf(WordAt(*tokens, at - 1), {"the", "these", "those"}) &&
                       IsOneOf(WordAt(*tokens, at - 2), {"between", "of", "beside", "behind"}) &&
                       IsPauseAt(*tokens, at + 1);
    if (parts || named) token = WordLike(kNumberWords[value], token);
  }
}

// The words for a share in percent; none: there are none.
std::vector<std::string_view> ShareWords(const NumberMatch& percent) {
  switch (percent.value) {
    case 10:
      return {"a", "tenth"};
    case 20:
      return {"a", "fifth"};
    case 25:
      return {"a", "quarter"};
    case 33:
      return {"a", "third"};
    case 50:
      return {"half"};
    case 66:
    case 67:
      return {"two", "thirds"};
    case 75:
      return {"three", "quarters"};
    default:
      return {};
  }
}

// Whether a share in percent is said of agents by what follows it, or comes before.
bool IsShareOfAgents(const EnvironmentWords& words, const std::vector<Token>& tokens,
                     std::size_t first, std::size_t end) {
  if (words.RoleAt(Role::kOfThem, tokens, end) > 0) return true;
  if (first > 0 && IsOneOf(WordAt(tokens, first - 1), {"which", "whom"})) return true;
  if (WordAt(tokens, end) != "of") {
    return IsOneOf(WordAt(tokens, end), {"are", "is"}) ||
           (end < tokens.size() && words.states.LengthAt(tokens, end) > 0);
  }
  const bool definite = IsOneOf(WordAt(tokens, end + 1), {"the", "all", "our", "my", "these"});
  return definite && end + 2 < tokens.size() &&
         (words.species.LengthAt(tokens, end + 2) > 0 || MatchNumber(tokens, end + 2).tokens > 0);
}

// "50 % of them", "33 % are resting", "the other 50 % patrol": half of them, a third are resting,
// the other half patrol.
void MendPercents(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const NumberMatch number = MatchNumber(*tokens, at);
    const std::size_t percent = at + number.tokens;
    if (number.tokens == 0 || WordAt(*tokens, percent) != "percent") continue;
    if (at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"other", "remaining"})) {
      ReplaceTokens(tokens, at - 1, number.tokens + 2, {"others"});
      continue;
    }
    std::vector<std::string_view> share = ShareWords(number);
    if (share.empty() || !IsShareOfAgents(words, *tokens, at, percent + 1)) continue;
    if (words.RoleAt(Role::kOfThem, *tokens, percent + 1) == 0 &&
        WordAt(*tokens, percent + 1) != "of")
      share.insert(share.end(), {"of", "them"});
    // The sign of percent is no more to be seen behind the number.
    (*tokens)[at].end = (*tokens)[percent].end;
    ReplaceTokens(tokens, at, number.tokens + 1, share);
  }
}

// A phrase behind a number that makes it a bound; `tokens` 0: there is none.
struct Bound {
  std::string_view at;  // "least" or "most"
  std::size_t tokens = 0;
};

Bound BoundAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) == "or") {
    if (IsOneOf(WordAt(tokens, at + 1), {"more", "over", "above"})) return {"least", 2};
    if (IsOneOf(WordAt(tokens, at + 1), {"fewer", "less", "under"})) return {"most", 2};
    return {};
  }
  if (IsOneOf(WordAt(tokens, at), {"minimum", "min"})) return {"least", 1};
  if (IsOneOf(WordAt(tokens, at), {"maximum", "max", "tops"})) return {"most", 1};
  if (WordAt(tokens, at) != "at") return {};
  std::size_t next = at + 1;
  if (WordAt(tokens, next) == "the") ++next;
  if (WordAt(tokens, next) == "very") ++next;
  if (WordAt(tokens, next) == "least") return {"least", next + 1 - at};
  if (WordAt(tokens, next) == "most") return {"most", next + 1 - at};
  return {};
}

// "Thirty at the very least", "thirty goblins or more", "twenty sheep tops": at least thirty, at
// most twenty.
void MendBounds(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const NumberMatch number = MatchNumber(*tokens, at);
    if (number.tokens == 0) continue;
    const std::size_t end = at + number.tokens;
    const std::size_t noun = IsPauseAt(*tokens, end) ? 0 : words.species.LengthAt(*tokens, end);
    std::size_t said = end;
    if (BoundAt(*tokens, said).tokens == 0) said += noun;
    if (said < tokens->size() && (*tokens)[said].kind == TokenKind::kComma) ++said;
    const Bound bound = BoundAt(*tokens, said);
    const bool ends =
        IsPauseAt(*tokens, said + bound.tokens) ||
        (WordAt(*tokens, said) == "or" && MatchNumber(*tokens, said + bound.tokens).tokens == 0);
    if (bound.tokens == 0 || !ends) continue;
    const Token beside = (*tokens)[at];
    EraseTokens(tokens, said, bound.tokens);
    InsertTokens(tokens, at, {WordLike("at", beside), WordLike(bound.at, beside)});
    at += 2 + number.tokens;
  }
}

// "Seven (7) robot dogs": seven robot dogs.
void MendTwiceSaid(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const NumberMatch said = MatchNumber(*tokens, at);
    const std::size_t open = at + said.tokens;
    if (said.tokens == 0 || open + 2 >= tokens->size() || (*tokens)[open].text != "(") continue;
    const NumberMatch again = MatchNumber(*tokens, open + 1);
    const std::size_t close = open + 1 + again.tokens;
    const bool same = again.tokens > 0 && again.value == said.value && close < tokens->size() &&
                      (*tokens)[close].text == ")";
    if (same) EraseTokens(tokens, open, close + 1 - open);
  }
}

// "Two out of five drones": two of the five drones.
void MendOutOf(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const std::size_t out = at + MatchNumber(*tokens, at).tokens;
    if (out == at || WordAt(*tokens, out) != "out" || WordAt(*tokens, out + 1) != "of") continue;
    const std::size_t noun = out + 2 + MatchNumber(*tokens, out + 2).tokens;
    if (noun == out + 2 || IsPauseAt(*tokens, noun)) continue;
    if (words.species.LengthAt(*tokens, noun) == 0) continue;
    ReplaceTokens(tokens, out, 2, {"of", "the"});
  }
}

// "Every second one of the ten sheep", "every third sheep": half of the ten sheep, a third of the
// sheep.
void MendEverySecond(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::string_view which = WordAt(*tokens, at + 1);
    if (WordAt(*tokens, at) != "every") continue;
    if (!IsOneOf(which, {"second", "third", "fourth", "fifth", "tenth"})) continue;
    const bool one = WordAt(*tokens, at + 2) == "one";
    const bool of = one && WordAt(*tokens, at + 3) == "of";
    if (one && !of) continue;
    std::vector<std::string_view> share = {"half"};
    if (which == "fourth") share = {"a", "quarter"};
    if (which == "third") share = {"a", "third"};
    if (which == "fifth") share = {"a", "fifth"};
    if (which == "tenth") share = {"a", "tenth"};
    share.push_back("of");
    if (!of) share.push_back("the");
    ReplaceTokens(tokens, at, of ? 4 : 2, share);
  }
}

// "Goblins. How many? Thirty.": thirty.
void MendHowMany(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const bool asks = WordAt(*tokens, at) == "how" && WordAt(*tokens, at + 1) == "many" &&
                      (*tokens)[at + 2].text == "?";
    if (asks) EraseTokens(tokens, at, 3);
  }
}

}  // namespace

void MendNumerals(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendPoints(tokens);
  MendTwiceSaid(tokens);
  MendOutOf(words, tokens);
  MendEverySecond(tokens);
  MendDigits(tokens);
  MendPercents(words, tokens);
  MendBounds(words, tokens);
  MendHowMany(tokens);
}

}  // namespace latticeworld
