#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// Land that something divides, and places that are told by what lies over against them.
namespace latticeworld {
namespace {

std::size_t SentenceBegin(const std::vector<Token>& tokens, std::size_t at) {
  while (at > 0 && !IsStopAt(tokens, at - 1)) --at;
  return at;
}

// The land that an adjective tells: "forested" is forest; "": it tells none.
std::string_view LandOf(std::string_view adjective) {
  constexpr std::pair<std::string_view, std::string_view> kLands[] = {{"forested", "forest"},
                                                                      {"wooded", "forest"},
                                                                      {"grassy", "grass"},
                                                                      {"open", "grass"},
                                                                      {"green", "grass"},
                                                                      {"rocky", "rocks"},
                                                                      {"snowy", "snow"},
                                                                      {"sandy", "sand"},
                                                                      {"cultivated", "farmland"},
                                                                      {"farmed", "farmland"},
                                                                      {"agricultural", "farmland"},
                                                                      {"urban", "houses"},
                                                                      {"built", "houses"},
                                                                      {"residential", "houses"},
                                                                      {"flooded", "water"},
                                                                      {"barren", "barren land"}};
  for (const auto& [said, land] : kLands)
    if (said == adjective) return land;
  return "";
}

struct TaggedSide {
  std::string_view land;
  std::string side;
  std::size_t end = 0;  // the token after it; 0: there is none
};

// "a forested north", "an agricultural half in the south" is none.
TaggedSide TakeTaggedSide(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"a", "an"})) return {};
  TaggedSide tagged;
  tagged.land = LandOf(WordAt(tokens, at + 1));
  std::size_t next = at + 2;
  if (WordAt(tokens, at + 1) == "built" && WordAt(tokens, next) == "up") ++next;
  tagged.side = SideWord(WordAt(tokens, next));
  ++next;
  if (IsOneOf(WordAt(tokens, next), {"half", "part", "side"})) ++next;
  if (!tagged.land.empty() && !tagged.side.empty()) tagged.end = next;
  return tagged;
}

// "A road divides the map into a forested north and an open south": runs from west to east; the
// north is forest, the south is grass.
void TurnTaggedSides(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"divides", "splits", "cuts", "parts", "separates"})) return;
  std::size_t next = at + 1;
  while (!IsPauseAt(*tokens, next) && WordAt(*tokens, next) != "into" && next < at + 4) ++next;
  if (WordAt(*tokens, next) != "into") return;
  const TaggedSide first = TakeTaggedSide(*tokens, next + 1);
  if (first.end == 0 || WordAt(*tokens, first.end) != "and") return;
  const TaggedSide second = TakeTaggedSide(*tokens, first.end + 1);
  if (second.end == 0) return;
  const bool rows = IsOneOf(first.side, {"north", "south"});
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  for (const std::string_view word : {"runs", "from"}) said.push_back(WordLike(word, beside));
  for (const std::string_view word : {rows ? "west" : "north", "to", rows ? "east" : "south"})
    said.push_back(WordLike(word, beside));
  for (const TaggedSide& tagged : {first, second}) {
    said.push_back(StopLike(beside));
    said.push_back(WordLike("the", beside));
    said.push_back(WordLike(tagged.side, beside));
    said.push_back(WordLike("is", beside));
    for (const Token& token : Tokenize(tagged.land)) said.push_back(WordLike(token.text, beside));
  }
  EraseTokens(tokens, at, second.end - at);
  InsertTokens(tokens, at, said);
}

// "A lake in one corner and a village in the opposite corner": two corners over against each other,
// and no words say which.
void TurnOppositeCorners(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "one" || WordAt(*tokens, at + 1) != "corner") return;
  for (std::size_t other = at + 2; !IsStopAt(*tokens, other); ++other) {
    if (WordAt(*tokens, other) != "the" ||
        !IsOneOf(WordAt(*tokens, other + 1), {"opposite", "other"}) ||
        !IsOneOf(WordAt(*tokens, other + 2), {"corner", "one"})) {
      continue;
    }
    ReplaceTokens(tokens, other, 3, {"the", "south", "east", "corner"});
    ReplaceTokens(tokens, at, 2, {"the", "north", "west", "corner"});
    return;
  }
}

// "Half forest, half field, with a road along the border": between them.
void TurnInnerBorder(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"along", "on"}) || WordAt(*tokens, at + 1) != "the" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"border", "boundary", "dividing"})) {
    return;
  }
  const std::size_t end = at + (WordAt(*tokens, at + 2) == "dividing" ? 4 : 3);
  if (!IsPauseAt(*tokens, end)) return;
  int halves = 0;
  for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i)
    halves += WordAt(*tokens, i) == "half" ? 1 : 0;
  if (halves == 2) ReplaceTokens(tokens, at, end - at, {"between", "them"});
}

// "A pond in front of the house and a wood behind it", "the house has a pond in front of it and a
// wood behind it": behind the house.
void TurnBehindIt(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "behind" || WordAt(*tokens, at + 1) != "it") return;
  const std::size_t begin = SentenceBegin(*tokens, at);
  for (std::size_t i = begin; i + 3 < at; ++i) {
    if (WordAt(*tokens, i) != "in" || WordAt(*tokens, i + 1) != "front" ||
        WordAt(*tokens, i + 2) != "of") {
      continue;
    }
    std::size_t noun = i + 3 + (WordAt(*tokens, i + 3) == "the" ? 1 : 0);
    if (WordAt(*tokens, i + 3) == "it") {
      noun = begin;
      while (noun < i && MatchClassWord(*tokens, noun).tokens == 0) ++noun;
    }
    const std::size_t length = MatchClassWord(*tokens, noun).tokens;
    if (length == 0) return;
    std::vector<Token> said = {WordLike("the", (*tokens)[at])};
    for (const Token& token : TokensBetween(*tokens, noun, noun + length))
      said.push_back(WordLike(token.text, (*tokens)[at]));
    EraseTokens(tokens, at + 1, 1);
    InsertTokens(tokens, at + 1, said);
    return;
  }
}

// "A river runs diagonally and a road runs parallel to it": a sentence each.
void TurnDiagonally(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "diagonally" || WordAt(*tokens, at + 1) != "and") return;
  if (IsOneOf(WordAt(*tokens, at + 2), {"a", "the", "two"}) && NamesThing(*tokens, at + 2))
    (*tokens)[at + 1] = StopLike((*tokens)[at + 1]);
}

}  // namespace

void TurnDivisions(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnTaggedSides(tokens, at);
    TurnOppositeCorners(tokens, at);
    TurnInnerBorder(tokens, at);
    TurnBehindIt(tokens, at);
    TurnDiagonally(tokens, at);
  }
}

}  // namespace latticeworld
