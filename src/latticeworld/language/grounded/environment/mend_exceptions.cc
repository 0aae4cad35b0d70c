#include "latticeworld/language/grounded/environment/mend_exceptions.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// How many words say "except for", "apart from"; 0: none.
std::size_t ExceptAt(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"except", "save", "excepting", "excluding"})) {
    return WordAt(tokens, at + 1) == "for" ? 2 : 1;
  }
  const bool from =
      IsOneOf(WordAt(tokens, at), {"apart", "aside"}) && WordAt(tokens, at + 1) == "from";
  const bool than = WordAt(tokens, at) == "other" && WordAt(tokens, at + 1) == "than";
  return from || than ? 2 : 0;
}

// How many tokens name agents, with a count or an article, or an adjective, before the noun.
std::size_t AgentsAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                     std::size_t at) {
  std::size_t noun = at;
  while (IsOneOf(WordAt(tokens, noun),
                 {"the", "these", "those", "our", "my", "just", "only", "exactly"})) {
    ++noun;
  }
  noun += MatchNumber(tokens, noun).tokens;
  if (IsOneOf(WordAt(tokens, noun), {"a", "an", "some", "few", "lone", "single"})) ++noun;
  if (IsOneOf(WordAt(tokens, noun), {"few", "lone", "single", "small", "big"})) ++noun;
  if (IsPauseAt(tokens, noun)) return 0;
  const std::size_t species = words.species.LengthAt(tokens, noun);
  return species == 0 ? 0 : noun + species - at;
}

// "Every robot patrols except the two drones": all robots patrols except the two drones.
void MendEvery(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"every", "each"}) || IsPauseAt(*tokens, at + 1)) continue;
    if (at > 0 && !IsPauseAt(*tokens, at - 1) && WordAt(*tokens, at - 1) != "and") continue;
    const auto kind = words.species.At(*tokens, at + 1);
    const bool general = kind.tokens == 1 && kind.rows.front()->categories.size() > 1;
    if (!general || words.quantities.LengthAt(*tokens, at) > 1) continue;
    std::size_t except = at + 2;
    while (!IsPauseAt(*tokens, except) && ExceptAt(*tokens, except) == 0 &&
           WordAt(*tokens, except) != "but") {
      ++except;
    }
    if (IsPauseAt(*tokens, except) && !IsStopAt(*tokens, except)) ++except;
    const std::size_t said = WordAt(*tokens, except) == "but" ? 1 : ExceptAt(*tokens, except);
    if (said == 0 || AgentsAt(words, *tokens, except + said) == 0) continue;
    (*tokens)[at].text = "all";
    (*tokens)[at + 1].text += "s";
    if (WordAt(*tokens, at + 2) == "is") (*tokens)[at + 2].text = "are";
  }
}

// Whether tokens [first, last) say something of all, or of none.
bool SpeaksOfAll(const std::vector<Token>& tokens, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    if (IsOneOf(WordAt(tokens, i), {"no", "nobody", "nothing", "none", "empty", "deserted", "all",
                                    "every", "everyone", "everybody", "everything", "not"})) {
      return true;
    }
  }
  return false;
}

// "Except for two horses there are no animals": there are no animals except two horses.
void MendFronted(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (at > 0 && !IsStopAt(*tokens, at - 1)) continue;
    const std::size_t said = ExceptAt(*tokens, at);
    const std::size_t agents = said == 0 ? 0 : AgentsAt(words, *tokens, at + said);
    if (agents == 0) continue;
    std::size_t end = at + said + agents;  // of who is left out, and where
    while (!IsPauseAt(*tokens, end) &&
           !IsOneOf(WordAt(*tokens, end), {"there", "nobody", "nothing", "no", "all", "every",
                                           "everyone", "everybody", "everything", "it"})) {
      ++end;
    }
    const std::size_t rest = end + (IsPauseAt(*tokens, end) ? 1 : 0);
    const std::size_t stop = StopAfter(*tokens, end);
    if (IsStopAt(*tokens, end) || !SpeaksOfAll(*tokens, rest, stop)) continue;
    const std::vector<Token> who = TokensBetween(*tokens, at + said, end);
    const Token except = WordLike("except", (*tokens)[at]);
    InsertTokens(tokens, stop, who);
    InsertTokens(tokens, stop, {except});
    EraseTokens(tokens, at, rest - at);
  }
}

// "The world is empty except for one whale in the lake": empty but for one whale.
void MendEmpty(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    const bool empty =
        IsOneOf(WordAt(*tokens, at - 1), {"empty", "deserted", "lifeless", "uninhabited", "bare",
                                          "unoccupied", "vacant", "abandoned"});
    const std::size_t said = ExceptAt(*tokens, at);
    if (!empty || said == 0 || AgentsAt(words, *tokens, at + said) == 0) continue;
    ReplaceTokens(tokens, at, said, {"but", "for"});
  }
}

// "Everything but robots": no robots.
void MendEverythingBut(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const bool all = IsOneOf(WordAt(*tokens, at), {"everything", "anything", "anybody", "anyone",
                                                   "everyone", "everybody"});
    const std::size_t said = WordAt(*tokens, at + 1) == "but" ? 1 : ExceptAt(*tokens, at + 1);
    if (!all || said == 0 || WordAt(*tokens, at + 1 + said).empty()) continue;
    const bool begins = at == 0 || IsPauseAt(*tokens, at - 1) ||
                        IsOneOf(WordAt(*tokens, at - 1), {"want", "with", "place", "add", "put"});
    const auto kind = words.species.At(*tokens, at + 1 + said);
    const std::size_t end = at + 1 + said + kind.tokens;
    if (!begins || kind.tokens == 0 || !IsPauseAt(*tokens, end)) continue;
    if (!kind.rows.front()->plural) continue;
    ReplaceTokens(tokens, at, 1 + said, {"no"});
  }
}

}  // namespace

void MendExceptions(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendEvery(words, tokens);
  MendFronted(words, tokens);
  MendEmpty(words, tokens);
  MendEverythingBut(words, tokens);
}

}  // namespace latticeworld
