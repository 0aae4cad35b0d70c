#include "latticeworld/language/grounded/environment/mending/amounts/mend_shares.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

constexpr std::size_t kNoun_tokens = 3;  // from a number to its noun

bool IsArticle(std::string_view word) {
  return IsOneOf(word, {"the", "all", "our", "my", "these", "those", "your"});
}

bool IsBe(std::string_view word) {
  return IsOneOf(word, {"are", "is", "should", "must", "will", "shall", "be", "were"});
}

std::size_t SpeciesAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                      std::size_t at) {
  return IsPauseAt(tokens, at) ? 0 : words.species.LengthAt(tokens, at);
}

std::size_t StateAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                    std::size_t at) {
  return IsPauseAt(tokens, at) ? 0 : words.states.LengthAt(tokens, at);
}

// The words of "percent" or "per cent".
std::size_t PercentAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) == "percent") return 1;
  return WordAt(tokens, at) == "per" && WordAt(tokens, at + 1) == "cent" ? 2 : 0;
}

// Agents that are counted, and where their noun is.
struct Counted {
  int value = 0;  // 0: none are
  std::size_t noun = 0;
};

// The agents that are counted at `at`, as in "50 white sheep".
Counted CountedAt(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at) {
  const NumberMatch number = MatchNumber(tokens, at);
  std::size_t noun = at + number.tokens;
  if (number.tokens == 0 || PercentAt(tokens, noun) > 0) return {};
  for (const std::size_t end = noun + kNoun_tokens; noun < end; ++noun) {
    if (IsPauseAt(tokens, noun) || MatchNumber(tokens, noun).tokens > 0) return {};
    if (words.assets.LengthAt(tokens, noun) > 0) return {};
    if (SpeciesAt(words, tokens, noun) > 0) return {number.value, noun};
  }
  return {};
}

// The agents that were counted last before `at`: in its sentence, or else in the one before.
Counted CountedBefore(const EnvironmentWords& words, const std::vector<Token>& tokens,
                      std::size_t at) {
  int sentences = 0;
  while (at-- > 0 && sentences < 2) {
    if (IsStopAt(tokens, at)) ++sentences;
    // If a number has several words, the first one tells all of it.
    const bool inner = at > 0 && MatchNumber(tokens, at - 1).tokens > 1;
    const Counted counted = inner ? Counted{} : CountedAt(words, tokens, at);
    if (counted.value > 0) return counted;
  }
  return {};
}

// Whether the two nouns may be of the same agents: "20 robots ... the drones".
bool MayBeSame(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t one,
               std::size_t other) {
  const auto first = words.species.At(tokens, one).rows.front()->categories;
  const auto second = words.species.At(tokens, other).rows.front()->categories;
  return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) !=
         first.end();
}

// Whether the last colon before `at` stands behind no agents: "snow: 20 % here, 80 % there".
bool IsOtherLabel(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at) {
  bool colon = false;
  for (std::size_t i = at; i > 0 && !IsStopAt(tokens, i - 1); --i) {
    if (SpeciesAt(words, tokens, i - 1) > 0) return false;
    if (colon && IsPauseAt(tokens, i - 1)) break;
    colon = colon || tokens[i - 1].text == ":";
  }
  return colon;
}

// "50 in all" behind `at`.
int SumBehind(const std::vector<Token>& tokens, std::size_t at) {
  for (; !IsStopAt(tokens, at); ++at) {
    const NumberMatch number = MatchNumber(tokens, at);
    const std::size_t end = at + number.tokens;
    if (number.tokens == 0) continue;
    const bool sum =
        IsOneOf(WordAt(tokens, end), {"altogether", "overall", "total"}) ||
        (WordAt(tokens, end) == "in" && IsOneOf(WordAt(tokens, end + 1), {"all", "total", "sum"}));
    if (sum) return number.value;
    at = end - 1;
  }
  return 0;
}

// A share of agents: of how many it is, and what its words need to name them.
struct Share {
  int whole = 0;         // 0: no agents are meant, or nobody knows how many
  bool pronoun = false;  // "of them" is missing
};

Share ShareAt(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at,
              std::size_t end) {
  const Counted last = CountedBefore(words, tokens, at);
  const int before = last.value;
  if (IsOtherLabel(words, tokens, at)) return {};
  const bool led = at > 0 && IsOneOf(WordAt(tokens, at - 1), {"which", "whom"});
  if (words.RoleAt(Role::kOfThem, tokens, end) > 0 || led) return {before, false};
  if (WordAt(tokens, end) == "of" && IsArticle(WordAt(tokens, end + 1))) {
    const Counted counted = CountedAt(words, tokens, end + 2);
    if (counted.value > 0) return {counted.value, false};
    const bool those = SpeciesAt(words, tokens, end + 2) > 0 && before > 0 &&
                       MayBeSame(words, tokens, last.noun, end + 2);
    return {those ? before : 0, false};
  }
  const int whole = before > 0 ? before : SumBehind(tokens, end);
  if (SpeciesAt(words, tokens, end) > 0 && StateAt(words, tokens, end) == 0) return {whole, false};
  std::size_t next = end;
  while (IsBe(WordAt(tokens, next))) ++next;
  if (SpeciesAt(words, tokens, next) > 0 && next > end) return {whole, true};
  if (StateAt(words, tokens, next) > 0) return {before, true};
  // "50 goblins, 60 % in the forest"
  const bool opens = at > 0 && (IsPauseAt(tokens, at - 1) || WordAt(tokens, at - 1) == "and");
  const bool place = next < tokens.size() && (words.RoleAt(Role::kIn, tokens, next) > 0 ||
                                              words.RoleAt(Role::kNear, tokens, next) > 0);
  bool density = false;
  for (std::size_t i = SentenceBegin(tokens, at); !IsStopAt(tokens, i); ++i) {
    density = density || IsOneOf(WordAt(tokens, i), {"density", "densities", "cover", "coverage",
                                                     "covered", "covers", "dense", "size"});
  }
  return {opens && place && !density ? before : 0, true};
}

// "50 agents, 30 % of them sheep", "60 % of the 50 goblins patrol", "20 robots: 25 % wheeled":
// fifteen of them, thirty of the 50 goblins, five wheeled.
void CountPercents(const EnvironmentWords& words, std::vector<Token>* tokens) {
  struct Edit {
    std::size_t at = 0;
    std::size_t length = 0;
    int count = 0;
    bool pronoun = false;
  };
  std::vector<Edit> edits;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const NumberMatch number = MatchNumber(*tokens, at);
    const std::size_t percent = PercentAt(*tokens, at + number.tokens);
    if (number.tokens == 0 || percent == 0 || number.value > 99) continue;
    const std::size_t length = number.tokens + percent;
    const bool rest = at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"other", "remaining"});
    const Share share = rest ? Share{} : ShareAt(words, *tokens, at, at + length);
    const int count = static_cast<int>((1LL * share.whole * number.value + 50) / 100);
    if (count > 0) edits.push_back({at, length, count, share.pronoun});
    at += length - 1;
  }
  std::reverse(edits.begin(), edits.end());
  for (const Edit& edit : edits) {
    Token& first = (*tokens)[edit.at];
    // The sign of percent is no more to be seen behind the number.
    first = {TokenKind::kNumber, std::to_string(edit.count), first.begin,
             (*tokens)[edit.at + edit.length - 1].end};
    const Token beside = first;
    EraseTokens(tokens, edit.at + 1, edit.length - 1);
    if (!edit.pronoun) continue;
    InsertTokens(tokens, edit.at + 1, {WordLike("of", beside), WordLike("them", beside)});
  }
}

// How many words say "half", "a third", "three quarters", "the other half"; 0: none do.
std::size_t FractionAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) == "half") return 1;
  const bool one = IsOneOf(WordAt(tokens, at), {"a", "one"});
  if (one && IsOneOf(WordAt(tokens, at + 1), {"half", "third", "quarter", "fifth", "tenth"})) {
    return 2;
  }
  const bool several = MatchNumber(tokens, at).tokens == 1;
  return several && IsOneOf(WordAt(tokens, at + 1), {"thirds", "quarters", "fifths", "tenths"}) ? 2
                                                                                                : 0;
}

// Behind two or four agents "a third", "a fifth" is one more.
bool IsOneMore(const std::vector<Token>& tokens, std::size_t at, int whole) {
  int of = 0;
  if (WordAt(tokens, at + 1) == "third") of = 3;
  if (WordAt(tokens, at + 1) == "fifth") of = 5;
  if (WordAt(tokens, at + 1) == "tenth") of = 10;
  return WordAt(tokens, at) == "a" && whole < 2 * of;
}

// "20 goblins, half patrolling, half asleep", "20 sheep, a quarter grazing": half of them each, a
// quarter of them. Only one is "half asleep" by itself.
void NameFractions(const EnvironmentWords& words, std::vector<Token>* tokens) {
  std::size_t shares = 0;  // in this sentence
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) shares = 0;
    const std::size_t fraction = FractionAt(*tokens, at);
    if (fraction == 0) continue;
    const std::size_t end = at + fraction;
    const std::size_t state = StateAt(words, *tokens, end);
    const bool opens =
        at > 0 && (IsPauseAt(*tokens, at - 1) || IsOneOf(WordAt(*tokens, at - 1), {"and", "with"}));
    const bool idiom = StateAt(words, *tokens, at) > fraction && shares == 0;
    const int whole = opens && state > 0 && !idiom ? CountedBefore(words, *tokens, at).value : 0;
    if (whole > 0 && !IsOneMore(*tokens, at, whole)) {
      const Token beside = (*tokens)[end - 1];
      InsertTokens(tokens, end, {WordLike("of", beside), WordLike("them", beside)});
    }
    ++shares;
    at = end - 1;
  }
}

// How many words at `at` say which part of some agents is meant: "most", "a few", "all but two".
std::size_t PartAt(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"most", "some", "many", "several"})) return 1;
  if (WordAt(tokens, at) == "a" && WordAt(tokens, at + 1) == "few") return 2;
  const bool but = WordAt(tokens, at) == "all" &&
                   IsOneOf(WordAt(tokens, at + 1), {"but", "except", "save", "bar"});
  const std::size_t number = but ? MatchNumber(tokens, at + 2).tokens : 0;
  return number > 0 ? 2 + number : FractionAt(tokens, at);
}

// Whether a part of some agents is told to be of a kind: "half are rovers", "a quarter knights".
bool IsOfKindAt(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at) {
  while (IsBe(WordAt(tokens, at))) ++at;
  const std::size_t end = at + 2;  // of an adjective or an article
  for (; at < end && !IsPauseAt(tokens, at) && StateAt(words, tokens, at) == 0; ++at) {
    if (SpeciesAt(words, tokens, at) > 0) return true;
  }
  return false;
}

// "Of the 20 goblins most are asleep": most of the 20 goblins are asleep.
void MendOfThose(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t of = 0; of + 3 < tokens->size(); ++of) {
    if (WordAt(*tokens, of) != "of" || !IsArticle(WordAt(*tokens, of + 1))) continue;
    if (of > 0 && !IsPauseAt(*tokens, of - 1)) continue;
    std::size_t noun = of + 2 + MatchNumber(*tokens, of + 2).tokens;
    const std::size_t species = SpeciesAt(words, *tokens, noun);
    if (species == 0) continue;
    noun += species;
    const std::size_t comma = noun < tokens->size() && (*tokens)[noun].text == "," ? 1 : 0;
    const std::size_t part = PartAt(*tokens, noun + comma);
    if (part == 0 || WordAt(*tokens, noun + comma + part) == "of") continue;
    if (IsOfKindAt(words, *tokens, noun + comma + part)) continue;
    const std::vector<Token> said = TokensBetween(*tokens, noun + comma, noun + comma + part);
    EraseTokens(tokens, noun, comma + part);
    InsertTokens(tokens, of, said);
    of = noun + part;
  }
}

// "All 20 robots but two are patrolling": all but two of the 20 robots are patrolling.
void MendAllButSome(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t all = 0; all + 4 < tokens->size(); ++all) {
    const bool every =
        WordAt(*tokens, all) == "every" && CountedBefore(words, *tokens, all).value > 0;
    if (!every && WordAt(*tokens, all) != "all") continue;
    std::size_t first = all + 1;
    if (WordAt(*tokens, first) == "of") ++first;
    if (IsArticle(WordAt(*tokens, first))) ++first;
    std::size_t noun = first + MatchNumber(*tokens, first).tokens;
    const std::size_t species = SpeciesAt(words, *tokens, noun);
    const std::size_t but = noun + species;
    if (species == 0 || !IsOneOf(WordAt(*tokens, but), {"but", "except", "save", "bar"})) continue;
    const std::size_t number = but + (WordAt(*tokens, but + 1) == "for" ? 2 : 1);
    const std::size_t end = number + MatchNumber(*tokens, number).tokens;
    const bool acts = IsBe(WordAt(*tokens, end)) || StateAt(words, *tokens, end) > 0;
    if (end == number || !acts) continue;
    const Token beside = (*tokens)[all];
    std::vector<Token> said = {WordLike("all", beside), WordLike("but", beside)};
    for (std::size_t i = number; i < end; ++i) said.push_back((*tokens)[i]);
    said.push_back(WordLike("of", beside));
    said.push_back(WordLike("the", beside));
    for (std::size_t i = first; i < but; ++i) said.push_back((*tokens)[i]);
    if (every && said.back().text != "sheep") said.back().text += "s";
    EraseTokens(tokens, all, end - all);
    InsertTokens(tokens, all, said);
  }
}

}  // namespace

void MendShares(const EnvironmentWords& words, std::vector<Token>* tokens) {
  CountPercents(words, tokens);
  NameFractions(words, tokens);
  MendOfThose(words, tokens);
  MendAllButSome(words, tokens);
}

}  // namespace latticeworld
