#include "latticeworld/language/grounded/environment/mending/amounts/mend_nones.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool EndsWith(std::string_view word, std::string_view end) {
  return word.size() > end.size() && word.substr(word.size() - end.size()) == end;
}

// Whether a clause may begin here.
bool BeginsAt(const std::vector<Token>& tokens, std::size_t at) {
  return at == 0 || IsPauseAt(tokens, at - 1) ||
         IsOneOf(WordAt(tokens, at - 1), {"and", "but", "so", "while", "where", "that", "because"});
}

// Whether agents of the same category as those at `noun` are asked for elsewhere than in
// [first, last): "twelve goblins. No goblin attacks"; not "there are no goblins".
bool IsNamedElsewhere(const EnvironmentWords& words, const std::vector<Token>& tokens,
                      std::size_t noun, std::size_t first, std::size_t last) {
  const AgentCategory category = words.species.At(tokens, noun).rows.front()->categories.front();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if ((i >= first && i < last) || WordAt(tokens, i).empty()) continue;
    if (IsOneOf(WordAt(tokens, i), {"empty", "deserted", "quiet", "silent"})) return false;
  }
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    // "no goblin attacks the village, but three patrol", "no goblin attacks, they sleep"
    const NumberMatch number = i < last ? NumberMatch{} : MatchNumber(tokens, i);
    const std::size_t behind = i + number.tokens;
    if (number.tokens > 0 && !IsPauseAt(tokens, behind) &&
        (words.states.LengthAt(tokens, behind) > 0 ||
         words.RoleAt(Role::kNear, tokens, behind) > 0 ||
         words.RoleAt(Role::kIn, tokens, behind) > 0 ||
         words.RoleAt(Role::kOfThem, tokens, behind) > 0) &&
        words.species.LengthAt(tokens, behind) == 0) {
      return true;
    }
    if (i >= last && i < last + 8 && IsOneOf(WordAt(tokens, i), {"they", "them"})) return true;
    if ((i >= first && i < last) || WordAt(tokens, i).empty()) continue;
    const auto other = words.species.At(tokens, i);
    if (other.tokens == 0 || other.rows.front()->categories.front() != category) continue;
    bool denied = false;
    for (std::size_t k = i > 3 ? i - 3 : 0; k < i; ++k) {
      if (IsPauseAt(tokens, k)) denied = false;
      denied = denied || IsOneOf(WordAt(tokens, k), {"no", "not", "without", "never"});
    }
    if (!denied) return true;
  }
  return false;
}

// "No goblin is attacking", "no goblin attacks" where goblins are told, "not a goblin attacks": the
// goblins are not attacking, the goblins do not attacks; but "no goblins" denies them.
void MendNoOneDoes(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (!BeginsAt(*tokens, at)) continue;
    std::size_t noun = at + 1;
    if (WordAt(*tokens, at) == "not" && IsOneOf(WordAt(*tokens, at + 1), {"a", "one"})) {
      noun = at + (WordAt(*tokens, at + 2) == "single" ? 3 : 2);
    } else if (WordAt(*tokens, at) != "no") {
      continue;
    }
    if (IsPauseAt(*tokens, noun)) continue;
    const auto who = words.species.At(*tokens, noun);
    const std::size_t verb = noun + who.tokens;
    if (who.tokens == 0 || IsPauseAt(*tokens, verb) || !who.rows.front()->exact) continue;
    const bool is = IsOneOf(WordAt(*tokens, verb), {"is", "was"});
    const std::size_t state = verb + (is ? 1 : 0);
    const std::string name((*tokens)[verb - 1].text);
    const bool one = Singular(name) == name;
    // "no goblin guards", but "no goblin guards the village", "no drone flies".
    const bool noun_too = state < tokens->size() && words.species.LengthAt(*tokens, state) > 0 &&
                          WordAt(*tokens, state) != "flies" && WordAt(*tokens, state + 1) != "the";
    const bool does = state < tokens->size() && words.states.LengthAt(*tokens, state) > 0 &&
                      (is || (EndsWith(WordAt(*tokens, state), "s") && !noun_too));
    if (!one || !does) continue;
    // "no goblin camps"; "no whale swims in the lake" says that none is there.
    const std::size_t next = state + words.states.LengthAt(*tokens, state);
    bool placed = false;
    for (std::size_t i = state + 1; i <= next; ++i) {
      placed = placed || words.RoleAt(Role::kIn, *tokens, i) > 0 ||
               words.RoleAt(Role::kNear, *tokens, i) > 0;
    }
    if (placed || (!is && words.RoleAt(Role::kAfterSpecies, *tokens, state) > 0)) continue;
    // "No goblin attacks" alone says that there are none.
    if (!is && !IsNamedElsewhere(words, *tokens, noun, at, state + 1)) continue;
    if (name != "sheep") {
      Token plural = (*tokens)[verb - 1];
      plural.text += "s";
      if (who.tokens == 1 && words.species.LengthAt({plural}, 0) == 0) continue;
      (*tokens)[verb - 1] = plural;
    }
    if (is) {
      ReplaceTokens(tokens, verb, 1, {"are", "not"});
    } else {
      InsertTokens(tokens, verb,
                   {WordLike("do", (*tokens)[verb]), WordLike("not", (*tokens)[verb])});
    }
    ReplaceTokens(tokens, at, noun - at, {"the"});
  }
}

// What may be done to agents or to land that are there all the same.
bool IsDoneToAt(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(
      WordAt(tokens, at),
      {"watches",   "watching",    "guards",    "guarding",    "protects",   "protecting",
       "attacks",   "attacking",   "tends",     "tending",     "herds",      "herding",
       "chases",    "chasing",     "hunts",     "hunting",     "follows",    "following",
       "threatens", "defends",     "defending", "disturbs",    "disturbing", "rides",
       "riding",    "threatening", "controls",  "controlling", "minds",      "minding"});
}

// The words that say who is left out begin at `at`; 0 tokens: the sentence has no such words.
struct Except {
  std::size_t at = 0;
  std::size_t tokens = 0;
};

// "Except two drones", "but ten goblins from the forest".
Except ExceptBehind(const EnvironmentWords& words, const std::vector<Token>& tokens,
                    std::size_t at) {
  for (; !IsStopAt(tokens, at); ++at) {
    if (IsOneOf(WordAt(tokens, at), {"except", "save", "excepting", "excluding", "bar"})) {
      return {at, WordAt(tokens, at + 1) == "for" ? 2U : 1U};
    }
    const bool from = IsOneOf(WordAt(tokens, at), {"apart", "aside"});
    const bool than = WordAt(tokens, at) == "other";
    if (from && WordAt(tokens, at + 1) == "from") return {at, 2};
    if (than && WordAt(tokens, at + 1) == "than") return {at, 2};
    if (WordAt(tokens, at) != "but") continue;
    std::size_t noun = at + 1;
    if (IsOneOf(WordAt(tokens, noun), {"the", "a", "an", "for", "some", "our"})) ++noun;
    noun += MatchNumber(tokens, noun).tokens;
    if (IsOneOf(WordAt(tokens, noun), {"old", "lone", "single", "few", "small", "big"})) ++noun;
    const std::size_t species = IsPauseAt(tokens, noun) ? 0 : words.species.LengthAt(tokens, noun);
    const std::size_t end = noun + species;
    if (species > 0 && (IsPauseAt(tokens, end) || words.RoleAt(Role::kIn, tokens, end) > 0 ||
                        WordAt(tokens, end) == "from")) {
      return {at, WordAt(tokens, at + 1) == "for" ? 2U : 1U};
    }
  }
  return {};
}

// "Nobody watches the sheep", "nobody is guarding the village": the sheep, the village. "Nobody
// guards the road except two drones": two drones guards the road.
void MendNobodyDoes(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    std::size_t verb = at;
    if (WordAt(*tokens, at) == "nobody") verb = at + 1;
    if (WordAt(*tokens, at) == "no" && WordAt(*tokens, at + 1) == "one") verb = at + 2;
    if (verb == at || !BeginsAt(*tokens, at)) continue;
    if (IsOneOf(WordAt(*tokens, verb), {"is", "ever"})) ++verb;
    const bool object =
        IsOneOf(WordAt(*tokens, verb + 1), {"the", "these", "those", "them", "my", "our", "it"});
    if (!IsDoneToAt(*tokens, verb) || !object) continue;
    if (const Except except = ExceptBehind(words, *tokens, verb); except.tokens > 0) {
      const std::size_t end = PauseAfter(*tokens, except.at + except.tokens);
      if (end == except.at + except.tokens) continue;     // nobody is excepted
      std::size_t place = except.at + except.tokens + 1;  // which stays behind
      while (place < end && words.RoleAt(Role::kIn, *tokens, place) == 0 &&
             words.RoleAt(Role::kNear, *tokens, place) == 0 && WordAt(*tokens, place) != "from") {
        ++place;
      }
      const std::vector<Token> who = TokensBetween(*tokens, except.at + except.tokens, place);
      EraseTokens(tokens, except.at, place - except.at);
      EraseTokens(tokens, at, verb - at);
      InsertTokens(tokens, at, who);
      continue;
    }
    EraseTokens(tokens, at, verb + 1 - at);
  }
}

// "Ten rovers, none moving", "not one of them moving": none of them moving.
void MendNoneMoving(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    const bool not_one = WordAt(*tokens, at) == "not" && WordAt(*tokens, at + 1) == "one" &&
                         WordAt(*tokens, at + 2) == "of";
    const bool single = WordAt(*tokens, at) == "not" && WordAt(*tokens, at + 1) == "a" &&
                        WordAt(*tokens, at + 2) == "single" && WordAt(*tokens, at + 3) == "one" &&
                        WordAt(*tokens, at + 4) == "of";
    const std::size_t of = at + (single ? 4 : 2);
    if ((not_one || single) && IsOneOf(WordAt(*tokens, of + 1), {"them", "these", "those"})) {
      std::size_t state = of + 2;
      if (IsOneOf(WordAt(*tokens, state), {"is", "are"})) ++state;
      // "perched, not one of them in the air" says no more than before.
      bool told = false;
      for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i) {
        told = told || words.states.LengthAt(*tokens, i) > 0;
      }
      if (!told && state < tokens->size() && words.states.LengthAt(*tokens, state) > 0) {
        ReplaceTokens(tokens, at, of - at, {"none"});
      }
      continue;
    }
    if (WordAt(*tokens, at) != "none") continue;
    if (!IsPauseAt(*tokens, at - 1) && !IsOneOf(WordAt(*tokens, at - 1), {"and", "but", "with"})) {
      continue;
    }
    std::size_t state = at + 1;
    if (WordAt(*tokens, state) == "of" && WordAt(*tokens, state + 1) == "them") state += 2;
    const bool of_them = state > at + 1;
    if (IsOneOf(WordAt(*tokens, state), {"is", "are"})) ++state;
    const bool ground = WordAt(*tokens, state) == "on" && WordAt(*tokens, state + 2) == "ground";
    if (IsPauseAt(*tokens, state)) continue;
    bool elsewhere = false;  // "five eagles in the trees, none on the ground"
    for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i) {
      elsewhere = elsewhere || words.RoleAt(Role::kIn, *tokens, i) > 0 ||
                  words.states.LengthAt(*tokens, i) > 0;
    }
    if (ground && elsewhere) continue;
    if (ground) {
      ReplaceTokens(tokens, at, state + 3 - at, {"all", "in", "the", "air"});
      continue;
    }
    const bool air = WordAt(*tokens, state) == "in" && WordAt(*tokens, state + 1) == "the" &&
                     IsOneOf(WordAt(*tokens, state + 2), {"air", "sky"});
    if (air) {
      ReplaceTokens(tokens, at, state + 3 - at, {"all", "on", "the", "ground"});
      continue;
    }
    if (of_them || words.states.LengthAt(*tokens, state) == 0) continue;
    const Token beside = (*tokens)[at];
    InsertTokens(tokens, at + 1, {WordLike("of", beside), WordLike("them", beside)});
  }
}

// How many tokens tell the kind of all robots by their gear: "wheeled", "on wheels"; 0: none.
std::size_t GearAt(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"wheeled", "legged", "aerial", "humanoid"})) return 1;
  if (!IsOneOf(WordAt(tokens, at), {"on", "with"})) return 0;
  const std::size_t gear = at + 1 + MatchNumber(tokens, at + 1).tokens;
  const bool is = IsOneOf(WordAt(tokens, gear), {"wheels", "legs", "rotors", "propellers"});
  return is ? gear + 1 - at : 0;
}

// "Ten robots, all of them wheeled", "..., all drones": ten wheeled robots, ten drones.
void MendAllOfKind(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::size_t number = MatchNumber(*tokens, at).tokens;
    const std::size_t noun = at + number;
    if (number == 0 || IsPauseAt(*tokens, noun)) continue;
    const auto kind = words.species.At(*tokens, noun);
    const std::size_t comma = noun + kind.tokens;
    if (kind.tokens == 0 || kind.rows.front()->categories.size() < 2) continue;
    if (comma >= tokens->size() || (*tokens)[comma].kind != TokenKind::kComma) continue;
    std::size_t all = comma + 1;
    if (!IsOneOf(WordAt(*tokens, all), {"all", "each", "every", "both"})) continue;
    ++all;
    if (WordAt(*tokens, all) == "one") ++all;
    if (WordAt(*tokens, all) == "of") all += 2;
    if (IsOneOf(WordAt(*tokens, all), {"are", "is", "being"})) ++all;
    if (IsOneOf(WordAt(*tokens, all), {"a", "an"})) ++all;
    if (IsPauseAt(*tokens, all)) continue;
    const auto species = words.species.At(*tokens, all);
    const std::size_t gear = species.tokens > 0 ? 0 : GearAt(*tokens, all);
    const std::size_t end = all + std::max(species.tokens, gear);
    if (end == all || !IsPauseAt(*tokens, end)) continue;
    const bool robots = IsOneOf(WordAt(*tokens, comma - 1), {"robots", "machines", "robot"});
    if (gear > 0 && !robots) continue;
    std::vector<Token> name = TokensBetween(*tokens, all, end);
    if (species.tokens > 0) {
      const auto& all_kinds = kind.rows.front()->categories;
      const bool among = species.rows.front()->categories.size() == 1 &&
                         std::find(all_kinds.begin(), all_kinds.end(),
                                   species.rows.front()->categories.front()) != all_kinds.end();
      if (!among) continue;
      EraseTokens(tokens, noun, end - noun);
      InsertTokens(tokens, noun, name);
    } else {
      const bool before = gear == 1;
      EraseTokens(tokens, comma, end - comma);
      InsertTokens(tokens, before ? noun : comma, name);
    }
  }
}

}  // namespace

void MendNones(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendNoOneDoes(words, tokens);
  MendNobodyDoes(words, tokens);
  MendNoneMoving(words, tokens);
  MendAllOfKind(words, tokens);
}

}  // namespace latticeworld
