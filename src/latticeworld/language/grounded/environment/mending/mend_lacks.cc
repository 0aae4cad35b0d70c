#include "latticeworld/language/grounded/environment/mending/mend_lacks.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// Whether a clause may begin here.
bool BeginsAt(const std::vector<Token>& tokens, std::size_t at) {
  return at == 0 || IsPauseAt(tokens, at - 1) ||
         IsOneOf(WordAt(tokens, at - 1), {"and", "but", "so", "while", "where", "that", "because"});
}

// How many words say that there is little of something; 0: none.
std::size_t LittleAt(const std::vector<Token>& tokens, std::size_t at) {
  const std::string_view first = WordAt(tokens, at);
  if (IsOneOf(first, {"hardly", "barely", "scarcely"}) && WordAt(tokens, at + 1) == "any") return 2;
  if (first != "not") return 0;
  std::size_t many = at + 1;
  if (IsOneOf(WordAt(tokens, many), {"too", "so", "that", "very", "really"})) ++many;
  if (IsOneOf(WordAt(tokens, many), {"many", "much"})) return many + 1 - at;
  const bool lot = WordAt(tokens, many) == "a" && WordAt(tokens, many + 1) == "lot" &&
                   WordAt(tokens, many + 2) == "of";
  return lot ? many + 3 - at : 0;
}

// "Not many flowers", "there aren't many flowers", "not much wind", "hardly any people": few
// flowers, there are few flowers, little wind, few people.
void MendFew(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::size_t said = LittleAt(*tokens, at);
    if (said == 0 || IsPauseAt(*tokens, at + said)) continue;
    const bool agents = words.species.LengthAt(*tokens, at + said) > 0;
    const bool wind = IsOneOf(WordAt(*tokens, at + said), {"wind", "breeze"});
    const bool asset =
        words.assets.LengthAt(*tokens, at + said) > 0 && WordAt(*tokens, at + said) != "snow";
    const bool any = WordAt(*tokens, at) != "not";
    if (!agents && (any || (!asset && !wind))) continue;
    ReplaceTokens(tokens, at, said, {wind ? "little" : "few"});
  }
}

// Whether something that may be there, or not, is named here, and how many words name it.
std::size_t ThingAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                    std::size_t at) {
  if (WordAt(tokens, at).empty()) return 0;
  return std::max({words.assets.LengthAt(tokens, at), words.species.LengthAt(tokens, at),
                   words.kinds.LengthAt(tokens, at)});
}

// "Guards: none", "rocks nowhere", "rocks are nowhere": no guards, no rocks.
void MendNowhere(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (at > 0 && !BeginsAt(*tokens, at)) continue;
    const std::size_t thing = ThingAt(words, *tokens, at);
    if (thing == 0) continue;
    std::size_t none = at + thing;
    bool nothing = false;
    if (none < tokens->size() && (*tokens)[none].text == ":") {
      // Others are read well as they are, and may stand before a list.
      const bool verb = words.states.LengthAt(*tokens, at) > 0;
      ++none;
      nothing = verb && IsOneOf(WordAt(*tokens, none), {"none", "no", "zero", "nil"});
    } else {
      if (IsOneOf(WordAt(*tokens, none), {"are", "is"})) ++none;
      nothing = WordAt(*tokens, none) == "nowhere";
    }
    if (!nothing || !IsPauseAt(*tokens, none + 1)) continue;
    EraseTokens(tokens, at + thing, none + 1 - at - thing);
    InsertTokens(tokens, at, {WordLike("no", (*tokens)[at])});
  }
}

// "A robot-free world", "the lake is robot free": a no robot, world; but "knights free the horses",
// "set the horse free".
void MendFree(const EnvironmentWords& words, std::string_view instruction,
              std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const std::size_t thing = IsPauseAt(*tokens, at) ? 0
                                                     : std::max(ThingAt(words, *tokens, at),
                                                                words.coarse.LengthAt(*tokens, at));
    const std::size_t free = at + thing;
    if (thing == 0 || WordAt(*tokens, free) != "free") continue;
    // "an ice-free lake" is read as it is.
    if (words.variants.LengthAt(*tokens, at) > thing) continue;
    const std::size_t gap = (*tokens)[free - 1].end;
    const bool hyphen = gap < instruction.size() && instruction[gap] == '-';
    const bool is =
        at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"is", "are", "stays", "be"}) &&
        (IsPauseAt(*tokens, free + 1) || IsOneOf(WordAt(*tokens, free + 1), {"and", "but"}));
    // "fog free weather", "a robot free zone"
    const auto sky = words.coarse.At(*tokens, at);
    const bool weather = sky.tokens == thing && sky.rows.front()->key == CoarseKey::kWeather &&
                         (at == 0 || WordAt(*tokens, at - 1) != "the");
    const bool land = IsOneOf(WordAt(*tokens, free + 1),
                              {"world", "zone", "area", "place", "village", "forest", "land",
                               "scene", "town", "city", "desert", "map", "environment", "road"});
    const std::string name((*tokens)[free - 1].text);
    if (!(hyphen || is || weather || land) || Singular(name) != name) continue;
    const bool other = IsOneOf(WordAt(*tokens, free + 1), {"the", "a", "to", "of", "from", "them",
                                                           "their", "roaming", "running"});
    if (other) continue;
    const Token beside = (*tokens)[free];
    EraseTokens(tokens, free, 1);
    if (!IsPauseAt(*tokens, free)) InsertTokens(tokens, free, {CommaLike(beside)});
    InsertTokens(tokens, at, {WordLike("no", beside)});
  }
}

// "The village is abandoned", "an abandoned village": deserted. "A deserted road", "the lake is
// deserted": a road, the lake, of which alone it is said.
void MendDeserted(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const bool deserted = WordAt(*tokens, at) == "deserted";
    if (!deserted && WordAt(*tokens, at) != "abandoned") continue;
    std::size_t verb = at;
    while (verb > 0 && IsOneOf(WordAt(*tokens, verb - 1),
                               {"completely", "totally", "entirely", "fully", "long", "now"})) {
      --verb;
    }
    const bool is = verb > 1 && IsOneOf(WordAt(*tokens, verb - 1), {"is", "lies", "looks"});
    const std::string_view land = is ? WordAt(*tokens, verb - 2) : WordAt(*tokens, at + 1);
    if (!deserted) {
      // "an abandoned village where goblins live"
      const std::size_t next = at + (is ? 1 : 2);
      bool lived_in = false;
      for (std::size_t i = next + 1;
           IsOneOf(WordAt(*tokens, next), {"where", "with", "which", "that", "in"}) &&
           !IsStopAt(*tokens, i);
           ++i) {
        lived_in = lived_in || (!IsPauseAt(*tokens, i) && words.species.LengthAt(*tokens, i) > 0);
      }
      if (lived_in) continue;
      if (IsOneOf(land, {"village", "town", "city", "settlement", "hamlet", "world", "place",
                         "suburb", "farm"})) {
        (*tokens)[at].text = "deserted";
      }
      continue;
    }
    if (!IsOneOf(land, {"road", "lake", "street", "path", "river", "bridge", "pond", "lane"})) {
      continue;
    }
    if (is) EraseTokens(tokens, verb - 1, at + 1 - (verb - 1));
    if (!is) EraseTokens(tokens, at, 1);
  }
}

// "It's fine if there are no sheep", "I don't mind if no robots patrol": nothing.
void MendFineIf(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"fine", "ok", "okay", "alright", "mind", "care", "right"}) ||
        !IsOneOf(WordAt(*tokens, at + 1), {"if", "when"})) {
      continue;
    }
    const std::size_t begin = SentenceBegin(*tokens, at);
    std::size_t first = at;
    while (first > begin && !IsPauseAt(*tokens, first - 1)) --first;
    const bool opens = IsOneOf(WordAt(*tokens, first), {"it", "its", "that", "i", "fine", "ok"});
    std::size_t end = at;
    while (!IsPauseAt(*tokens, end) && WordAt(*tokens, end) != "but") ++end;
    bool denies = false, counts = false;
    for (std::size_t i = at + 2; i < end; ++i) {
      const std::size_t number = MatchNumber(*tokens, i).tokens;
      counts = counts || (number > 0 && !IsPauseAt(*tokens, i + number) &&
                          words.species.LengthAt(*tokens, i + number) > 0);
      denies = denies || IsOneOf(WordAt(*tokens, i), {"no", "not", "without", "none", "nobody"});
    }
    if (opens && denies && !counts) EraseTokens(tokens, first, end - first);
  }
}

// Whether another time of day than the night is told anywhere.
bool IsOtherTimeTold(const EnvironmentWords& words, const std::vector<Token>& tokens) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (IsPauseAt(tokens, at)) continue;
    const auto said = words.coarse.At(tokens, at);
    if (said.tokens > 0 && said.rows.front()->key == CoarseKey::kTimeOfDay &&
        said.rows.front()->value != "night") {
      return true;
    }
  }
  return false;
}

// "No moon", "without a moon": moonless, which is no day; but "dawn, without a moon": dawn.
void MendMoonless(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"no", "without"})) continue;
    const std::size_t noun = at + (WordAt(*tokens, at + 1) == "a" ? 2 : 1);
    if (!IsOneOf(WordAt(*tokens, noun), {"moon", "moonlight"})) continue;
    // "no moon base", "no moon yet"
    if (IsOneOf(WordAt(*tokens, noun + 1), {"base", "bases", "landing", "rover", "rovers", "rock",
                                            "rocks", "lander", "dust", "colony", "station"})) {
      continue;
    }
    if (IsOtherTimeTold(words, *tokens)) {
      EraseTokens(tokens, at, noun + 1 - at);
    } else if (WordAt(*tokens, noun + 1) != "yet") {
      ReplaceTokens(tokens, at, noun + 1 - at, {"moonless"});
    }
  }
}

}  // namespace

void MendLacks(const EnvironmentWords& words, std::string_view instruction,
               std::vector<Token>* tokens) {
  MendFew(words, tokens);
  MendNowhere(words, tokens);
  MendFree(words, instruction, tokens);
  MendDeserted(words, tokens);
  MendFineIf(words, tokens);
  MendMoonless(words, tokens);
}

}  // namespace latticeworld
