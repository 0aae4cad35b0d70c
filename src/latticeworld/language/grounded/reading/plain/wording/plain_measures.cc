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

// How much of the map, how large, and all of what.
namespace latticeworld {
namespace {

// "Houses may take up to 20 percent": cover at most so much. "Water for the remaining 10 %": 10
// percent water.
void TurnUpTo(std::vector<Token>* tokens, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at),
              {"take", "takes", "taking", "cover", "covers", "fill", "fills"}) &&
      WordAt(*tokens, at + 1) == "up" && WordAt(*tokens, at + 2) == "to" &&
      IsNumberAt(*tokens, at + 3)) {
    ReplaceTokens(tokens, at, 3, {"covers", "at", "most"});
    return;
  }
  if (WordAt(*tokens, at) == "for" && WordAt(*tokens, at + 1) == "the" &&
      IsOneOf(WordAt(*tokens, at + 2), {"remaining", "other", "last"}) &&
      IsNumberAt(*tokens, at + 3) && WordAt(*tokens, at + 4) == "percent") {
    EraseTokens(tokens, at, 3);
  }
}

// "Forest 40 %, rock 20 % and water 10 %": a share each, and not the last one for all.
void TurnShareList(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "and" || at < 3) return;
  const std::size_t last = at - ((*tokens)[at - 1].kind == TokenKind::kComma ? 2 : 1);
  if (WordAt(*tokens, last) != "percent" || !IsNumberAt(*tokens, last - 1) ||
      (last >= 2 && WordAt(*tokens, last - 2).empty())) {
    return;
  }
  const std::size_t number = at + 1 + MatchClassWord(*tokens, at + 1).tokens;
  if (number == at + 1 || !IsNumberAt(*tokens, number) ||
      WordAt(*tokens, number + 1) != "percent") {
    return;
  }
  if (last == at - 2) {
    EraseTokens(tokens, at, 1);
  } else {
    (*tokens)[at] = CommaLike((*tokens)[at]);
  }
}

// "Forest 40, fields 30, water 10 and houses 20 percent": percent each. "Equal amounts of": equal
// parts.
void TurnShareOnce(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "equal" && WordAt(*tokens, at + 1) == "amounts" &&
      WordAt(*tokens, at + 2) == "of") {
    ReplaceTokens(tokens, at + 1, 2, {"parts"});
    return;
  }
  if (WordAt(*tokens, at) != "percent" || at < 2 || !IsNumberAt(*tokens, at - 1)) return;
  std::size_t noun = at - 1;
  while (noun > 0 && (*tokens)[noun - 1].kind == TokenKind::kWord &&
         WordAt(*tokens, noun - 1) != "and") {
    --noun;
  }
  while (noun > 2) {
    std::size_t link = noun - 1;
    if (WordAt(*tokens, link) == "and" && (*tokens)[link - 1].kind == TokenKind::kComma) --link;
    const bool listed = (*tokens)[link].kind == TokenKind::kComma || WordAt(*tokens, link) == "and";
    if (!listed || !IsNumberAt(*tokens, link - 1)) return;
    std::size_t begin = link - 1;
    while (begin > 0 && (*tokens)[begin - 1].kind == TokenKind::kWord) --begin;
    if (begin + MatchClassWord(*tokens, begin).tokens != link - 1) return;
    InsertTokens(tokens, link, {WordLike("percent", (*tokens)[link - 1])});
    noun = begin;
  }
}

// "A 5 by 5 lake", "a 5x5 lake": a lake 5 cells across. "Four fields in a two by two arrangement":
// four fields.
void TurnSquare(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "in" && WordAt(*tokens, at + 1) == "a" && at + 5 < tokens->size() &&
      IsOneOf(WordAt(*tokens, at + 3), {"by", "x"}) &&
      IsOneOf(WordAt(*tokens, at + 5), {"arrangement", "grid", "pattern"})) {
    EraseTokens(tokens, at, 6);
    return;
  }
  if (!IsNumberAt(*tokens, at) || !IsOneOf(WordAt(*tokens, at + 1), {"by", "x"}) ||
      !IsNumberAt(*tokens, at + 2)) {
    return;
  }
  std::size_t noun = at + 3;
  if (IsOneOf(WordAt(*tokens, noun), {"cell", "cells"})) ++noun;
  const std::size_t length = MatchClassWord(*tokens, noun).tokens;
  if (length == 0) return;
  const Token number = (*tokens)[at];
  InsertTokens(tokens, noun + length,
               {number, WordLike("cells", number), WordLike("across", number)});
  EraseTokens(tokens, at, noun - at);
}

// "Change the right third to farmland": it is farmland.
void TurnChange(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"change", "turn", "convert"}) ||
      (at > 0 && !IsPauseAt(*tokens, at - 1) && WordAt(*tokens, at - 1) != "please") ||
      WordAt(*tokens, at + 1) != "the") {
    return;
  }
  std::size_t to = at + 2;
  while (!IsPauseAt(*tokens, to) && !IsOneOf(WordAt(*tokens, to), {"to", "into"})) ++to;
  if (IsPauseAt(*tokens, to) || MatchClassWord(*tokens, to + 1).tokens == 0) return;
  ReplaceTokens(tokens, to, 1, {"is"});
  EraseTokens(tokens, at, 1);
}

// "Makes a big curve around the village": bends around it.
void TurnCurve(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"makes", "make", "takes", "describes"})) return;
  std::size_t next = at + 1;
  if (WordAt(*tokens, next) == "a") ++next;
  if (IsSize(WordAt(*tokens, next)) || WordAt(*tokens, next) == "wide") ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"curve", "bend", "arc", "turn"}) ||
      !IsOneOf(WordAt(*tokens, next + 1), {"around", "round"})) {
    return;
  }
  ReplaceTokens(tokens, at, next + 1 - at, {"bends"});
}

// "Two diagonal roads that cross": they have the shape of an X.
void TurnDiagonalCross(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "diagonal" || at == 0 ||
      !IsOneOf((*tokens)[at - 1].text, {"two", "2"})) {
    return;
  }
  const std::size_t noun = at + 1;
  const std::size_t that = noun + MatchClassWord(*tokens, noun).tokens;
  if (that == noun || !IsOneOf(WordAt(*tokens, that), {"that", "which", "crossing"})) return;
  const std::size_t cross = that + (WordAt(*tokens, that) == "crossing" ? 0 : 1);
  if (!IsOneOf(WordAt(*tokens, cross), {"cross", "intersect", "crossing"})) return;
  ReplaceTokens(tokens, that, cross + 1 - that, {"in", "the", "shape", "of", "an", "x"});
  EraseTokens(tokens, at, 1);
}

// "All the houses are in the north", "seven lakes, every one of them in the west", "the houses are
// all on the left": only there.
void TurnAllIn(std::vector<Token>* tokens, std::size_t at) {
  // Whether a place begins there; where the words of being end.
  const auto in_place = [&](std::size_t i) {
    if (!IsOneOf(WordAt(*tokens, i), {"in", "on", "at"})) return false;
    PlaceCursor cursor(*tokens, i + 1 + (WordAt(*tokens, i + 1) == "the" ? 1 : 0));
    return TakeDirection(&cursor).found;
  };
  const auto be_end = [&](std::size_t i) {
    while (
        IsOneOf(WordAt(*tokens, i), {"are", "is", "should", "must", "be", "all", "located", "found",
                                     "placed", "situated", "lie", "lies", "stand", "to"})) {
      ++i;
    }
    return i;
  };
  // "every one of them in the west", "all the houses are in the north"
  if (IsOneOf(WordAt(*tokens, at), {"all", "every", "each"})) {
    std::size_t next = at + 1;
    if (WordAt(*tokens, next) == "one") ++next;
    if (WordAt(*tokens, next) == "of") ++next;
    const bool them = WordAt(*tokens, next) == "them" && next > at + 1;
    if (them) {
      ++next;
      if (in_place(next)) ReplaceTokens(tokens, at, next - at, {"only"});
      return;
    }
    if (WordAt(*tokens, at) != "all" || (at > 0 && !IsStopAt(*tokens, at - 1))) return;
    const bool of_the = WordAt(*tokens, next) == "the";
    if (of_the) ++next;
    const ClassWordMatch match = MatchClassWord(*tokens, next);
    const bool mass = match.word != nullptr &&
                      (match.word->shape == WordShape::kMass || match.word->phrase == "water");
    if (match.word == nullptr || (!match.plural && !mass && !of_the)) return;
    const std::size_t be = next + match.tokens, end = be_end(be);
    if (end == be || !in_place(end)) return;
    ReplaceTokens(tokens, be, end - be, {"only"});
    EraseTokens(tokens, at, next - at);
    return;
  }
  // "are all on the left"
  if (IsOneOf(WordAt(*tokens, at), {"are", "must", "should"}) && at > 0) {
    const std::size_t end = be_end(at);
    bool all = false;
    for (std::size_t i = at; i < end; ++i) all = all || WordAt(*tokens, i) == "all";
    if (all && in_place(end)) ReplaceTokens(tokens, at, end - at, {"only"});
  }
}

// "Surrounded by farmland on three sides and by a river on the fourth": next to a river.
void TurnFourthSide(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "on" || WordAt(*tokens, at + 1) != "three" ||
      WordAt(*tokens, at + 2) != "sides" || WordAt(*tokens, at + 3) != "and") {
    return;
  }
  const std::size_t by = at + 4;
  const std::size_t end = PauseAfter(*tokens, by);
  if (end < by + 4 || WordAt(*tokens, end - 1) != "fourth" || WordAt(*tokens, end - 2) != "the" ||
      WordAt(*tokens, end - 3) != "on") {
    return;
  }
  EraseTokens(tokens, end - 3, 3);
  ReplaceTokens(tokens, by, WordAt(*tokens, by) == "by" ? 1 : 0, {"next", "to"});
}

// "Nothing growing in the upper half": no forest and no grass there. "Houses around a green": a
// lawn.
void TurnGrowing(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "nothing" &&
      IsOneOf(WordAt(*tokens, at + 1), {"grows", "growing", "green"})) {
    ReplaceTokens(tokens, at, 2, {"no", "forest", "and", "no", "grass"});
    return;
  }
  if (WordAt(*tokens, at) == "green" && at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"a", "the"}) &&
      (IsPauseAt(*tokens, at + 1) || IsOneOf(WordAt(*tokens, at + 1), {"with", "and", "in"}))) {
    (*tokens)[at].text = "lawn";
  }
}

}  // namespace

void TurnMapMeasures(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnUpTo(tokens, at);
    TurnShareOnce(tokens, at);
  }
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnShareList(tokens, at);
    TurnSquare(tokens, at);
    TurnChange(tokens, at);
    TurnCurve(tokens, at);
    TurnDiagonalCross(tokens, at);
    TurnAllIn(tokens, at);
    TurnFourthSide(tokens, at);
    TurnGrowing(tokens, at);
  }
}

}  // namespace latticeworld
