#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// This file rewrites how texts tell where roads and rivers turn, and what lies inside and outside
// of their bends.
namespace latticeworld {
namespace {

bool IsLineAt(const std::vector<Token>& tokens, std::size_t at) {
  return MatchClassWord(tokens, at).is_line();
}

// "From the bottom up to about the middle, where it crosses the river and carries on to the left
// edge", "from the north down to the center, and there it turns and leaves by the right edge": via
// the middle to the left edge.
void TurnAtMiddle(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "to") return;
  std::size_t middle = at + 1;
  while (IsOneOf(WordAt(*tokens, middle), {"about", "roughly", "around", "the", "near"})) ++middle;
  if (!IsCenterWord(WordAt(*tokens, middle))) return;
  std::size_t next = middle + 1;
  if (WordAt(*tokens, next) == "of" && WordAt(*tokens, next + 1) == "the" &&
      IsMapWord(WordAt(*tokens, next + 2))) {
    next += 3;
  }
  while (IsMark(*tokens, next) || WordAt(*tokens, next) == "and") ++next;
  const std::size_t where = next;
  while (IsOneOf(WordAt(*tokens, next), {"where", "there", "then", "it", "from"})) ++next;
  if (next == where) return;
  // What it does there, and where it goes.
  constexpr std::size_t kReach = 14;
  bool turns = false;
  std::size_t aside = next, aside_end = next, goal = 0;
  for (std::size_t i = next; i < next + kReach && !IsStopAt(*tokens, i); ++i) {
    const std::string_view word = WordAt(*tokens, i);
    if (IsOneOf(word, {"turns", "bends", "swings", "curves", "veers"})) turns = true;
    if (IsOneOf(word, {"crosses", "meets", "passes"})) aside = i;
    if (!IsOneOf(word, {"leaves", "exits", "carries", "continues", "goes", "runs", "flows", "leads",
                        "heads"})) {
      continue;
    }
    aside_end = i - (WordAt(*tokens, i - 1) == "and" ? 1 : 0);
    goal = i + 1;
    if (WordAt(*tokens, goal) == "the" && IsOneOf(word, {"leaves", "exits"})) goal += 2;
    while (IsOneOf(WordAt(*tokens, goal), {"on", "out", "off", "to", "by", "at", "through", "over",
                                           "via", "in", "towards"})) {
      ++goal;
    }
    break;
  }
  std::string place;
  if (goal == 0 || TakeSideWords(*tokens, goal, &place) == 0) return;
  // "where it passes a village": which must not be lost.
  if (NamesThing(*tokens, next) && WordAt(*tokens, aside) != "crosses") return;
  const std::size_t end = TakeSideWords(*tokens, goal, &place);
  if (!IsPauseAt(*tokens, end) && WordAt(*tokens, end) != "and") return;
  if (place.find(' ') == std::string::npos) place += "ern edge";
  const Token beside = (*tokens)[at];
  std::vector<Token> said = SaidLike("via the center to the " + place, beside);
  if (turns) {
    for (const Token& token : SaidLike("with a bend", beside)) said.push_back(token);
  } else if (IsOneOf(WordAt(*tokens, aside), {"crosses"}) && aside_end > aside) {
    said.push_back(WordLike("and", beside));
    for (const Token& token : TokensBetween(*tokens, aside, aside_end)) said.push_back(token);
  }
  std::size_t begin = at;
  while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"up", "down", "over", "across", "on",
                                                           "runs", "flows", "goes", "leads"})) {
    --begin;
  }
  if (begin > 0 && IsMark(*tokens, begin - 1) && !IsLineAt(*tokens, begin)) --begin;
  EraseTokens(tokens, begin, end - begin);
  InsertTokens(tokens, begin, said);
}

// The sides of the map that the last line before `at` runs between, where they meet in a corner;
// false: none such are named. `line` is its noun.
bool TakeBend(const std::vector<Token>& tokens, std::size_t at, Heading* inner, std::string* line) {
  for (std::size_t from = at; from-- > 0;) {
    if (WordAt(tokens, from) != "from") continue;
    std::string first, second;
    std::size_t next = TakeSideWords(tokens, from + 1, &first);
    if (next == 0) continue;
    while (!IsStopAt(tokens, next) && WordAt(tokens, next) != "to") ++next;
    if (WordAt(tokens, next) != "to" || TakeSideWords(tokens, next + 1, &second) == 0) return false;
    Heading ends[2] = {};
    const std::string_view sides[2] = {first, second};
    for (int i = 0; i < 2; ++i) {
      const std::string_view side = sides[i].substr(0, sides[i].find("ern "));
      ends[i].south = side == "north" ? -1 : side == "south" ? 1 : 0;
      ends[i].east = side == "west" ? -1 : side == "east" ? 1 : 0;
    }
    *inner = {ends[0].east + ends[1].east, ends[0].south + ends[1].south};
    if (!inner->IsDiagonal()) return false;
    for (const NamedThing& thing : NamedBefore(tokens, from)) {
      if (!IsLineAt(tokens, thing.begin)) continue;
      *line = JoinWords(tokens, thing.begin, thing.end);
      return true;
    }
    return false;
  }
  return false;
}

// "A river from the top edge to the right edge. A town on the inner side of the bend, fields on the
// outer side": to the north-east of the river, to the south-west of it.
void TurnBendSides(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"inner", "outer", "inside", "outside"})) return;
  // "the inner side of the bend", "inside the bend", or a side alone after a bend was named
  const bool inside = IsOneOf(WordAt(*tokens, at), {"inner", "inside"});
  std::size_t next = at + 1;
  const bool side = WordAt(*tokens, next) == "side";
  if (side) ++next;
  bool bend = false;
  if (WordAt(*tokens, next) == "of" && IsOneOf(WordAt(*tokens, next + 1), {"the", "this", "its"}) &&
      IsOneOf(WordAt(*tokens, next + 2), {"bend", "curve", "turn", "arc"})) {
    bend = true;
    next += 3;
  } else if (!side && WordAt(*tokens, next) == "the" &&
             IsOneOf(WordAt(*tokens, next + 1), {"bend", "curve"})) {
    bend = true;
    next += 2;
  }
  if (!bend && !side) return;
  if (!bend) {
    for (std::size_t i = 0; i < at; ++i)
      bend = bend || IsOneOf(WordAt(*tokens, i), {"bend", "curve", "curving", "curves", "bends"});
    if (!bend) return;
  }
  // The course of the line that bends gives the direction of its inner side.
  Heading inner;
  std::string line;
  if (!TakeBend(*tokens, at, &inner, &line)) return;
  if (!inside) inner = {-inner.east, -inner.south};
  // Articles and prepositions before it go with it.
  std::size_t begin = at;
  if (begin > 0 && WordAt(*tokens, begin - 1) == "the") --begin;
  const bool fills = begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"fill", "cover"}) &&
                     WordAt(*tokens, next) == "with";
  if (fills) {
    --begin;
    ++next;
  } else if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"on", "in", "at"})) {
    --begin;
  }
  // "there is" is put in if what lies there follows.
  const bool fronted = begin == 0 || IsPauseAt(*tokens, begin - 1);
  const bool there =
      fills || (fronted && !IsOneOf(WordAt(*tokens, next), {"is", "are", "lies", "lie", "there"}));
  const std::string heading(NameOf(inner));
  std::vector<Token> said =
      SaidLike("to the " + heading + " of the " + line + (there ? " there is" : ""), (*tokens)[at]);
  EraseTokens(tokens, begin, next - begin);
  InsertTokens(tokens, begin, said);
}

// "Makes a wide curve to the east around the lake": bends east around it. "It does not continue
// beyond the village": which says nothing more.
void TurnCurveAround(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"makes", "takes", "describes"}) &&
      WordAt(*tokens, at + 1) == "a") {
    std::size_t next = at + 2;
    while (IsSize(WordAt(*tokens, next)) || WordAt(*tokens, next) == "great") ++next;
    if (!IsOneOf(WordAt(*tokens, next), {"curve", "bend", "turn", "bow", "detour"}) ||
        WordAt(*tokens, next + 1) != "to" || WordAt(*tokens, next + 2) != "the") {
      return;
    }
    const std::string side(HeadingWord(WordAt(*tokens, next + 3)));
    if (side.empty() || !IsOneOf(WordAt(*tokens, next + 4), {"around", "round"})) return;
    ReplaceTokens(tokens, at, next + 5 - at, {"bends", side, "around"});
    return;
  }
  if (at == 0 || !IsStopAt(*tokens, at - 1) || !IsOneOf(WordAt(*tokens, at), {"it", "they"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"does", "do"}) || WordAt(*tokens, at + 2) != "not" ||
      !IsOneOf(WordAt(*tokens, at + 3), {"continue", "go", "run", "lead"})) {
    return;
  }
  std::size_t beyond = at + 4;
  if (WordAt(*tokens, beyond) == "on") ++beyond;
  if (!IsOneOf(WordAt(*tokens, beyond), {"beyond", "past", "further"})) return;
  const std::size_t end = PauseAfter(*tokens, beyond);
  if (IsStopAt(*tokens, end)) EraseTokens(tokens, at, end - at);
}

}  // namespace

void TurnBends(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnAtMiddle(tokens, at);
    TurnBendSides(tokens, at);
    TurnCurveAround(tokens, at);
  }
}

}  // namespace latticeworld
