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

// What is kept together, apart, to one place, or sheltered from a side.
namespace latticeworld {
namespace {

// "In the", "up in the far", "along the" and a direction: the token of the preposition; 0: none.
std::size_t PlaceStart(const std::vector<Token>& tokens, std::size_t at) {
  if (IsMark(tokens, at)) ++at;
  if (IsOneOf(WordAt(tokens, at), {"up", "down", "off", "over", "out"})) ++at;
  if (!IsOneOf(WordAt(tokens, at), {"in", "on", "at", "along"})) return 0;
  std::size_t next = at + 1;
  while (IsOneOf(WordAt(tokens, next), {"the", "far", "very", "extreme", "whole"})) ++next;
  PlaceCursor cursor(tokens, next);
  if (!TakeDirection(&cursor).found) return 0;
  // "on the north side of the lake" is no part of the map.
  std::size_t end = cursor.at();
  while (IsFlank(WordAt(tokens, end)) || IsOneOf(WordAt(tokens, end), {"edge", "corner"})) ++end;
  const bool other = WordAt(tokens, end) == "of" && !IsMapWord(WordAt(tokens, end + 2)) &&
                     !IsMapWord(WordAt(tokens, end + 1));
  return other ? 0 : at;
}

// "The only trees, up in the far north-east", "the only houses are a row of them along the edge":
// the trees only there.
void TurnOnlyThere(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "the" || WordAt(*tokens, at + 1) != "only") return;
  const ClassWordMatch match = MatchClassWord(*tokens, at + 2);
  const std::size_t noun_end = at + 2 + match.tokens;
  if (match.word == nullptr) return;
  // "the only water is a river on the right"
  if (WordAt(*tokens, noun_end) == "is" && IsOneOf(WordAt(*tokens, noun_end + 1), {"a", "one"})) {
    const ClassWordMatch meant = MatchClassWord(*tokens, noun_end + 2);
    const std::size_t meant_end = noun_end + 2 + meant.tokens;
    const std::size_t place = PlaceStart(*tokens, meant_end);
    if (meant.word == nullptr || meant.word->suburb != match.word->suburb || place == 0) return;
    InsertTokens(tokens, meant_end, {WordLike("only", (*tokens)[place])});
    EraseTokens(tokens, at, noun_end + 1 - at);
    return;
  }
  std::size_t next = noun_end;
  while (IsOneOf(WordAt(*tokens, next),
                 {"are", "is", "stand", "stands", "grow", "grows", "lie", "lies", "should", "be",
                  "that", "of", "them", "found", "on", "the", "map", "there"})) {
    if (PlaceStart(*tokens, next) != 0) break;
    ++next;
  }
  if (IsOneOf(WordAt(*tokens, next), {"a", "some"}) &&
      IsOneOf(WordAt(*tokens, next + 1), {"line", "row", "few", "group", "strip", "handful"})) {
    next += 2;
    while (IsOneOf(WordAt(*tokens, next), {"of", "them"})) ++next;
  }
  const std::size_t place = PlaceStart(*tokens, next);
  if (place == 0 || (WordAt(*tokens, place) == "on" && place < next)) return;
  EraseTokens(tokens, noun_end, place - noun_end);
  InsertTokens(tokens, noun_end, {WordLike("only", (*tokens)[at])});
  EraseTokens(tokens, at + 1, 1);
}

// "Keep all the houses together in one group in the lower left": houses only in the lower left, in
// a cluster.
void TurnTogether(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"keep", "put", "place", "group", "gather"})) return;
  if (at > 0 && !IsPauseAt(*tokens, at - 1) &&
      !IsOneOf(WordAt(*tokens, at - 1), {"please", "and", "to", "should", "then"})) {
    return;
  }
  // "all the houses"
  std::size_t next = at + 1;
  bool all = false;
  while (IsOneOf(WordAt(*tokens, next), {"all", "every", "the", "of"})) {
    all = all || WordAt(*tokens, next) == "all";
    ++next;
  }
  const ClassWordMatch match = MatchClassWord(*tokens, next);
  if (match.word == nullptr || !match.plural) return;
  const std::size_t noun = next;
  next += match.tokens;
  // "together", "in one tight group"
  bool together = false;
  if (WordAt(*tokens, next) == "together") {
    together = true;
    ++next;
  }
  if (WordAt(*tokens, next) == "in" && IsOneOf(WordAt(*tokens, next + 1), {"one", "a", "single"})) {
    std::size_t group = next + 2;
    while (IsOneOf(WordAt(*tokens, group), {"single", "tight", "dense", "compact", "small"}))
      ++group;
    if (IsOneOf(WordAt(*tokens, group), {"group", "cluster", "clump", "bunch", "block"})) {
      together = true;
      next = group + 1;
    }
  }
  if (!together) return;
  // They are clustered, and if all are in one place, only there.
  const std::size_t place = PlaceStart(*tokens, next);
  std::vector<std::string_view> said = {"are", "clustered"};
  if (place != 0 && all) said.insert(said.end(), {"and", "only"});
  const Token beside = (*tokens)[at];
  if (place != 0) next = place;
  EraseTokens(tokens, noun + match.tokens, next - noun - match.tokens);
  std::vector<Token> words;
  for (const std::string_view word : said) words.push_back(WordLike(word, beside));
  InsertTokens(tokens, noun + match.tokens, words);
  EraseTokens(tokens, at, noun - at);
  InsertTokens(tokens, at, {WordLike("the", beside)});
}

// Returns where the words begin that say that two things lie apart and end before the word at `at`.
std::size_t ApartBegin(const std::vector<Token>& tokens, std::size_t at) {
  while (at > 0 &&
         (tokens[at - 1].kind == TokenKind::kNumber ||
          IsOneOf(WordAt(tokens, at - 1),
                  {"at",     "least",  "far",      "well",  "cells",  "tiles",  "squares", "steps",
                   "or",     "more",   "be",       "have",  "has",    "to",     "must",    "should",
                   "are",    "is",     "lie",      "stand", "kept",   "keep",   "stay",    "well",
                   "wide",   "widely", "two",      "three", "four",   "five",   "six",     "seven",
                   "eight",  "nine",   "ten",      "away",  "set",    "some",   "good",    "a",
                   "little", "bit",    "distance", "at",    "placed", "clearly"}))) {
    --at;
  }
  return at;
}

// "The houses and the lake must be at least eight cells apart", "they lie far away from each other"
// of two things: the houses are away from the lake.
void TurnApart(std::vector<Token>* tokens, std::size_t at) {
  std::size_t end = at;
  if (WordAt(*tokens, at) == "apart") {
    end = at + 1;
    if (WordAt(*tokens, end) == "from") ++end;
  } else if (WordAt(*tokens, at) == "from" && at > 0 &&
             IsOneOf(WordAt(*tokens, at - 1), {"away", "far", "distance"})) {
    end = at + 1;
  } else {
    return;
  }
  if (WordAt(*tokens, end - 1) == "from") {
    if (!IsOneOf(WordAt(*tokens, end), {"each", "one"}) ||
        !IsOneOf(WordAt(*tokens, end + 1), {"other", "another"})) {
      return;
    }
    end += 2;
  }
  if (!IsPauseAt(*tokens, end)) return;
  const std::size_t begin = ApartBegin(*tokens, at);
  const bool mark = begin > 0 && IsMark(*tokens, begin - 1);
  const bool they =
      begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"they", "both", "two", "them"});
  const std::vector<NamedThing> named = NamedBefore(*tokens, begin);
  if (named.size() < 2) return;
  const auto name = [&](std::size_t i) { return JoinWords(*tokens, named[i].begin, named[i].end); };
  const std::string last = name(0), first = name(1);
  if (Singular(last) == Singular(first)) return;
  // "The houses and the lake": nothing else stands between them and what is said of them.
  const bool joined = WordAt(*tokens, named[0].begin - 1) == "and" ||
                      (named[0].begin > 1 && WordAt(*tokens, named[0].begin - 2) == "and");
  if (!they && !(joined && (mark || named[0].end == begin))) return;
  // "Houses along the road and the river, well apart": the houses are.
  const std::size_t article = named[1].begin - (named[1].begin > 1 ? 1 : 0);
  const std::size_t before = article - (WordAt(*tokens, article) == "the" && article > 0 ? 1 : 0);
  if (mark && IsOneOf(WordAt(*tokens, before), {"between", "near", "along", "by", "beside", "on"}))
    return;
  std::size_t from = begin;
  if (they) {
    while (from > 0 && IsOneOf(WordAt(*tokens, from - 1),
                               {"they", "both", "two", "them", "the", "of", "so", "and", "but"})) {
      --from;
    }
  }
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  if (from > 0 && !IsStopAt(*tokens, from - 1)) said.push_back(StopLike(beside));
  for (const Token& token : Tokenize("the " + first + " is away from the " + last))
    said.push_back(WordLike(token.text, beside));
  EraseTokens(tokens, from, end - from);
  InsertTokens(tokens, from, said);
}

// "A wood shelters the village from the north": lies on the northern side of the village. "The
// village is sheltered from the north by a wood": has a wood on its northern side.
void TurnShelter(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  const auto side_after = [&](std::size_t from, std::size_t* end) -> std::string_view {
    std::size_t next = from + 1;
    if (WordAt(*tokens, next) == "the") ++next;
    const std::string_view side = HeadingWord(WordAt(*tokens, next));
    ++next;
    while (IsOneOf(WordAt(*tokens, next), {"wind", "winds", "side"})) ++next;
    *end = next;
    return side;
  };
  if (IsOneOf(word, {"shields", "shelters", "protects", "screens", "shield", "shelter", "protect",
                     "screen", "shielding", "sheltering", "protecting", "screening", "guards",
                     "guarding", "shades"})) {
    std::size_t from = at + 1;
    while (!IsPauseAt(*tokens, from) && WordAt(*tokens, from) != "from") ++from;
    std::size_t end = 0;
    if (WordAt(*tokens, from) != "from" || !NamesThing(*tokens, at + 1)) return;
    const std::string side(side_after(from, &end));
    if (side.empty()) return;
    EraseTokens(tokens, from, end - from);
    ReplaceTokens(tokens, at, 1, {"on", "the", side, "side", "of"});
    return;
  }
  if (!IsOneOf(word, {"shielded", "sheltered", "protected", "screened", "guarded", "shaded"}) ||
      WordAt(*tokens, at + 1) != "from" || at == 0 ||
      !IsOneOf(WordAt(*tokens, at - 1), {"is", "are"})) {
    return;
  }
  std::size_t by = 0;
  const std::string side(side_after(at + 1, &by));
  const std::size_t end = PauseAfter(*tokens, by);
  if (side.empty() || WordAt(*tokens, by) != "by" || !NamesThing(*tokens, by + 1)) return;
  const Token beside = (*tokens)[at];
  InsertTokens(tokens, end,
               {WordLike("on", beside), WordLike("its", beside), WordLike(side + "ern", beside),
                WordLike("side", beside)});
  ReplaceTokens(tokens, at - 1, by + 1 - (at - 1), {"has"});
}

// "A house at the north-west corner of the fields": on the north-west side of them.
void TurnCornerOfThing(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "corner" || WordAt(*tokens, at + 1) != "of") return;
  const std::size_t noun = at + 2 + (WordAt(*tokens, at + 2) == "the" ? 1 : 0);
  if (MatchClassWord(*tokens, noun).tokens == 0 || IsMapWord(WordAt(*tokens, noun))) return;
  std::size_t in = at;
  while (in > 0 && !IsPauseAt(*tokens, in - 1) && !IsOneOf(WordAt(*tokens, in), {"in", "at", "on"}))
    --in;
  Heading heading;
  // "In the corner of the field" is within it.
  if (!IsOneOf(WordAt(*tokens, in), {"at", "on"}) || TakeHeading(*tokens, in + 1, &heading) != at) {
    return;
  }
  ReplaceTokens(tokens, in, at + 1 - in, {"on", "the", NameOf(heading), "side"});
}

// "One near the middle of each side of the map": in the middle left, middle right, ...
void TurnMiddleOfSides(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"near", "in", "at"}) || WordAt(*tokens, at + 1) != "the" ||
      !IsCenterWord(WordAt(*tokens, at + 2)) || WordAt(*tokens, at + 3) != "of" ||
      WordAt(*tokens, at + 4) != "each" || !IsOneOf(WordAt(*tokens, at + 5), {"side", "edge"})) {
    return;
  }
  std::size_t end = at + 6;
  if (WordAt(*tokens, end) == "of" && WordAt(*tokens, end + 1) == "the" &&
      IsMapWord(WordAt(*tokens, end + 2))) {
    end += 3;
  }
  if (!IsPauseAt(*tokens, end)) return;
  const bool one = at > 1 && WordAt(*tokens, at - 1) == "one" && IsMark(*tokens, at - 2);
  const std::size_t begin = at - (one ? 2 : 0);
  const Token comma = CommaLike((*tokens)[at]);
  ReplaceTokens(tokens, begin, end - begin,
                {"at", "the", "middle", "left", "the", "middle", "right", "the", "top", "center",
                 "and", "the", "bottom", "center"});
  InsertTokens(tokens, begin + 7, {comma});
  InsertTokens(tokens, begin + 4, {comma});
}

// "Two villages in the east and a road that joins them": connected by a road.
void TurnThatJoins(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"that", "which"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"joins", "connects", "links"}) ||
      !IsOneOf(WordAt(*tokens, at + 2), {"them", "both", "these"}) || !IsPauseAt(*tokens, at + 3)) {
    return;
  }
  std::size_t line = at;
  while (line > 0 && line + 4 > at && !IsOneOf(WordAt(*tokens, line), {"a", "one"})) --line;
  if (!IsOneOf(WordAt(*tokens, line), {"a", "one"}) || line == 0 ||
      WordAt(*tokens, line - 1) != "and") {
    return;
  }
  // Two of a kind stand before it, and nothing else.
  int things = 0;
  bool two = false;
  for (std::size_t i = line - 1; i-- > 0 && !IsStopAt(*tokens, i);) {
    const ClassWordMatch match = MatchClassWord(*tokens, i);
    if (match.tokens > 0 && (i == 0 || MatchClassWord(*tokens, i - 1).tokens <= match.tokens))
      ++things;
    two = two || IsOneOf(WordAt(*tokens, i), {"two", "three", "four", "several"});
  }
  if (things != 1 || !two) return;
  EraseTokens(tokens, at, 3);
  ReplaceTokens(tokens, line - 1, 1, {"connected", "by"});
  InsertTokens(tokens, line - 1, {CommaLike((*tokens)[line])});
}

}  // namespace

void TurnGrouping(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnOnlyThere(tokens, at);
    TurnTogether(tokens, at);
    TurnApart(tokens, at);
    TurnShelter(tokens, at);
    TurnCornerOfThing(tokens, at);
    TurnMiddleOfSides(tokens, at);
    TurnThatJoins(tokens, at);
  }
}

}  // namespace latticeworld
