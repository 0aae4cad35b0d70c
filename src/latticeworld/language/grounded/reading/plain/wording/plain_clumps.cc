#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Islands and the like, what they are made of, and what is told of two things in one.
namespace latticeworld {
namespace {

// "rocky" for "rock"; "": no such land.
std::string_view AdjectiveOf(std::string_view land) {
  constexpr std::pair<std::string_view, std::string_view> kLands[] = {
      {"forest", "forested"}, {"tree", "forested"},  {"trees", "forested"},    {"wood", "forested"},
      {"woods", "forested"},  {"pines", "forested"}, {"woodland", "forested"}, {"rock", "rocky"},
      {"rocks", "rocky"},     {"stone", "rocky"},    {"grass", "grassy"},      {"meadow", "grassy"},
      {"snow", "snowy"},      {"ice", "snowy"},      {"sand", "sandy"}};
  for (const auto& [said, adjective] : kLands)
    if (said == land) return adjective;
  return "";
}

bool IsIsland(std::string_view word) {
  return IsOneOf(word, {"island", "islands", "isle", "isles", "islet", "islets"});
}

// Whether a lake, a river or the sea is named.
bool NamesWater(const std::vector<Token>& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const ClassWordMatch noun = MatchClassWord(tokens, i);
    if (noun.word != nullptr && noun.word->wild == 'W' && !IsIsland(WordAt(tokens, i))) return true;
  }
  return false;
}

// "An island of rock in the lake": a rocky island. Without water, "an island of trees": a patch of
// trees. "The island in the lake is wooded": the wooded island in the lake.
void TurnIslands(std::vector<Token>* tokens, std::size_t at) {
  if (!IsIsland(WordAt(*tokens, at))) return;
  const std::string_view land =
      WordAt(*tokens, at + 1) == "of" ? WordAt(*tokens, at + 2) : std::string_view();
  const std::string_view adjective = AdjectiveOf(land);
  if (!adjective.empty()) {
    if (!NamesWater(*tokens)) {
      const bool many = WordAt(*tokens, at).back() == 's';
      (*tokens)[at].text = many ? "patches" : "patch";
      if (at > 0 && WordAt(*tokens, at - 1) == "an") (*tokens)[at - 1].text = "a";
      return;
    }
    EraseTokens(tokens, at + 1, 2);
    InsertTokens(tokens, at, {WordLike(adjective, (*tokens)[at])});
    if (at > 0 && WordAt(*tokens, at - 1) == "an") (*tokens)[at - 1].text = "a";
    return;
  }
  if (at == 0 || WordAt(*tokens, at - 1) != "the") return;
  std::size_t is = at + 1;
  if (IsOneOf(WordAt(*tokens, is), {"in", "on"})) is = PhraseEnd(*tokens, is + 1);
  if (!IsOneOf(WordAt(*tokens, is), {"is", "are"})) return;
  const std::string told(WordAt(*tokens, is + 1));
  if (LandOfAdjective(told).empty() || !IsStopAt(*tokens, is + 2)) return;
  EraseTokens(tokens, is, 2);
  InsertTokens(tokens, at, {WordLike(told, (*tokens)[at])});
}

// "A clearing of the forest": in the forest. "A buffer of trees around the lake": a strip of trees.
// "A ring of rock encloses a lake, and outside it everything is forest": outside the ring there is
// forest.
void TurnPieces(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  if (IsOneOf(word, {"clearing", "clearings", "glade", "glades"}) &&
      WordAt(*tokens, at + 1) == "of" && WordAt(*tokens, at + 2) == "the" &&
      MatchClassWord(*tokens, at + 3).tokens > 0) {
    (*tokens)[at + 1].text = "in";
    return;
  }
  if (word == "buffer") {
    const std::size_t zone =
        at + (IsOneOf(WordAt(*tokens, at + 1), {"zone", "strip", "belt"}) ? 2 : 1);
    if (WordAt(*tokens, zone) == "of" && MatchClassWord(*tokens, zone + 1).tokens > 0)
      ReplaceTokens(tokens, at, zone - at, {"strip"});
    return;
  }
  if (word != "outside" && word != "beyond") return;
  std::size_t next = at + (WordAt(*tokens, at + 1) == "of" ? 2 : 1);
  if (!IsOneOf(WordAt(*tokens, next), {"it", "that", "this"})) return;
  if (IsMark(*tokens, ++next)) ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"everything", "all", "it"}) ||
      WordAt(*tokens, next + 1) != "is") {
    return;
  }
  for (std::size_t i = 0; i + 1 < at; ++i) {
    if (!IsOneOf(WordAt(*tokens, i), {"ring", "circle", "belt", "wall"}) ||
        WordAt(*tokens, i + 1) != "of") {
      continue;
    }
    ReplaceTokens(tokens, at, next + 2 - at, {"outside", "the", "ring", "there", "is"});
    return;
  }
}

// "The lake reaches from the rock in the west to the forest in the east": it is next to both, which
// lie there. Lines lead from one to the other.
void TurnReaches(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"reaches", "reach", "stretches", "stretch", "extends",
                                     "extend", "spreads", "spread"}) ||
      WordAt(*tokens, at + 1) != "from") {
    return;
  }
  const std::size_t begin = PhraseBegin(*tokens, at);
  const ClassWord* noun = NounBefore(*tokens, at);
  if (begin == at || noun == nullptr || noun->shape == WordShape::kLine) return;
  // Each of them and where it lies.
  const auto place = [&](std::size_t next) {
    if (!IsOneOf(WordAt(*tokens, next), {"in", "on", "at"})) return next;
    Heading heading;
    std::size_t end = TakeHeading(*tokens, next + 1, &heading);
    if (end == 0) return next;
    return end + (IsFlank(WordAt(*tokens, end)) ? 1 : 0);
  };
  const std::size_t one = PhraseEnd(*tokens, at + 2), one_end = place(one);
  if (one == at + 2 || WordAt(*tokens, one_end) != "to") return;
  const std::size_t other = PhraseEnd(*tokens, one_end + 1), other_end = place(other);
  if (other == one_end + 1 || !IsPauseAt(*tokens, other_end)) return;
  const Token beside = (*tokens)[at];
  const std::vector<Token> lake = TokensBetween(*tokens, begin, at);
  std::vector<Token> said;
  const auto add = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) said.push_back((*tokens)[i]);
  };
  const auto say = [&](std::string_view words) {
    for (const Token& token : SaidLike(words, beside)) said.push_back(token);
  };
  const NamedThing last = NamedBefore(*tokens, at).front();
  const bool many = MatchClassWord(*tokens, last.begin).plural;
  say(many ? "are next to" : "is next to");
  add(at + 2, one);
  say(".");
  // "two lakes" are told of once more, not two others
  if (many && !IsOneOf(WordAt(lake, 0), {"the", "its", "their", "these"})) {
    say("they");
  } else {
    said.insert(said.end(), lake.begin(), lake.end());
    if (IsOneOf(WordAt(lake, 0), {"a", "an"})) said[said.size() - lake.size()].text = "the";
  }
  say(many ? "are next to" : "is next to");
  add(one_end + 1, other);
  if (one_end > one) {
    say(".");
    add(at + 2, one);
    say("is");
    add(one, one_end);
  }
  if (other_end > other) {
    say(".");
    add(one_end + 1, other);
    say("is");
    add(other, other_end);
  }
  EraseTokens(tokens, at, other_end - at);
  InsertTokens(tokens, at, said);
}

// "Snow and rock to its north and south respectively": snow to its north and rock to its south.
void TurnRespectively(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "respectively" || at < 6) return;
  const std::size_t end = at - (IsMark(*tokens, at - 1) ? 1 : 0);
  const std::size_t begin = SentenceBegin(*tokens, at);
  // The two places from the end: "in the north and the south".
  for (std::size_t on = begin + 3; on + 3 < end; ++on) {
    if (!IsOneOf(WordAt(*tokens, on), {"in", "on", "to", "at"})) continue;
    Heading heading;
    std::size_t first = TakeHeading(*tokens, on + 1, &heading);
    if (first == 0) continue;
    if (IsFlank(WordAt(*tokens, first)) || WordAt(*tokens, first) == "corner") ++first;
    if (WordAt(*tokens, first) != "and") continue;
    std::size_t second = first + 1;
    if (WordAt(*tokens, second) == WordAt(*tokens, on)) ++second;
    const bool article = IsOneOf(WordAt(*tokens, second), {"the", "its"});
    if (TakeHeading(*tokens, second, &heading) == 0) continue;
    const std::size_t verb = BeingBegin(*tokens, on);
    const std::size_t other = PhraseBegin(*tokens, verb);
    if (other <= begin + 1 || other == verb || WordAt(*tokens, other - 1) != "and") continue;
    const std::size_t one = PhraseBegin(*tokens, other - 1);
    if (one == other - 1) continue;
    std::vector<Token> said = TokensBetween(*tokens, one, other - 1);
    for (std::size_t i = on; i <= first; ++i) said.push_back((*tokens)[i]);
    for (std::size_t i = other; i < verb; ++i) said.push_back((*tokens)[i]);
    said.push_back((*tokens)[on]);
    if (!article) said.push_back(WordLike(WordAt(*tokens, on + 1), (*tokens)[on + 1]));
    for (std::size_t i = second; i < end; ++i) said.push_back((*tokens)[i]);
    EraseTokens(tokens, one, at + 1 - one);
    InsertTokens(tokens, one, said);
    return;
  }
}

}  // namespace

void TurnClumps(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnIslands(tokens, at);
    TurnPieces(tokens, at);
    TurnReaches(tokens, at);
    TurnRespectively(tokens, at);
  }
}

}  // namespace latticeworld
