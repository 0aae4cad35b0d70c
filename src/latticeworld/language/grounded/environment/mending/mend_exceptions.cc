#include "latticeworld/language/grounded/environment/mending/mend_exceptions.h"

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

// "Every robot patrols except the two drones", "every robot except the two drones patrols": all
// robots patrols except the two drones.
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
    const std::size_t agents = said == 0 ? 0 : AgentsAt(words, *tokens, except + said);
    if (agents == 0) continue;
    if (except == at + 2) {
      // "every robot except the two drones patrols"
      const std::size_t verb = except + said + agents;
      const bool does = !IsPauseAt(*tokens, verb) &&
                        (WordAt(*tokens, verb) == "is" || words.states.LengthAt(*tokens, verb) > 0);
      if (!does) continue;
      InsertTokens(tokens, PauseAfter(*tokens, verb), TokensBetween(*tokens, except, verb));
      EraseTokens(tokens, except, verb - except);
    }
    (*tokens)[at].text = "all";
    (*tokens)[at + 1].text += "s";
    if (WordAt(*tokens, at + 2) == "is") (*tokens)[at + 2].text = "are";
  }
}

// Whether tokens [first, last) begin with something that is said of all, or of none.
bool SpeaksOfAll(const std::vector<Token>& tokens, std::size_t first, std::size_t last) {
  constexpr std::size_t kWords = 5;
  for (std::size_t i = first; i < std::min(last, first + kWords); ++i) {
    // "add ten robots, all idle", "five rovers are on the road"
    if (IsPauseAt(tokens, i) || MatchNumber(tokens, i).tokens > 0) return false;
    if (IsOneOf(WordAt(tokens, i), {"add", "put", "place", "give", "show", "make", "who", "which",
                                    "that", "want", "need"}) ||
        (WordAt(tokens, i) == "all" && IsOneOf(WordAt(tokens, i + 1), {"sorts", "kinds"}))) {
      return false;
    }
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
    if (IsStopAt(*tokens, end)) continue;
    std::size_t rest = end + (IsPauseAt(*tokens, end) ? 1 : 0);
    std::vector<Token> who = TokensBetween(*tokens, at + said, end);
    bool acts = false;
    if (rest > end && IsOneOf(WordAt(*tokens, rest), {"who", "which"})) {
      // "apart from two knights, who patrol the village, there are no people"
      const std::size_t relative = PauseAfter(*tokens, rest);
      if (IsStopAt(*tokens, relative)) continue;
      for (std::size_t i = rest; i < relative; ++i) who.push_back((*tokens)[i]);
      rest = relative + 1;
    }
    const std::size_t stop = StopAfter(*tokens, rest);
    if (!SpeaksOfAll(*tokens, rest, stop)) continue;
    for (std::size_t i = at + said + agents; i + 1 < rest; ++i) {
      acts = acts || (!IsPauseAt(*tokens, i) && words.states.LengthAt(*tokens, i) > 0);
    }
    // "apart from the two knights who guard the village, all people are asleep"
    bool others_act = false;
    for (std::size_t i = rest; i < stop; ++i) {
      others_act = others_act || (!IsPauseAt(*tokens, i) && words.states.LengthAt(*tokens, i) > 0);
    }
    const bool apart = acts && others_act;
    if (apart) {
      for (std::size_t i = 0; i < who.size(); ++i) {
        if (IsOneOf(who[i].text, {"who", "which", "that"})) EraseTokens(&who, i, 1);
      }
    }
    const Token except = apart ? StopLike((*tokens)[at]) : WordLike("except", (*tokens)[at]);
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
    // "everyone except goblins, who attack the village, is asleep"
    const std::size_t next = end + 1;
    const bool liked = IsOneOf(WordAt(*tokens, next + 1), {"i", "we"});  // "which I hate"
    const bool goes_on = !IsPauseAt(*tokens, next) &&
                         (IsOneOf(WordAt(*tokens, next), {"who", "which", "that", "is", "are"}) ||
                          words.states.LengthAt(*tokens, next) > 0);
    if (goes_on && !liked) continue;
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
