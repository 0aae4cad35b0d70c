#include "latticeworld/language/grounded/environment/mending/mend_surfaces.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsWetAt(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(WordAt(tokens, at), {"wet", "damp", "moist", "slippery"});
}

// "Stones wet and mossy", "mossy and wet": mossy, which is no rain.
void DropWet(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const std::size_t next = at + 1;
    const bool joint = WordAt(*tokens, next) == "and" || (*tokens)[next].text == ",";
    const std::size_t other = next + (joint ? 1 : 0);
    const bool mossy_first = WordAt(*tokens, at) == "mossy" && IsWetAt(*tokens, other);
    const bool wet_first = IsWetAt(*tokens, at) && WordAt(*tokens, other) == "mossy";
    // "mossy, wet weather"
    const bool ends = IsPauseAt(*tokens, other + 1) ||
                      IsOneOf(WordAt(*tokens, other + 1),
                              {"stones", "stone", "rocks", "rock", "boulders", "pebbles"});
    // "the road is wet and mossy rocks lie around"
    const bool is = at > 0 && (IsOneOf(WordAt(*tokens, at - 1), {"is", "weather", "very"}) ||
                               (*tokens)[at - 1].text == ":");
    if (wet_first && is && !IsPauseAt(*tokens, other + 1) && WordAt(*tokens, other + 1) != "and") {
      continue;
    }
    if (mossy_first && ends) EraseTokens(tokens, next, other + 1 - next);
    if (wet_first) EraseTokens(tokens, at, other - at);
  }
}

// "Sheets of ice cover the lake", "a thick layer of ice lies on the pond": the lake is covered with
// ice.
void MendIce(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const bool sheet = IsOneOf(WordAt(*tokens, at), {"sheet", "sheets", "layer", "layers", "crust",
                                                     "slabs", "slab", "plates", "skin", "film"}) &&
                       WordAt(*tokens, at + 1) == "of" && WordAt(*tokens, at + 2) == "ice";
    if (!sheet) continue;
    std::size_t first = at;
    while (first > 0 && IsOneOf(WordAt(*tokens, first - 1),
                                {"a", "the", "thick", "thin", "big", "large", "great", "solid"})) {
      --first;
    }
    bool denied = false;
    for (std::size_t i = first; i > 0 && !IsPauseAt(*tokens, i - 1); --i) {
      denied = denied ||
               IsOneOf(WordAt(*tokens, i - 1), {"no", "not", "without", "never", "any", "hardly"});
    }
    if (denied) continue;
    if (IsOneOf(WordAt(*tokens, at + 3), {"no", "not", "never", "does", "do"})) {
      EraseTokens(tokens, at, 2);
      continue;
    }
    const std::size_t verb = at + 3;
    std::size_t the = verb + 1;
    if (IsOneOf(WordAt(*tokens, verb), {"lie", "lies", "is", "are", "float", "sits"}) &&
        IsOneOf(WordAt(*tokens, verb + 1), {"on", "over", "upon", "across"})) {
      ++the;
    } else if (!IsOneOf(WordAt(*tokens, verb), {"cover", "covers", "covering", "on", "over"})) {
      // "covered with layers of ice"
      if (words.variants.LengthAt(*tokens, at) < 3) EraseTokens(tokens, at, 2);
      continue;
    }
    // "there is a sheet of ice on the lake", but "two whales break the layer of ice on the lake"
    if (IsOneOf(WordAt(*tokens, verb), {"on", "over"})) {
      if (first > 1 && IsOneOf(WordAt(*tokens, first - 1), {"is", "are", "lies", "lie"}) &&
          WordAt(*tokens, first - 2) == "there") {
        first -= 2;
      }
      const bool begins =
          first == 0 || IsPauseAt(*tokens, first - 1) ||
          IsOneOf(WordAt(*tokens, first - 1), {"and", "but", "so", "while", "with"});
      if (!begins) continue;
    }
    const std::size_t noun = the + (IsOneOf(WordAt(*tokens, the), {"the", "all", "our"}) ? 1 : 0);
    const bool water = IsOneOf(WordAt(*tokens, noun), {"lake", "lakes", "pond", "ponds", "river",
                                                       "water", "stream", "canal"});
    if (!water) continue;
    const Token beside = (*tokens)[noun];
    InsertTokens(tokens, noun + 1,
                 {WordLike("is", beside), WordLike("covered", beside), WordLike("with", beside),
                  WordLike("ice", beside)});
    EraseTokens(tokens, first, the - first);
  }
}

// "The grass is not dense but the forest is": but the forest is dense.
void MendEllipsis(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t but = 3; but + 2 < tokens->size(); ++but) {
    if (!IsOneOf(WordAt(*tokens, but), {"but", "while", "whereas", "though"})) continue;
    const std::size_t noun = but + 1 + (WordAt(*tokens, but + 1) == "the" ? 1 : 0);
    if (IsPauseAt(*tokens, noun)) continue;
    const std::size_t is = noun + words.assets.LengthAt(*tokens, noun);
    if (is == noun || !IsOneOf(WordAt(*tokens, is), {"is", "are"})) continue;
    if (!IsPauseAt(*tokens, is + 1)) continue;
    // What was denied right before.
    std::size_t end = but;
    while (end > 0 && IsPauseAt(*tokens, end - 1)) --end;
    if (end < 2 || WordAt(*tokens, end - 2) != "not") continue;
    if (words.densities.LengthAt(*tokens, end - 1) != 1 &&
        words.variants.At(*tokens, end - 1).tokens != 1) {
      continue;
    }
    const std::vector<Token> quality = TokensBetween(*tokens, end - 1, end);
    InsertTokens(tokens, is + 1, quality);
  }
}

// The share in percent that words say, and how many words; 0: none.
struct Percent {
  int value = 0;
  std::size_t tokens = 0;
};

Percent PercentAt(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) == "half") return {50, 1};
  const bool article = IsOneOf(WordAt(tokens, at), {"a", "one"});
  const NumberMatch number = MatchNumber(tokens, at);
  if (!article && number.tokens != 1) return {};
  const int parts = article ? 1 : number.value;
  const std::string_view of = WordAt(tokens, at + 1);
  int whole = 0;
  if (IsOneOf(of, {"third", "thirds"})) whole = 3;
  if (IsOneOf(of, {"quarter", "quarters"})) whole = 4;
  if (IsOneOf(of, {"fifth", "fifths"})) whole = 5;
  if (IsOneOf(of, {"tenth", "tenths"})) whole = 10;
  if (whole == 0 || parts >= whole) return {};
  return {(100 * parts + whole / 2) / whole, 2};
}

// "Two thirds of the ground are covered by flowers", "flowers on half of the land", "flowers more
// than half": 67 percent, 50 percent.
void MendShares(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const Percent share = PercentAt(*tokens, at);
    if (share.tokens == 0) continue;
    std::size_t next = at + share.tokens;
    const bool of = WordAt(*tokens, next) == "of";
    if (of) ++next;
    const bool the = IsOneOf(WordAt(*tokens, next), {"the", "all"});
    if (the) ++next;
    const bool ground = the && IsOneOf(WordAt(*tokens, next),
                                       {"ground", "land", "area", "map", "world", "surface"});
    // Only in its clause: "half of the world is asleep, the ground is covered with snow".
    const auto is_cover = [&](std::size_t i) {
      return IsOneOf(WordAt(*tokens, i), {"covered", "cover", "covers", "covering"});
    };
    const auto ends = [&](std::size_t i) {
      return IsPauseAt(*tokens, i) || IsOneOf(WordAt(*tokens, i), {"and", "while", "but"});
    };
    bool covered = false;
    for (std::size_t i = at; !ends(i) && !covered; ++i) covered = is_cover(i);
    for (std::size_t i = at; i > 0 && !ends(i - 1) && !covered; --i) covered = is_cover(i - 1);
    // "half of the ground is covered with flowers, a quarter of the ground with stones"
    const std::size_t other = next + 1;
    if (!covered && IsOneOf(WordAt(*tokens, other), {"with", "by"})) {
      for (std::size_t i = SentenceBegin(*tokens, at); i < at && !covered; ++i) {
        covered = is_cover(i);
      }
    }
    // "flowers more than half"
    const bool than = at > 2 && WordAt(*tokens, at - 1) == "than" &&
                      IsOneOf(WordAt(*tokens, at - 2), {"more", "less"}) &&
                      words.assets.LengthAt(*tokens, at - 3) == 1 &&
                      IsPauseAt(*tokens, at + share.tokens);
    if (!(ground && covered) && !than) continue;
    const Token beside = (*tokens)[at];
    EraseTokens(tokens, at, share.tokens);
    InsertTokens(tokens, at,
                 {{TokenKind::kNumber, std::to_string(share.value), beside.begin, beside.end},
                  WordLike("percent", beside)});
  }
}

// "The village is under attack by goblins", "under siege from": attacked by goblins, besieged by.
void MendUnderAttack(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "under") continue;
    const std::size_t noun = at + (WordAt(*tokens, at + 1) == "heavy" ? 2 : 1);
    const std::string_view said = WordAt(*tokens, noun);
    const bool by = IsOneOf(WordAt(*tokens, noun + 1), {"by", "from", "of"});
    const bool attack = IsOneOf(said, {"attack", "assault"});
    const bool siege = said == "siege";
    const bool guard = IsOneOf(said, {"guard", "surveillance", "observation", "watch"});
    std::size_t who = noun + 2;
    who += MatchNumber(*tokens, who).tokens;
    while (IsOneOf(WordAt(*tokens, who), {"a", "an", "the", "some", "many", "about"})) ++who;
    who += MatchNumber(*tokens, who).tokens;
    // "from the north", "by night"
    const bool agents =
        !IsPauseAt(*tokens, who) &&
        std::max(words.species.LengthAt(*tokens, who), words.quantities.LengthAt(*tokens, who)) > 0;
    if (!by || !agents || !(attack || siege || guard)) continue;
    ReplaceTokens(tokens, at, noun + 2 - at,
                  {attack  ? "attacked"
                   : siege ? "besieged"
                           : "guarded",
                   "by"});
  }
}

// "Three drones hang over the lake", "over the lake hang three drones": drones hover, flying.
void MendHanging(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"hang", "hangs", "hanging"})) continue;
    const auto winged = [&](std::size_t i) {
      if (IsPauseAt(*tokens, i)) return false;
      const auto species = words.species.At(*tokens, i);
      if (species.tokens == 0) return false;
      const AgentCategory category = species.rows.front()->categories.front();
      return category == AgentCategory::kAerialRobot || category == AgentCategory::kEagle;
    };
    std::size_t behind = at + 1;
    while (behind < at + 4 && !winged(behind) &&
           (MatchNumber(*tokens, behind).tokens > 0 ||
            IsOneOf(WordAt(*tokens, behind), {"a", "an", "the", "some", "about"}))) {
      ++behind;
    }
    // "hang out", "hang from the trees", "hang their heads" are something else.
    const auto is_high = [&](std::size_t i) {
      return IsOneOf(WordAt(*tokens, i),
                     {"over", "above", "low", "still", "motionless", "high", "overhead"}) ||
             (WordAt(*tokens, i) == "in" && IsOneOf(WordAt(*tokens, i + 2), {"air", "sky"})) ||
             (WordAt(*tokens, i) == "in" && IsOneOf(WordAt(*tokens, i + 1), {"midair", "mid"}));
    };
    bool high = is_high(at + 1);
    for (std::size_t i = at; i > 0 && !IsPauseAt(*tokens, i - 1) && !high; --i)
      high = is_high(i - 1);
    if (!high || IsOneOf(WordAt(*tokens, at + 1), {"out", "around", "from", "upside", "their"})) {
      continue;
    }
    const std::size_t verb = IsOneOf(WordAt(*tokens, at - 1), {"is", "are"}) ? at - 1 : at;
    const bool before =
        (verb > 0 && winged(verb - 1)) ||
        (verb > 1 && words.species.LengthAt(*tokens, verb - 2) == 2 && winged(verb - 2));
    if (winged(behind)) {
      // "over the lake hang three drones": three drones hover
      std::size_t end = behind + words.species.LengthAt(*tokens, behind);
      InsertTokens(tokens, end, {WordLike("hovering", (*tokens)[at])});
      EraseTokens(tokens, at, 1);
    } else if (before) {
      const bool doing = WordAt(*tokens, at) == "hanging";
      (*tokens)[at].text = doing ? "hovering" : "hover";
    }
  }
}

}  // namespace

void MendSurfaces(const EnvironmentWords& words, std::vector<Token>* tokens) {
  DropWet(tokens);
  MendIce(words, tokens);
  MendEllipsis(words, tokens);
  MendShares(words, tokens);
  MendUnderAttack(words, tokens);
  MendHanging(words, tokens);
}

}  // namespace latticeworld
