#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// What lies between two things that are told to be across from each other, parted or shielded.
namespace latticeworld {
namespace {

struct Span {
  std::size_t begin = 0, end = 0;
  bool empty() const { return begin == end; }
};

Span PhraseAt(const std::vector<Token>& tokens, std::size_t at) {
  return {at, PhraseEnd(tokens, at)};
}

Span PhraseBefore(const std::vector<Token>& tokens, std::size_t end) {
  return {PhraseBegin(tokens, end), end};
}

// Two nouns of classes that differ.
bool Differ(const std::vector<Token>& tokens, const Span& one, const Span& other) {
  const ClassWord* first = NounBefore(tokens, one.end);
  const ClassWord* second = NounBefore(tokens, other.end);
  return first != nullptr && second != nullptr && first->suburb != second->suburb;
}

// A pause or the beginning, after "and" or none.
bool OpensClause(const std::vector<Token>& tokens, std::size_t at) {
  return at == 0 || IsPauseAt(tokens, at - 1) ||
         IsOneOf(WordAt(tokens, at - 1), {"and", "but", "while", "then"});
}

void Append(const std::vector<Token>& tokens, const Span& span, std::vector<Token>* said) {
  for (std::size_t i = span.begin; i < span.end; ++i) said->push_back(tokens[i]);
}

// Says in the place of `whole`: "the river lies between the forest and the town".
void SayBetween(std::vector<Token>* tokens, const Span& whole, const Span& middle, const Span& one,
                const Span& other) {
  const Token beside = (*tokens)[whole.begin];
  std::vector<Token> said;
  Append(*tokens, middle, &said);
  for (const Token& token : SaidLike("lies between", beside)) said.push_back(token);
  Append(*tokens, one, &said);
  said.push_back(WordLike("and", beside));
  Append(*tokens, other, &said);
  EraseTokens(tokens, whole.begin, whole.end - whole.begin);
  InsertTokens(tokens, whole.begin, said);
}

// "X and Y", that end before `end`.
bool TakePairBefore(const std::vector<Token>& tokens, std::size_t end, Span* one, Span* other) {
  *other = PhraseBefore(tokens, end);
  if (other->empty() || other->begin < 2 || WordAt(tokens, other->begin - 1) != "and") return false;
  *one = PhraseBefore(tokens, other->begin - 1);
  const bool longer =
      one->begin > 1 && (WordAt(tokens, one->begin - 1) == "and" ||
                         (IsPauseAt(tokens, one->begin - 1) && !IsStopAt(tokens, one->begin - 1) &&
                          MatchClassWord(tokens, one->begin - 2).tokens > 0));
  return !one->empty() && !longer && Differ(tokens, *one, *other);
}

// "X and Y" at `at`, before a pause.
bool TakePairAt(const std::vector<Token>& tokens, std::size_t at, Span* one, Span* other) {
  *one = PhraseAt(tokens, at);
  if (one->empty() || WordAt(tokens, one->end) != "and") return false;
  *other = PhraseAt(tokens, one->end + 1);
  return !other->empty() && IsPauseAt(tokens, other->end) && Differ(tokens, *one, *other);
}

// "The lake and the town are at opposite ends of the map": the lake is far away from the town. "The
// forest and the town are on opposite banks of the river": the river lies between them.
void TurnOpposed(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"on", "at", "in", "along", "to"})) return;
  std::size_t end = at + (WordAt(*tokens, at + 1) == "the" ? 2 : 1);
  if (!IsOneOf(WordAt(*tokens, end), {"opposite", "opposing"}) ||
      !IsOneOf(WordAt(*tokens, end + 1),
               {"sides", "ends", "edges", "corners", "banks", "shores", "parts", "borders"})) {
    return;
  }
  end += 2;
  Span middle;
  if (WordAt(*tokens, end) == "of") {
    PlaceCursor cursor(*tokens, end);
    if (TakeWholeMap(&cursor)) {
      end = cursor.at();
    } else {
      middle = PhraseAt(*tokens, end + 1);
      if (middle.empty()) return;
      end = middle.end;
    }
  }
  Span one, other;
  Span whole{at, end};
  const bool fronted = OpensClause(*tokens, at);
  if (fronted) {
    const std::size_t first = SkipBeing(*tokens, end + (IsMark(*tokens, end) ? 1 : 0));
    if (!TakePairAt(*tokens, first, &one, &other)) return;
    whole.end = other.end;
  } else {
    // "on opposite sides of the village, west and east"
    Heading heading;
    if (IsMark(*tokens, end) && TakeHeading(*tokens, end + 1, &heading) > 0) return;
    if (!TakePairBefore(*tokens, BeingBegin(*tokens, at), &one, &other)) return;
    whole.begin = BeingBegin(*tokens, one.begin);
    // "A river with a village and a forest on opposite banks"
    if (middle.empty() && one.begin > 0 && WordAt(*tokens, one.begin - 1) == "with") {
      middle = PhraseBefore(*tokens, one.begin - 1);
      if (middle.empty()) return;
      whole.begin = middle.begin;
    }
  }
  if (!middle.empty()) {
    SayBetween(tokens, whole, middle, one, other);
    return;
  }
  const Token beside = (*tokens)[at];
  std::vector<Token> said;
  Append(*tokens, one, &said);
  for (const Token& token : SaidLike("is far away from", beside)) said.push_back(token);
  Append(*tokens, other, &said);
  EraseTokens(tokens, whole.begin, whole.end - whole.begin);
  InsertTokens(tokens, whole.begin, said);
}

// "Two villages face each other across the river": lie on both sides of it.
void TurnFacingPairs(std::vector<Token>* tokens, std::size_t at) {
  std::size_t next = at;
  if (IsOneOf(WordAt(*tokens, next), {"face", "facing", "opposite"})) {
    ++next;
  } else if (IsOneOf(WordAt(*tokens, next), {"look", "looking"}) &&
             WordAt(*tokens, next + 1) == "at") {
    next += 2;
  } else {
    return;
  }
  if (!IsOneOf(WordAt(*tokens, next), {"each", "one"}) ||
      !IsOneOf(WordAt(*tokens, next + 1), {"other", "another"})) {
    return;
  }
  next += 2;
  if (WordAt(*tokens, next) == "from") ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"across", "over"})) return;
  Span one, other;
  const bool pair = TakePairBefore(*tokens, BeingBegin(*tokens, at), &one, &other);
  if (pair) {
    ReplaceTokens(tokens, at, next + 1 - at, {"on", "opposite", "sides", "of"});
  } else {
    ReplaceTokens(tokens, at, next + 1 - at, {"on", "both", "sides", "of"});
  }
}

// What is told to lie across something from something.
struct Across {
  Span middle, from;
  std::size_t end = 0;  // 0: no such words
};

// "on the far side of the lake"
Across TakeFarSide(const std::vector<Token>& tokens, std::size_t at) {
  Across across;
  if (!IsOneOf(WordAt(tokens, at), {"on", "at", "to"}) || WordAt(tokens, at + 1) != "the" ||
      !IsOneOf(WordAt(tokens, at + 2), {"far", "other", "opposite"}) ||
      !IsOneOf(WordAt(tokens, at + 3), {"side", "bank", "shore", "end"}) ||
      WordAt(tokens, at + 4) != "of") {
    return across;
  }
  across.middle = PhraseAt(tokens, at + 5);
  if (!across.middle.empty()) across.end = across.middle.end;
  return across;
}

// "across the river from the town", "on the far side of the lake from the town", "opposite the town
// across the river", "opposite the town, on the other bank of the river".
Across TakeAcross(const std::vector<Token>& tokens, std::size_t at) {
  Across across;
  if (IsOneOf(WordAt(tokens, at), {"opposite", "facing", "faces", "face"})) {
    if (at > 0 && IsOneOf(WordAt(tokens, at - 1), {"the", "its", "an", "diagonally"})) return {};
    const std::size_t from = at + (WordAt(tokens, at + 1) == "to" ? 2 : 1);
    across.from = PhraseAt(tokens, from);
    if (across.from.empty()) return {};
    std::size_t next = across.from.end + (IsMark(tokens, across.from.end) ? 1 : 0);
    if (WordAt(tokens, next) == "from") ++next;
    if (WordAt(tokens, next) == "across") {
      across.middle = PhraseAt(tokens, next + 1);
      across.end = across.middle.end;
    } else {
      const Across side = TakeFarSide(tokens, next);
      across.middle = side.middle;
      across.end = side.end;
    }
    return across.middle.empty() ? Across() : across;
  }
  if (WordAt(tokens, at) == "across") {
    across.middle = PhraseAt(tokens, at + 1);
  } else {
    across = TakeFarSide(tokens, at);
  }
  if (across.middle.empty() || WordAt(tokens, across.middle.end) != "from") return {};
  across.from = PhraseAt(tokens, across.middle.end + 1);
  across.end = across.from.empty() ? 0 : across.from.end;
  return across;
}

// "Across the river from the town lies a forest": the river lies between the town and a forest.
void TurnAcrossFrom(std::vector<Token>* tokens, std::size_t at) {
  const Across across = TakeAcross(*tokens, at);
  if (across.end == 0) {
    // "Opposite the village there is a farm, on the other bank of the river."
    if (WordAt(*tokens, at) != "opposite" || !OpensClause(*tokens, at)) return;
    const Span from = PhraseAt(*tokens, at + 1);
    const Span other = PhraseAt(*tokens, SkipBeing(*tokens, from.end));
    const std::size_t side = other.end + (IsMark(*tokens, other.end) ? 1 : 0);
    const Across far = TakeFarSide(*tokens, side);
    if (!from.empty() && !other.empty() && far.end > 0)
      SayBetween(tokens, {at, far.end}, far.middle, from, other);
    return;
  }
  if (OpensClause(*tokens, at)) {
    std::size_t thing = across.end + (IsMark(*tokens, across.end) ? 1 : 0);
    if (WordAt(*tokens, thing) == "that") ++thing;
    thing = SkipBeing(*tokens, thing);
    if (WordAt(*tokens, thing) == "all") ++thing;
    const Span other = PhraseAt(*tokens, thing);
    if (other.empty()) return;
    SayBetween(tokens, {at, other.end}, across.middle, across.from, other);
    return;
  }
  const Span other = PhraseBefore(*tokens, BeingBegin(*tokens, at));
  if (other.empty()) return;
  const std::size_t begin = BeingBegin(*tokens, other.begin);
  if (!OpensClause(*tokens, begin)) return;
  // "a track across the river from the town to the mill"
  const ClassWord* noun = NounBefore(*tokens, other.end);
  const bool line = noun != nullptr && noun->shape == WordShape::kLine;
  if (WordAt(*tokens, across.end) == "to" || (line && WordAt(*tokens, at) == "across")) return;
  // "a lake facing the forest, on the other side of the road a village"
  if (PhraseEnd(*tokens, across.end) > across.end) return;
  SayBetween(tokens, {begin, across.end}, across.middle, other, across.from);
}

// "A river with houses on the near side and a forest on the far side", "on one bank ... on the
// other": on one side of it, on the other side.
void TurnNearSide(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on") return;
  const bool near = WordAt(*tokens, at + 1) == "the" && WordAt(*tokens, at + 2) == "near";
  const bool one =
      WordAt(*tokens, at + 1) == "one" && IsOneOf(WordAt(*tokens, at + 2), {"bank", "shore"});
  const std::size_t end = at + (near ? 4 : 3);
  if (!near && !one) return;
  if (!IsOneOf(WordAt(*tokens, end - 1), {"side", "bank", "shore"}) ||
      WordAt(*tokens, end) == "of") {
    return;
  }
  for (std::size_t i = end; !IsStopAt(*tokens, i); ++i) {
    const bool far = WordAt(*tokens, i) == "on" && WordAt(*tokens, i + 1) == "the" &&
                     IsOneOf(WordAt(*tokens, i + 2), {"far", "other", "opposite"});
    if (!far) continue;
    const std::size_t side = IsFlank(WordAt(*tokens, i + 3)) ? 4 : 3;
    if (!IsPauseAt(*tokens, i + side)) return;
    ReplaceTokens(tokens, i, side, {"on", "the", "other", "side"});
    // "a lake with trees on one shore and houses on the other shore": of the lake
    std::string owner;
    for (const NamedThing& named : NamedBefore(*tokens, at)) {
      if (!one || named.begin < SentenceBegin(*tokens, at)) break;
      if (MatchClassWord(*tokens, named.begin).word->wild == 'W')
        owner = "of the " + JoinWords(*tokens, named.begin, named.end);
    }
    InsertTokens(tokens, i + 4, SaidLike(owner, (*tokens)[i]));
    ReplaceTokens(tokens, at, end - at, {"on", "one", "side"});
    InsertTokens(tokens, at + 3, SaidLike(owner, (*tokens)[at]));
    return;
  }
}

// "A belt of trees shields the houses from the road", "the lake cuts the forest off from the town":
// lies between them. "Cuts the village off from the rest": is next to the village.
void TurnShields(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view verb = WordAt(*tokens, at);
  const bool cuts = IsOneOf(verb, {"cuts", "cut", "cutting", "shuts", "shut", "separates",
                                   "separate", "separating", "isolates", "isolate", "parts"});
  const bool shields =
      IsOneOf(verb, {"shields",  "shield",  "shielding",  "screens", "screen", "screening",
                     "protects", "protect", "protecting", "hides",   "hide",   "hiding",
                     "shelters", "shelter", "sheltering", "guards",  "guard",  "insulates",
                     "insulate", "buffers", "buffer"});
  if ((!cuts && !shields) || at == 0) return;
  const std::string_view before = WordAt(*tokens, at - 1);
  const bool said = IsOneOf(before, {"should", "must", "shall", "which", "that", "to", "will"});
  if (!said && PhraseBegin(*tokens, at) == at) return;
  std::size_t thing = at + 1;
  if (cuts && WordAt(*tokens, thing) == "off") ++thing;
  const Span one = PhraseAt(*tokens, thing);
  if (one.empty()) return;
  std::size_t from = one.end;
  const bool off = thing > at + 1 || WordAt(*tokens, from) == "off";
  if (WordAt(*tokens, from) == "off") ++from;
  if (WordAt(*tokens, from) != "from" || (verb.substr(0, 3) == "cut" && !off)) return;
  const Span other = PhraseAt(*tokens, from + 1);
  const std::size_t rest = from + 1 + (WordAt(*tokens, from + 1) == "the" ? 1 : 0);
  if (cuts && other.empty() && IsOneOf(WordAt(*tokens, rest), {"rest", "remainder", "world"})) {
    std::size_t end = rest + 1;
    PlaceCursor cursor(*tokens, end);
    if (TakeWholeMap(&cursor)) end = cursor.at();
    EraseTokens(tokens, one.end, end - one.end);
    ReplaceTokens(tokens, at, thing - at, {"is", "next", "to"});
    return;
  }
  // "hides it from the north", "from the wind"
  if (other.empty() || IsOneOf(verb, {"separates", "separate", "separating"})) return;
  ReplaceTokens(tokens, one.end, from + 1 - one.end, {"and"});
  ReplaceTokens(tokens, at, thing - at, {"lies", "between"});
}

// "The village is cut off from the rest of the map by a river": is next to a river.
void TurnCutOff(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"cut", "separated", "shut", "isolated", "set", "parted"}))
    return;
  std::size_t from = at + 1;
  if (IsOneOf(WordAt(*tokens, from), {"off", "apart", "away"})) ++from;
  if (WordAt(*tokens, from) != "from") return;
  std::size_t end = from + 1;
  if (WordAt(*tokens, end) == "everything" && WordAt(*tokens, end + 1) == "else") {
    end += 2;
  } else {
    if (WordAt(*tokens, end) == "the") ++end;
    if (WordAt(*tokens, end) == "outside") ++end;
    if (!IsOneOf(WordAt(*tokens, end), {"rest", "remainder", "world"})) return;
    ++end;
    PlaceCursor cursor(*tokens, end);
    if (TakeWholeMap(&cursor)) end = cursor.at();
  }
  if (WordAt(*tokens, end) != "by" || PhraseEnd(*tokens, end + 1) == end + 1) return;
  ReplaceTokens(tokens, at, end + 1 - at, {"next", "to"});
}

}  // namespace

void TurnAcross(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnFacingPairs(tokens, at);
    TurnOpposed(tokens, at);
    TurnAcrossFrom(tokens, at);
    TurnNearSide(tokens, at);
    TurnShields(tokens, at);
    TurnCutOff(tokens, at);
  }
}

}  // namespace latticeworld
