#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What goes or lies around things.
namespace latticeworld {
namespace {

bool IsAround(std::string_view word) { return IsOneOf(word, {"around", "round"}); }

// "a road that goes all the way around it": around it.
void DropAllTheWay(std::vector<Token>* tokens, std::size_t at) {
  std::size_t end = at;
  if (IsOneOf(WordAt(*tokens, end), {"all", "right", "completely", "fully", "entirely"})) ++end;
  if (end > at && WordAt(*tokens, end) == "the" && WordAt(*tokens, end + 1) == "way") end += 2;
  if (end > at && IsAround(WordAt(*tokens, end)) && !IsPauseAt(*tokens, end + 1))
    EraseTokens(tokens, at, end - at);
}

// "a highway that bends north around a lake": that passes north of a lake.
void TurnSidestep(std::vector<Token>* tokens, std::size_t at) {
  const bool turns = IsOneOf(
      WordAt(*tokens, at),
      {"bends",  "curves",  "swings",  "loops",     "goes",   "veers",   "runs",    "turns",
       "passes", "detours", "arcs",    "skirts",    "dips",   "bending", "curving", "swinging",
       "going",  "turning", "looping", "detouring", "arcing", "passing", "running", "veering"});
  if (!turns) return;
  std::size_t side = at + 1;
  if (IsOneOf(WordAt(*tokens, side), {"to", "off"})) ++side;
  if (WordAt(*tokens, side) == "the") ++side;
  Heading heading;
  const std::size_t around = TakeHeading(*tokens, side, &heading);
  if (around == 0 || !IsAround(WordAt(*tokens, around)) || IsPauseAt(*tokens, around + 1)) return;
  ReplaceTokens(tokens, at, around + 1 - at, {"passes", NameOf(heading), "of"});
}

bool IsMiddle(std::string_view word) { return IsOneOf(word, {"middle", "centre", "center"}); }

// "turns in the middle": bends. "Runs down to the middle and then goes straight to the right edge":
// through the middle and goes to.
void TurnThroughMiddle(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"turns", "curves", "swings", "turning"}) &&
      IsOneOf(WordAt(*tokens, at + 1), {"in", "at", "near"}) && WordAt(*tokens, at + 2) == "the" &&
      IsMiddle(WordAt(*tokens, at + 3))) {
    (*tokens)[at].text = "bends";
  }
  if (!IsOneOf(WordAt(*tokens, at), {"runs", "goes", "leads", "heads", "continues", "comes"}))
    return;
  std::size_t to = at + 1;
  if (IsOneOf(WordAt(*tokens, to), {"down", "up", "on", "over", "straight"})) ++to;
  if (WordAt(*tokens, to) != "to" || WordAt(*tokens, to + 1) != "the" ||
      !IsMiddle(WordAt(*tokens, to + 2))) {
    return;
  }
  std::size_t next = to + 3;
  if (WordAt(*tokens, next) == "of" && WordAt(*tokens, next + 1) == "the") next += 3;
  if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
  if (WordAt(*tokens, next) == "and") ++next;
  while (IsOneOf(WordAt(*tokens, next), {"then", "from", "there"})) ++next;
  const std::size_t verb = next;
  if (!IsOneOf(WordAt(*tokens, verb), {"goes", "runs", "turns", "continues", "heads", "leads"}))
    return;
  ++next;
  if (IsOneOf(WordAt(*tokens, next), {"straight", "on", "off"})) ++next;
  if (WordAt(*tokens, next) != "to") return;
  ReplaceTokens(tokens, at, next + 1 - at,
                {"passes", "through", "the", "middle", "and", "goes", "to"});
}

// "a wall of trees runs right across the map from west to east": runs.
void DropAcross(std::vector<Token>* tokens, std::size_t at) {
  std::size_t across = at + 1;
  if (IsOneOf(WordAt(*tokens, across), {"right", "all", "straight"})) ++across;
  if (WordAt(*tokens, across) == "the" && WordAt(*tokens, across + 1) == "way") across += 2;
  const std::size_t map =
      across + (IsOneOf(WordAt(*tokens, across + 2), {"whole", "entire"}) ? 3 : 2);
  if (IsOneOf(WordAt(*tokens, at), {"runs", "goes", "stretches", "extends", "running", "cuts"}) &&
      WordAt(*tokens, across) == "across" && WordAt(*tokens, across + 1) == "the" &&
      WordAt(*tokens, map) == "map" && WordAt(*tokens, map + 1) == "from") {
    EraseTokens(tokens, at + 1, map - at);
  }
}

// "a ring of rock around it, and forest outside": beyond.
void TurnOutside(std::vector<Token>* tokens, std::size_t at) {
  const bool outside = WordAt(*tokens, at) == "outside" ||
                       (WordAt(*tokens, at) == "further" && WordAt(*tokens, at + 1) == "out");
  const std::size_t end = at + (WordAt(*tokens, at) == "outside" ? 1 : 2);
  if (!outside || at == 0 || !IsPauseAt(*tokens, end)) return;
  std::size_t noun = at;
  while (noun > 0 && noun + 3 > at && MatchClassWord(*tokens, noun).word == nullptr) --noun;
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  if (match.word == nullptr || noun + match.tokens != at) return;
  ReplaceTokens(tokens, at, end - at, {"beyond"});
}

}  // namespace

void TurnDetours(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    DropAllTheWay(tokens, at);
    TurnSidestep(tokens, at);
    TurnThroughMiddle(tokens, at);
    DropAcross(tokens, at);
    TurnOutside(tokens, at);
  }
}

}  // namespace latticeworld
