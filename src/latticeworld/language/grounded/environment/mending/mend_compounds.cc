#include "latticeworld/language/grounded/environment/mending/mend_compounds.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// A word for an animal, and what it makes a word of something else with.
bool IsCompound(std::string_view animal, std::string_view next) {
  if (IsOneOf(next, {"eyed", "hearted", "headed", "faced", "legged", "footed"})) {
    return IsOneOf(animal, {"eagle", "hawk", "lynx", "lion", "cat", "wolf", "fox", "bull"});
  }
  if (IsOneOf(animal, {"horse", "mare"})) {
    return IsOneOf(next, {"chestnut", "chestnuts", "radish", "mint", "power", "flies", "tails"});
  }
  if (animal == "wolf") return IsOneOf(next, {"moon", "moons", "hour", "grey"});
  if (IsOneOf(animal, {"sheep", "mackerel", "lamb"})) {
    return IsOneOf(next, {"cloud", "clouds", "sky", "fescue"});
  }
  if (IsOneOf(animal, {"dog", "hound"})) return IsOneOf(next, {"rose", "roses", "wood", "daisies"});
  if (IsOneOf(animal, {"tiger", "day"})) return IsOneOf(next, {"lily", "lilies"});
  if (animal == "fox") return IsOneOf(next, {"glove", "gloves", "tail", "tails"});
  if (animal == "cat") return IsOneOf(next, {"tail", "tails"});
  if (animal == "bear") return IsOneOf(next, {"garlic", "berries"});
  return animal == "goose" && IsOneOf(next, {"berries", "bumps"});
}

// "Horse chestnuts", "a wolf moon", "eagle-eyed guards", "a family-friendly look": chestnuts, a
// moon, guards, a look; but "the eagle eyed the sheep", "the dogs are friendly".
void DropParts(const EnvironmentWords& words, std::string_view instruction,
               std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const std::string_view next = WordAt(*tokens, at + 1);
    const std::size_t gap = (*tokens)[at].end;
    const bool hyphen = gap < instruction.size() && instruction[gap] == '-';
    // "the park is dog friendly", but "a dog friendly and calm"
    const bool is =
        at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"is", "are"}) && IsPauseAt(*tokens, at + 2);
    const bool thing =
        IsOneOf(WordAt(*tokens, at + 2),
                {"look", "farm", "place", "park", "village", "town", "house", "world", "scene",
                 "atmosphere", "environment", "style", "road", "mood"});
    const bool friendly = next == "friendly" && (hyphen || is || thing) &&
                          !WordAt(*tokens, at).empty() && words.species.LengthAt(*tokens, at) == 1;
    if (!friendly && !IsCompound(WordAt(*tokens, at), next)) continue;
    const bool trait =
        friendly || IsOneOf(next, {"eyed", "hearted", "headed", "faced", "legged", "footed"});
    const bool verb =
        IsOneOf(WordAt(*tokens, at + 2), {"the", "a", "his", "her", "its", "their", "them", "him"});
    if (trait && verb) continue;
    // "a fox headed into the forest"
    const bool named = !IsPauseAt(*tokens, at + 2) && words.species.LengthAt(*tokens, at + 2) > 0;
    if (trait && !hyphen && !friendly && !named) continue;
    // "the horse flies along the road", "the dog rose and ran"
    const bool led = at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"the", "a", "one", "this", "my",
                                                                 "our", "his", "her", "white"});
    const bool flies = next == "flies" &&
                       (led || IsOneOf(WordAt(*tokens, at + 2),
                                       {"along", "over", "in", "into", "to", "through", "across",
                                        "and", "when", "from", "by", "on", "above", "away"}));
    const bool rose = next == "rose" && IsOneOf(WordAt(*tokens, at + 2),
                                                {"and", "when", "from", "to", "up", "slowly"});
    if (!hyphen && (flies || rose)) continue;
    // At the head of a clause "guards" alone would be a verb.
    const bool head = at == 0 || IsPauseAt(*tokens, at - 1);
    if (trait && head && !friendly) {
      ReplaceTokens(tokens, at, 2, {"some"});
    } else {
      EraseTokens(tokens, at, trait ? 2 : 1);
    }
  }
}

// "It is raining cats and dogs": it is raining. "A cock crows": dawn. "Blade Runner": cyberpunk.
void MendIdioms(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const std::string_view word = WordAt(*tokens, at);
    const std::string_view next = WordAt(*tokens, at + 1);
    if (word == "cats" && next == "and" && WordAt(*tokens, at + 2) == "dogs" && at > 0 &&
        IsOneOf(WordAt(*tokens, at - 1), {"raining", "rains", "rained"})) {
      EraseTokens(tokens, at, 3);
      continue;
    }
    if (word == "blade" && next == "runner") ReplaceTokens(tokens, at, 2, {"cyberpunk"});
    const bool cock = IsOneOf(word, {"cock", "cocks", "rooster", "roosters", "cockerel"});
    if (cock && IsOneOf(next, {"crow", "crows", "crowing"})) {
      ReplaceTokens(tokens, at, 2, {"dawn"});
    }
    if (cock && IsOneOf(next, {"is", "are"}) && WordAt(*tokens, at + 2) == "crowing") {
      ReplaceTokens(tokens, at, 3, {"dawn"});
    }
  }
}

bool IsFlyAt(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(WordAt(tokens, at), {"fly", "flies", "flying", "flew"});
}

// How many words name people who may fly something, right before `end`; 0: none.
std::size_t PeopleBefore(const EnvironmentWords& words, const std::vector<Token>& tokens,
                         std::size_t end) {
  if (end == 0 || WordAt(tokens, end - 1).empty()) return 0;
  const auto who = words.species.At(tokens, end - 1);
  if (who.tokens != 1) return 0;
  const AgentCategory category = who.rows.front()->categories.front();
  const bool people =
      category == AgentCategory::kHumanoidRobot || category == AgentCategory::kAncientWarrior;
  return people ? 1 : 0;
}

// "The kids fly kites", "a boy is flying his kite": the kids, a boy. "A boy flies a drone": a boy.
// A drone flying.
void MendFlyers(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    if (!IsFlyAt(*tokens, at)) continue;
    std::size_t noun = at + 1;
    while (IsOneOf(WordAt(*tokens, noun),
                   {"a", "an", "the", "their", "his", "her", "its", "two", "three", "some", "small",
                    "red", "paper", "colourful", "colorful", "big", "many"})) {
      ++noun;
    }
    std::size_t verb = at;
    if (IsOneOf(WordAt(*tokens, at - 1), {"is", "are", "who", "that"})) --verb;
    if (IsOneOf(WordAt(*tokens, noun), {"kite", "kites"})) {
      // "over the lake fly kites", which are birds
      if (PeopleBefore(words, *tokens, verb) == 0) continue;
      EraseTokens(tokens, verb, noun + 1 - verb);
      continue;
    }
    if (PeopleBefore(words, *tokens, verb) == 0 || IsPauseAt(*tokens, noun)) continue;
    const auto flown = words.species.At(*tokens, noun);
    const bool drone = flown.tokens > 0 && flown.rows.front()->categories.size() == 1 &&
                       flown.rows.front()->categories.front() == AgentCategory::kAerialRobot;
    if (!drone) continue;
    InsertTokens(tokens, noun + flown.tokens, {WordLike("flying", (*tokens)[at])});
    const Token stop = StopLike((*tokens)[verb]);
    EraseTokens(tokens, verb, at + 1 - verb);
    InsertTokens(tokens, verb, {stop});
  }
}

// "The turkey is in the oven", "roast lamb on the table": nothing.
void DropMeals(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"turkey", "goose", "lamb", "chicken", "duck", "roast"})) {
      continue;
    }
    std::size_t place = at + 1;
    while (place < at + 4 &&
           IsOneOf(WordAt(*tokens, place), {"is", "lamb", "turkey", "goose", "duck", "roasting",
                                            "already", "still", "chicken"})) {
      ++place;
    }
    const bool in = IsOneOf(WordAt(*tokens, place), {"in", "on", "for"});
    std::size_t noun = place + 1;
    if (IsOneOf(WordAt(*tokens, noun), {"the", "our", "a"})) ++noun;
    const bool meal = in && IsOneOf(WordAt(*tokens, noun), {"oven", "table", "dinner", "lunch",
                                                            "menu", "pot", "plate", "plates"});
    const bool ends = IsPauseAt(*tokens, noun + 1) ||
                      IsOneOf(WordAt(*tokens, noun + 1), {"and", "while", "but", "already"});
    if (meal && ends) EraseTokens(tokens, at, noun + 1 - at);
  }
}

}  // namespace

void MendCompounds(const EnvironmentWords& words, std::string_view instruction,
                   std::vector<Token>* tokens) {
  DropParts(words, instruction, tokens);
  MendIdioms(tokens);
  MendFlyers(words, tokens);
  DropMeals(tokens);
}

}  // namespace latticeworld
