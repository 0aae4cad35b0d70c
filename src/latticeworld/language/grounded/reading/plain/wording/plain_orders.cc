#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsSideNoun(std::string_view word) {
  return IsOneOf(word, {"side", "bank", "shore", "edge", "hand", "sides", "banks", "flank"});
}

// A direction with what stands around it: "on the left side". `end` is the word after it.
struct SidePhrase {
  bool found = false;
  Heading heading;
  std::size_t end = 0;
};

SidePhrase TakeSide(const std::vector<Token>& tokens, std::size_t at, bool needs_preposition) {
  SidePhrase side;
  if (IsOneOf(WordAt(tokens, at), {"to", "on", "at", "in"})) {
    ++at;
  } else if (needs_preposition) {
    return side;
  }
  if (IsOneOf(WordAt(tokens, at), {"the", "its"})) ++at;
  PlaceCursor cursor(tokens, at);
  const Direction direction = TakeDirection(&cursor);
  side.found = direction.found && (direction.heading.east != 0 || direction.heading.south != 0);
  side.heading = direction.heading;
  side.end = cursor.at() + (IsSideNoun(WordAt(tokens, cursor.at())) ? 1 : 0);
  return side;
}

bool AreOpposite(Heading a, Heading b) { return a.east == -b.east && a.south == -b.south; }

// "the river", "a road": only lines have two sides and no more.
bool IsLineAt(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"the", "a", "this", "that"})) ++at;
  const ClassWordMatch noun = MatchClassWord(tokens, at);
  return noun.word != nullptr && noun.word->shape == WordShape::kLine;
}

// "from left to right"; the word after it, 0: no such words.
std::size_t SpanEnd(const std::vector<Token>& tokens, std::size_t at) {
  if (WordAt(tokens, at) != "from") return 0;
  PlaceCursor first(tokens, at + (WordAt(tokens, at + 1) == "the" ? 2 : 1));
  const Direction from = TakeDirection(&first);
  if (!from.found || WordAt(tokens, first.at()) != "to") return 0;
  PlaceCursor second(tokens, first.at() + (WordAt(tokens, first.at() + 1) == "the" ? 2 : 1));
  const Direction to = TakeDirection(&second);
  return to.found && AreOpposite(from.heading, to.heading) ? second.at() : 0;
}

// The word after "of them", "should stand", "are".
std::size_t AfterVerbs(const std::vector<Token>& tokens, std::size_t at) {
  while (IsOneOf(WordAt(tokens, at),
                 {"of", "them", "right", "directly", "immediately", "may", "should", "stand",
                  "stands", "is", "are", "be", "lie", "lies", "must", "grow", "grows", "built"})) {
    ++at;
  }
  return at;
}

// "next to the river", "in a wood", "near the road": `thing` is the noun, 0 where none follows.
struct Closeness {
  std::size_t thing = 0;
  bool touching = false;
};

Closeness TakeCloseness(const std::vector<Token>& tokens, std::size_t at) {
  Closeness close;
  const std::string_view word = WordAt(tokens, at);
  const bool pair = WordAt(tokens, at + 1) == "to";
  std::size_t next = at + 1;
  if (pair && (word == "next" || word == "close")) {
    close.touching = word == "next";
    ++next;
  } else if (IsOneOf(word, {"in", "inside", "within", "on", "among", "beside", "touching", "touch",
                            "touches", "adjoining", "alongside", "along", "at"})) {
    close.touching = true;
  } else if (!IsOneOf(word, {"near", "by", "around"})) {
    return {};
  }
  if (IsOneOf(WordAt(tokens, next), {"the", "a", "an", "any", "this", "that"})) ++next;
  // "at the end of the road"
  if (IsOneOf(WordAt(tokens, next), {"edge", "end", "foot", "side", "shore", "bank", "border"}) &&
      WordAt(tokens, next + 1) == "of" && WordAt(tokens, next + 2) == "the") {
    next += 3;
  }
  if (MatchClassWord(tokens, next).word != nullptr) close.thing = next;
  return close;
}

// "to the left and to the right of the road", "on its eastern and western side": on both sides of
// it.
void TurnBothSides(std::vector<Token>* tokens, std::size_t at) {
  const SidePhrase first = TakeSide(*tokens, at, true);
  if (!first.found || WordAt(*tokens, first.end) != "and") return;
  const SidePhrase second = TakeSide(*tokens, first.end + 1, false);
  if (second.found && AreOpposite(first.heading, second.heading) &&
      WordAt(*tokens, second.end) == "of" && IsLineAt(*tokens, second.end + 1)) {
    ReplaceTokens(tokens, at, second.end + 1 - at, {"on", "both", "sides", "of"});
  }
}

// "with a village on each bank": on both banks.
void TurnEachBank(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"on", "along"}) &&
      IsOneOf(WordAt(*tokens, at + 1), {"each", "either"}) &&
      IsOneOf(WordAt(*tokens, at + 2), {"bank", "shore"}) && WordAt(*tokens, at + 3) != "of") {
    ReplaceTokens(tokens, at, 3, {"on", "both", "banks"});
  }
}

// "in two of the corners: top left and top right": in top left and top right.
void TurnSomeCorners(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"two", "three"}) || WordAt(*tokens, at + 1) != "of" ||
      WordAt(*tokens, at + 2) != "the") {
    return;
  }
  std::size_t end = at + 3;
  if (WordAt(*tokens, end) == "four") ++end;
  const bool corners = IsOneOf(WordAt(*tokens, end), {"corners", "edges", "sides"});
  const bool listed = corners && end + 1 < tokens->size() &&
                      (*tokens)[end + 1].kind == TokenKind::kComma &&
                      TakeSide(*tokens, end + 2, false).found;
  if (listed) EraseTokens(tokens, at, end + 2 - at);
}

// "dividing the map into a wooded left half and a farmed right half": there is a wooded left half.
void TurnHalves(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"dividing", "splitting", "cutting"}) &&
      WordAt(*tokens, at + 1) == "the" && IsMapWord(WordAt(*tokens, at + 2)) &&
      WordAt(*tokens, at + 3) == "into" && IsOneOf(WordAt(*tokens, at + 4), {"a", "an"}) &&
      !TakeSide(*tokens, at + 5, false).found) {
    ReplaceTokens(tokens, at, 4, {"x", "there", "is"});
    (*tokens)[at] = {TokenKind::kStop, ".", (*tokens)[at].begin, (*tokens)[at].begin};
  }
}

// "on one side of the river there are fields, on the other side a wood": the river lies between
// them.
void TurnOneSide(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || WordAt(*tokens, at + 1) != "one" ||
      !IsSideNoun(WordAt(*tokens, at + 2)) || WordAt(*tokens, at + 3) != "of") {
    return;
  }
  std::size_t thing = at + 4;
  if (WordAt(*tokens, thing) == "the") ++thing;
  const ClassWordMatch line = MatchClassWord(*tokens, thing);
  if (line.word == nullptr) return;
  std::size_t verb = thing + line.tokens;
  const std::size_t named = verb;
  if (WordAt(*tokens, verb) == "there") ++verb;
  while (IsOneOf(WordAt(*tokens, verb), {"is", "are", "lies", "lie", "stands", "i", "put"})) ++verb;
  const std::size_t comma = PauseAfter(*tokens, verb);
  std::size_t other = comma + 1;
  if (IsOneOf(WordAt(*tokens, other), {"and", "while"})) ++other;
  if (IsStopAt(*tokens, comma) || WordAt(*tokens, other) != "on" ||
      WordAt(*tokens, other + 1) != "the" || WordAt(*tokens, other + 2) != "other") {
    return;
  }
  other += IsSideNoun(WordAt(*tokens, other + 3)) ? 4 : 3;
  while (IsOneOf(WordAt(*tokens, other), {"there", "is", "are"})) ++other;
  if (IsPauseAt(*tokens, other)) return;
  const Token beside = (*tokens)[at];
  std::vector<Token> turned = {WordLike("the", beside)};
  for (std::size_t i = thing; i < named; ++i) turned.push_back((*tokens)[i]);
  for (const std::string_view word : {"lies", "between"}) turned.push_back(WordLike(word, beside));
  for (std::size_t i = verb; i < comma; ++i) turned.push_back((*tokens)[i]);
  turned.push_back(WordLike("and", beside));
  EraseTokens(tokens, at, other - at);
  InsertTokens(tokens, at, turned);
}

// "goes around the village on the east": to the east of the village.
void TurnAroundOnSide(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"around", "round", "past"}) ||
      WordAt(*tokens, at + 1) != "the") {
    return;
  }
  const ClassWordMatch noun = MatchClassWord(*tokens, at + 2);
  if (noun.word == nullptr) return;
  const std::size_t first = at + 2 + noun.tokens;
  const SidePhrase side = TakeSide(*tokens, first, true);
  if (!side.found || WordAt(*tokens, first + 1) != "the" ||
      !(IsPauseAt(*tokens, side.end) || WordAt(*tokens, side.end) == "and")) {
    return;
  }
  std::vector<Token> turned;
  for (std::size_t i = first; i < side.end; ++i) {
    if (!IsSideNoun(WordAt(*tokens, i))) turned.push_back((*tokens)[i]);
  }
  turned.front().text = "to";
  turned.push_back(WordLike("of", turned.front()));
  EraseTokens(tokens, first, side.end - first);
  EraseTokens(tokens, at, 1);
  InsertTokens(tokens, at, turned);
}

}  // namespace

void TurnOrders(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const bool begins = at == 0 || IsStopAt(*tokens, at - 1);
    const std::string word(WordAt(*tokens, at));
    const std::string next(WordAt(*tokens, at + 1));
    // "First comes the town, then a meadow, then the woods, from left to right."
    if (begins && word == "first" &&
        IsOneOf(next, {"comes", "come", "the", "a", "there", "some", "is"})) {
      std::size_t end = at;
      std::size_t comma = 0;
      while (!IsStopAt(*tokens, end)) {
        if ((*tokens)[end].kind == TokenKind::kComma) comma = end;
        ++end;
      }
      if (comma == 0 || SpanEnd(*tokens, comma + 1) != end) continue;
      std::vector<Token> span;
      for (std::size_t i = comma + 1; i < end; ++i) span.push_back((*tokens)[i]);
      span.push_back(CommaLike((*tokens)[at]));
      EraseTokens(tokens, comma, end - comma);
      EraseTokens(tokens, at, IsOneOf(next, {"comes", "come", "is"}) ? 2 : 1);
      InsertTokens(tokens, at, span);
      continue;
    }
    // "From left to right come first the town, ...", "From left to right you see ..."
    const std::size_t span = begins ? SpanEnd(*tokens, at) : 0;
    if (span > 0) {
      std::size_t verb = span;
      if (IsOneOf(WordAt(*tokens, verb), {"you", "we", "i", "one"})) ++verb;
      if (IsOneOf(WordAt(*tokens, verb), {"come", "comes", "follow", "find", "see", "have", "want",
                                          "get", "sees", "finds", "lie", "pass", "cross"})) {
        ++verb;
        if (WordAt(*tokens, verb) == "first") ++verb;
        ReplaceTokens(tokens, span, verb - span, {"x"});
        (*tokens)[span] = CommaLike((*tokens)[span]);
      }
    }
    // "a pond in every quarter of the map"
    if (IsOneOf(word, {"each", "every"}) && next == "quarter") (*tokens)[at + 1].text = "quadrant";
    // "trees are rare"
    if (IsOneOf(word, {"rare", "scarce", "sparse"}) && at > 1 &&
        IsOneOf(WordAt(*tokens, at - 1), {"is", "are", "be"}) && IsPauseAt(*tokens, at + 1)) {
      (*tokens)[at].text = "few";
    }
  }
}

void TurnOpposites(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    TurnBothSides(tokens, at);
    TurnEachBank(tokens, at);
    TurnSomeCorners(tokens, at);
    TurnHalves(tokens, at);
    TurnOneSide(tokens, at);
    TurnAroundOnSide(tokens, at);
  }
}

void TurnRefusals(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    // "no houses in the wood", "do not put houses near the lake": these stand apart.
    std::size_t thing = at;
    if (word == "no") {
      thing = at + 1;
    } else if (IsOneOf(word, {"not", "never"}) &&
               IsOneOf(WordAt(*tokens, at + 1), {"put", "place", "build", "set", "lay", "draw",
                                                 "add", "have", "plant", "want", "need"})) {
      thing = at + 2;
      if (IsOneOf(WordAt(*tokens, thing), {"any", "a", "an", "the"})) ++thing;
    }
    if (thing > at) {
      const ClassWordMatch noun = MatchClassWord(*tokens, thing);
      if (noun.word == nullptr) continue;
      const std::size_t verb = thing + noun.tokens;
      const std::size_t next = AfterVerbs(*tokens, verb);
      const Closeness close = TakeCloseness(*tokens, next);
      if (close.thing > 0) {
        ReplaceTokens(tokens, verb, close.thing - verb,
                      {"not", close.touching ? "next" : "close", "to", "the"});
        const bool asked = thing == at + 2 && at > 0 && WordAt(*tokens, at - 1) == "do";
        const std::size_t first = asked ? at - 1 : at;
        ReplaceTokens(tokens, first, thing - first, {"the"});
        continue;
      }
      // "no road reaches the eastern edge": none is there.
      if (IsOneOf(WordAt(*tokens, next), {"reaches", "reach", "touches", "touch", "meets"}) &&
          TakeSide(*tokens, next + 1, false).found) {
        ReplaceTokens(tokens, next, 1, {"at"});
      }
    }
    // "houses on both sides of the road but none next to the river"
    if (word == "none" && at > 0) {
      const Closeness close = TakeCloseness(*tokens, AfterVerbs(*tokens, at + 1));
      if (close.thing == 0) continue;
      std::size_t first = at;
      if (IsOneOf(WordAt(*tokens, at - 1), {"but", "and", "though", "yet"})) --first;
      ReplaceTokens(tokens, first, close.thing - first,
                    {"x", "not", close.touching ? "next" : "close", "to", "the"});
      (*tokens)[first] = CommaLike((*tokens)[first]);
      at = first + 4;
      continue;
    }
    // "closer to the lake than to the wood": near the lake.
    if (IsOneOf(word, {"closer", "nearer"}) && WordAt(*tokens, at + 1) == "to") {
      const std::size_t end = PauseAfter(*tokens, at);
      std::size_t than = at + 2;
      while (than < end && WordAt(*tokens, than) != "than") ++than;
      if (than < end) EraseTokens(tokens, than, end - than);
      ReplaceTokens(tokens, at, 2, {"near"});
    }
    // "all land, namely grass"
    if (IsOneOf(word, {"land", "ground", "terrain"}) && at + 1 < tokens->size() &&
        (*tokens)[at + 1].kind == TokenKind::kComma &&
        IsOneOf(WordAt(*tokens, at + 2), {"namely", "ie"}) &&
        MatchClassWord(*tokens, at + 3).word != nullptr) {
      EraseTokens(tokens, at, 3);
    }
  }
}

}  // namespace latticeworld
