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

// This file rewrites how texts tell where roads and rivers come from, turn and end, and what one
// sees from them.
namespace latticeworld {
namespace {

bool IsLineAt(const std::vector<Token>& tokens, std::size_t at) {
  return MatchClassWord(tokens, at).is_line();
}

// "Roads reach the town from the west, from the east and from the south", "roads enter it from
// three sides: north, west and south": they are next to the town, and there are roads in the west,
// in the east and in the south.
void TurnApproachesFromSides(std::vector<Token>* tokens, std::size_t at) {
  const ClassWordMatch line = MatchClassWord(*tokens, at);
  if (!line.is_line() || !line.plural) return;
  const std::size_t verb = at + line.tokens;
  if (!IsOneOf(WordAt(*tokens, verb),
               {"reach", "enter", "approach", "lead", "run", "come", "go", "arrive", "converge"})) {
    return;
  }
  // What they reach stands between the verb and "from"; the verb may end in "into" or "up to".
  std::size_t from = verb + 1;
  while (!IsPauseAt(*tokens, from) && WordAt(*tokens, from) != "from") ++from;
  std::size_t thing = verb + 1;
  while (IsOneOf(WordAt(*tokens, thing), {"in", "into", "to", "at", "on", "up", "towards"}))
    ++thing;
  if (WordAt(*tokens, from) != "from" || thing >= from) return;
  // "from three sides:" only announces the sides.
  std::size_t next = from;
  if (IsOneOf(WordAt(*tokens, from + 1), {"two", "three", "four", "all"})) {
    next = from + 2;
    if (!IsOneOf(WordAt(*tokens, next), {"sides", "directions"}) || !IsMark(*tokens, next + 1))
      return;
    next += 2;
  }
  // The sides are listed with "from", commas and "and".
  std::vector<std::string> places;
  std::size_t end = 0;
  while (true) {
    if (WordAt(*tokens, next) == "from") ++next;
    std::string place;
    const std::size_t after = TakeSideWords(*tokens, next, &place);
    if (after == 0) break;
    places.push_back(place);
    end = next = after;
    if (IsMark(*tokens, next)) ++next;
    if (WordAt(*tokens, next) == "and") ++next;
    if (next == end) break;
  }
  if (places.size() < 2 || WordAt(*tokens, end) == "of" || !IsPauseAt(*tokens, end)) return;
  // One sentence tells what the roads are next to, another one where they are.
  const std::string noun = JoinWords(*tokens, at, verb);
  const Token beside = (*tokens)[at];
  std::string where = "there are " + noun;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool edge = places[i].size() > std::string_view("north").size();
    if (i > 0) where += i + 1 == places.size() ? " and" : ",";
    where += (edge ? " at the " : " in the ") + places[i];
  }
  std::vector<Token> said = SaidLike("are next to", beside);
  for (const Token& token : TokensBetween(*tokens, thing, from)) said.push_back(token);
  said.push_back(StopLike(beside));
  for (const Token& token : SaidLike(where, beside)) said.push_back(token);
  EraseTokens(tokens, verb, end - verb);
  InsertTokens(tokens, verb, said);
}

// "Two roads cross in the middle, and both run from edge to edge": one runs from north to south
// and one from west to east. "A cross of two straight roads that meet in the middle": of two roads.
void TurnEdgeToEdge(std::vector<Token>* tokens, std::size_t at) {
  // "a cross of two straight roads that meet"
  if (WordAt(*tokens, at) == "cross" && WordAt(*tokens, at + 1) == "of" &&
      WordAt(*tokens, at + 2) == "two" &&
      IsOneOf(WordAt(*tokens, at + 3), {"straight", "wide", "narrow", "long", "broad", "big"})) {
    EraseTokens(tokens, at + 3, 1);
    const std::size_t that = at + 3 + MatchClassWord(*tokens, at + 3).tokens;
    if (WordAt(*tokens, that) == "that" &&
        IsOneOf(WordAt(*tokens, that + 1), {"meet", "cross", "intersect"})) {
      EraseTokens(tokens, that, PauseAfter(*tokens, that) - that);
    }
    return;
  }
  // "both run from edge to edge"
  if (WordAt(*tokens, at) != "both" || at == 0) return;
  std::size_t next = at + 1;
  if (IsOneOf(WordAt(*tokens, next), {"of", "roads"})) ++next;
  if (WordAt(*tokens, next) == "them") ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"run", "go", "lead", "running", "going", "reach", "reaching",
                                       "stretch", "extend"})) {
    return;
  }
  ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"from", "edge"})) return;
  const std::size_t edge = next + (WordAt(*tokens, next) == "from" ? 1 : 0);
  if (WordAt(*tokens, edge) != "edge" || WordAt(*tokens, edge + 1) != "to" ||
      WordAt(*tokens, edge + 2) != "edge") {
    return;
  }
  // Lines that cross must have been named before, in this sentence or the last.
  std::size_t begin = SentenceBegin(*tokens, at);
  if (begin == at && begin > 0) {
    --begin;
    while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
  }
  std::string noun;
  bool cross = false;
  for (std::size_t i = begin; i < at; ++i) {
    const ClassWordMatch line = MatchClassWord(*tokens, i);
    if (line.is_line() && line.plural) noun = Singular(JoinWords(*tokens, i, i + line.tokens));
    cross = cross || IsOneOf(WordAt(*tokens, i), {"cross", "crossing", "intersect", "crossroads"});
  }
  if (noun.empty() || !cross) return;
  // A sentence about each of both takes the place of these words.
  std::size_t from = at;
  while (from > 0 && (IsMark(*tokens, from - 1) || WordAt(*tokens, from - 1) == "and")) --from;
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, from, edge + 3 - from);
  const bool stopped = from == 0 || IsStopAt(*tokens, from - 1);
  InsertTokens(
      tokens, from,
      SaidLike((stopped ? "" : ". ") + ("one " + noun) + " runs from the top edge to the " +
                   "bottom edge and another from the left edge to the right edge",
               beside));
}

// "left" of "on your left"; "": no such words stand there.
std::string_view HandAt(const std::vector<Token>& tokens, std::size_t at) {
  const bool yours = IsOneOf(WordAt(tokens, at), {"on", "to"}) &&
                     IsOneOf(WordAt(tokens, at + 1), {"your", "the", "our", "my"});
  return yours && IsOneOf(WordAt(tokens, at + 2), {"left", "right"}) ? WordAt(tokens, at + 2)
                                                                     : std::string_view();
}

// The token after such words.
std::size_t HandEnd(const std::vector<Token>& tokens, std::size_t at) {
  return at + 3 + (IsOneOf(WordAt(tokens, at + 3), {"hand", "side"}) ? 1 : 0);
}

// What is seen on one hand, in tokens [begin, end).
struct SeenSide {
  std::size_t begin, end;
  std::string hand;
};

// "The sea on your left", "on your left the sea", once or twice from `at` on; *end is the token
// after them. Empty: something else stands there.
std::vector<SeenSide> TakeSeenSides(const std::vector<Token>& tokens, std::size_t at,
                                    std::size_t* end) {
  std::vector<SeenSide> seen;
  for (std::size_t next = at; seen.size() < 2 && !IsStopAt(tokens, next);) {
    if (const std::string hand(HandAt(tokens, next)); !hand.empty()) {
      std::size_t begin = HandEnd(tokens, next);
      while (IsMark(tokens, begin) || IsOneOf(WordAt(tokens, begin), {"is", "are", "there"}))
        ++begin;
      *end = begin;
      while (!IsPauseAt(tokens, *end) && WordAt(tokens, *end) != "and") ++*end;
      seen.push_back({begin, *end, hand});
    } else {
      std::size_t on = next;
      while (!IsPauseAt(tokens, on) && HandAt(tokens, on).empty()) ++on;
      if (IsPauseAt(tokens, on)) return {};
      *end = HandEnd(tokens, on);
      seen.push_back({next, on, std::string(HandAt(tokens, on))});
    }
    next = *end;
    while (IsMark(tokens, next) || WordAt(tokens, next) == "and") ++next;
  }
  for (const SeenSide& side : seen)
    if (!NamesThing(tokens, side.begin) || side.begin >= side.end) return {};
  if (seen.size() == 2 && seen[0].hand == seen[1].hand) return {};
  return seen;
}

// "The road runs from south to north. To the west of the road there is the sea ...", with the bytes
// of `beside`.
std::vector<Token> SidesOfWay(const std::vector<Token>& tokens, const std::string& name,
                              const std::string& heading, const std::vector<SeenSide>& seen,
                              const Token& beside) {
  std::vector<Token> said = SaidLike(
      "the " + name + " runs from " + std::string(OppositeOf(heading)) + " to " + heading, beside);
  const bool across = heading == "east" || heading == "west";
  const std::string_view left =
      across ? (heading == "east" ? "north" : "south") : (heading == "north" ? "west" : "east");
  for (const SeenSide& side : seen) {
    const std::string to(side.hand == "left" ? left : OppositeOf(left));
    for (const Token& token : SaidLike(". to the " + to + " of the " + name + " there is", beside))
      said.push_back(token);
    for (const Token& token : TokensBetween(tokens, side.begin, side.end)) said.push_back(token);
  }
  return said;
}

// "Driving north on the road you have the sea on your left and fields on your right": the road runs
// from south to north, to the west of it the sea, to the east of it fields.
void TurnDriving(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at),
               {"driving", "going", "travelling", "traveling", "riding", "cycling", "heading",
                "walking", "drive", "go", "travel", "ride", "cycle", "head", "walk"})) {
    return;
  }
  const std::string heading(HeadingWord(WordAt(*tokens, at + 1)));
  if (heading.empty() || !IsOneOf(WordAt(*tokens, at + 2), {"on", "along"})) return;
  const std::size_t road = at + 3 + (WordAt(*tokens, at + 3) == "the" ? 1 : 0);
  std::size_t noun = road;
  while (!IsPauseAt(*tokens, noun) && noun < road + 3 && !IsLineAt(*tokens, noun)) ++noun;
  if (!IsLineAt(*tokens, noun)) return;
  const std::size_t noun_end = noun + MatchClassWord(*tokens, noun).tokens;
  std::size_t next = noun_end;
  while (IsMark(*tokens, next) ||
         IsOneOf(WordAt(*tokens, next),
                 {"you", "we", "i", "one", "have", "has", "had", "see", "sees", "there", "is",
                  "are", "should", "will", "be", "pass", "passes"})) {
    ++next;
  }
  std::size_t end = next;
  const std::vector<SeenSide> seen = TakeSeenSides(*tokens, next, &end);
  if (seen.empty()) return;
  const std::string name = JoinWords(*tokens, noun, noun_end);
  const std::vector<Token> said = SidesOfWay(*tokens, name, heading, seen, (*tokens)[at]);
  std::size_t tail = end;
  while (IsOneOf(WordAt(*tokens, tail), {"the", "all", "whole", "way", "entire", "along", "time"}))
    ++tail;
  std::size_t begin = at;
  while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1),
                              {"you", "we", "i", "one", "as", "when", "if", "while", "and"})) {
    --begin;
  }
  EraseTokens(tokens, begin, (IsPauseAt(*tokens, tail) ? tail : end) - begin);
  InsertTokens(tokens, begin, said);
}

}  // namespace

void TurnApproaches(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnApproachesFromSides(tokens, at);
    TurnEdgeToEdge(tokens, at);
    TurnDriving(tokens, at);
  }
}

}  // namespace latticeworld
