#include "latticeworld/language/grounded/environment/mending/amounts/mend_counts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
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

// "No, change that to cloudy", "switch it to twelve": actually, cloudy; actually, twelve.
void MendChanges(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const bool changes = IsOneOf(WordAt(*tokens, at), {"change", "switch", "correct"}) &&
                         IsOneOf(WordAt(*tokens, at + 1), {"that", "it", "this"}) &&
                         WordAt(*tokens, at + 2) == "to";
    if (!changes) continue;
    const Token comma = CommaLike((*tokens)[at]);
    ReplaceTokens(tokens, at, 3, {"actually"});
    InsertTokens(tokens, at + 1, {comma});
  }
}

// "All they do is wait": they all wait.
void MendAllTheyDo(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const bool all = WordAt(*tokens, at) == "all" && WordAt(*tokens, at + 1) == "they" &&
                     WordAt(*tokens, at + 2) == "do" && WordAt(*tokens, at + 3) == "is";
    if (all) ReplaceTokens(tokens, at, 4, {"they", "all"});
  }
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

// "Twenty or so sheep", "twenty-odd sheep": about twenty. "A couple of dozen": two dozen. "A few
// dozen": dozens of.
void MendRoundNumbers(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (WordAt(*tokens, at) == "couple" && at > 0 && WordAt(*tokens, at - 1) == "a") {
      const std::size_t dozen = at + (WordAt(*tokens, at + 1) == "of" ? 2 : 1);
      if (IsOneOf(WordAt(*tokens, dozen), {"dozen", "hundred", "thousand"}))
        ReplaceTokens(tokens, at - 1, dozen + 1 - at, {"two"});
    }
    if (IsOneOf(WordAt(*tokens, at), {"few", "several"}) &&
        IsOneOf(WordAt(*tokens, at + 1), {"dozen", "hundred", "thousand"})) {
      const std::string many = std::string(WordAt(*tokens, at + 1)) + "s";
      const std::size_t first = at - (at > 0 && WordAt(*tokens, at - 1) == "a" ? 1 : 0);
      ReplaceTokens(tokens, first, at + 2 - first, {many, "of"});
      continue;
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

// "64 heads of sheep", "four more of them": 64 sheep, four more.
void MendHeads(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::size_t next = at + MatchNumber(*tokens, at).tokens;
    if (next == at || WordAt(*tokens, next + 1) != "of") continue;
    if (IsOneOf(WordAt(*tokens, next), {"head", "heads"})) EraseTokens(tokens, next, 2);
    const bool more = WordAt(*tokens, next) == "more" &&
                      IsOneOf(WordAt(*tokens, next + 2), {"them", "these", "those"});
    if (more) EraseTokens(tokens, next + 1, 2);
  }
}

// "Of the latter we have nine": nine of the latter.
void MendOfTheLatter(std::vector<Token>* tokens) {
  for (std::size_t of = 0; of + 5 < tokens->size(); ++of) {
    const bool latter = WordAt(*tokens, of) == "of" && WordAt(*tokens, of + 1) == "the" &&
                        IsOneOf(WordAt(*tokens, of + 2), {"former", "latter"});
    if (!latter || IsPauseAt(*tokens, of + 4)) continue;
    const std::size_t number = of + 5;
    const std::size_t count = MatchNumber(*tokens, number).tokens;
    if (count == 0 || !IsPauseAt(*tokens, number + count)) continue;
    const std::vector<Token> meant = TokensBetween(*tokens, number, number + count);
    EraseTokens(tokens, of + 3, number + count - (of + 3));
    InsertTokens(tokens, of, meant);
  }
}

// "The drones, both of them, ...": two of them, where nothing else was counted or named.
void MendBoth(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t both = 2; both + 2 < tokens->size(); ++both) {
    const bool aside = WordAt(*tokens, both) == "both" && WordAt(*tokens, both + 1) == "of" &&
                       WordAt(*tokens, both + 2) == "them" && IsCommaAt(*tokens, both - 1) &&
                       IsPauseAt(*tokens, both + 3);
    if (!aside) continue;
    bool named = false, several = false;
    for (std::size_t at = both - 1; at-- > 0 && !IsPauseAt(*tokens, at);) {
      const auto species = words.species.At(*tokens, at);
      named = named || (species.tokens > 0 && at + species.tokens == both - 1 &&
                        species.rows.front()->plural);
      const bool joins = WordAt(*tokens, at) == "and" && at > 0 && !IsPauseAt(*tokens, at - 1);
      several = several || joins || MatchNumber(*tokens, at).tokens > 0;
    }
    if (named && !several) (*tokens)[both].text = "two";
  }
}

// The last number before `end` in its sentence, 0: none.
int NumberBefore(const std::vector<Token>& tokens, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && tokens[begin - 1].kind != TokenKind::kStop) --begin;
  int number = 0;
  while (begin < end) {
    const NumberMatch match = MatchNumber(tokens, begin);
    if (match.tokens > 0) number = match.value;
    begin += std::max<std::size_t>(1, match.tokens);
  }
  return number;
}

// The words behind "in three equal bands"; 0: there are none, or of more sizes.
std::size_t BandsAt(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"equal", "even", "equally"})) ++at;
  if (IsOneOf(WordAt(tokens, at), {"big", "large", "strong", "sized"})) ++at;
  if (!IsOneOf(WordAt(tokens, at),
               {"bands", "groups", "parts", "teams", "parties", "squads", "packs", "herds",
                "flocks", "units", "troops", "companies", "lots", "columns", "divisions"})) {
    return 0;
  }
  ++at;
  if (WordAt(tokens, at) == "of" && WordAt(tokens, at + 1) == "equal") at += 3;
  return at;
}

// "120 warriors in three equal bands: one by the lake, one ...": forty of them by the lake, ...
void MendBands(std::vector<Token>* tokens) {
  for (std::size_t in = 1; in + 3 < tokens->size(); ++in) {
    if (!IsOneOf(WordAt(*tokens, in), {"in", "into"})) continue;
    const NumberMatch bands = MatchNumber(*tokens, in + 1);
    const std::size_t pause = BandsAt(*tokens, in + 1 + bands.tokens);
    if (bands.value < 2 || pause == 0 || !IsCommaAt(*tokens, pause)) continue;
    const int whole = NumberBefore(*tokens, in);
    if (whole % bands.value != 0 || whole <= bands.value) continue;
    const std::string each = std::to_string(whole / bands.value);
    std::vector<std::size_t> parts;
    for (std::size_t at = pause + 1; !IsStopAt(*tokens, at); ++at) {
      const bool opens = IsCommaAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
      if (opens && IsOneOf(WordAt(*tokens, at), {"one", "another"})) parts.push_back(at);
    }
    if (static_cast<int>(parts.size()) != bands.value) continue;
    std::reverse(parts.begin(), parts.end());
    for (const std::size_t at : parts) {
      ReplaceTokens(tokens, at, 1, {each, "of", "them"});
      (*tokens)[at].kind = TokenKind::kNumber;
    }
    EraseTokens(tokens, in, pause - in);
  }
}

// "First two rovers, then four more, then the last three": nine rovers.
void MendArrivals(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    constexpr int kMost = 1000000;
    if (WordAt(*tokens, at - 1) != "first") continue;
    const NumberMatch first = MatchNumber(*tokens, at);
    const std::size_t begin = PauseAfter(*tokens, at);
    int sum = first.value;
    std::size_t end = begin;
    while (first.tokens > 0 && IsCommaAt(*tokens, end)) {
      std::size_t next = end + 1;
      while (IsOneOf(WordAt(*tokens, next), {"and", "then", "finally", "the", "last", "later"}))
        ++next;
      const NumberMatch more = MatchNumber(*tokens, next);
      const std::size_t after =
          next + more.tokens + (WordAt(*tokens, next + more.tokens) == "more" ? 1 : 0);
      if (next == end + 1 || more.tokens == 0 || !IsPauseAt(*tokens, after)) break;
      sum = std::min(kMost, sum + more.value);
      end = after;
    }
    if (end == begin) continue;
    EraseTokens(tokens, begin, end - begin);
    Token whole = (*tokens)[at];
    whole.kind = TokenKind::kNumber;
    whole.text = std::to_string(sum);
    EraseTokens(tokens, at - 1, first.tokens + 1);
    InsertTokens(tokens, at - 1, {whole});
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

// Puts "of them" behind numbers after a colon that add up to the number before it and name no
// species of their own.
void MendParts(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t colon = 0; colon < tokens->size(); ++colon) {
    if (!IsCommaAt(*tokens, colon) || (*tokens)[colon].text != ":") continue;
    const int whole = NumberBefore(*tokens, colon);
    int sum = 0;
    int parts = 0;
    std::vector<std::size_t> behind;  // each part's number, but for "the other five"
    for (std::size_t at = colon + 1; at < tokens->size(); ++at) {
      if ((*tokens)[at].kind == TokenKind::kStop) break;
      const bool opens = IsCommaAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
      const bool rest = IsOneOf(WordAt(*tokens, at - 1), {"remaining", "other"});
      const NumberMatch part = MatchNumber(*tokens, at);
      if (!(opens || rest) || part.tokens == 0) continue;
      const std::size_t next = at + part.tokens;
      const bool other = words.species.LengthAt(*tokens, next) > 0 ||
                         words.kinds.LengthAt(*tokens, next) > 0 ||
                         words.assets.LengthAt(*tokens, next) > 0 || WordAt(*tokens, next).empty();
      if (other || WordAt(*tokens, next) == "of") {
        parts = 0;
        break;
      }
      sum += part.value;
      ++parts;
      if (opens) behind.push_back(next);
    }
    if (parts < 2 || sum != whole) continue;
    std::reverse(behind.begin(), behind.end());
    for (const std::size_t at : behind) {
      const Token beside = (*tokens)[at];
      InsertTokens(tokens, at, {WordLike("of", beside), WordLike("them", beside)});
    }
  }
}

}  // namespace

void MendCounts(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendChanges(tokens);
  MendAllTheyDo(tokens);
  MendLateRetractions(tokens);
  MendRetractions(tokens);
  MendRoundNumbers(tokens);
  MendHeads(tokens);
  MendOfTheLatter(tokens);
  MendBoth(words, tokens);
  MendBands(tokens);
  MendArrivals(tokens);
  MendFormer(tokens);
  MendParts(words, tokens);
}

}  // namespace latticeworld
