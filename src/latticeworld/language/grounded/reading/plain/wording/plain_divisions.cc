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
#include "latticeworld/language/token_edits.h"

// Land that something divides, and places that are told by what lies over against them.
namespace latticeworld {
namespace {

struct TaggedSide {
  std::string_view land;
  std::string side;
  std::size_t end = 0;  // the token after it; 0: there is none
};

// "a forested north", "an agricultural half in the south" is none.
TaggedSide TakeTaggedSide(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"a", "an"})) return {};
  TaggedSide tagged;
  tagged.land = LandOfAdjective(WordAt(tokens, at + 1));
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

// "The map is split by a river into an eastern and a western part": a river splits it. "Splits the
// map into a left and a right part; the left one is forest, the latter grass": runs from north to
// south; the left half, the east half.
void TurnPartsOfMap(std::vector<Token>* tokens, std::size_t at) {
  const auto splits = [&](std::size_t i) {
    return IsOneOf(WordAt(*tokens, i), {"split", "divided", "cut", "parted", "separated"});
  };
  if (IsMapWord(WordAt(*tokens, at)) && WordAt(*tokens, at + 1) == "is" && splits(at + 2) &&
      WordAt(*tokens, at + 3) == "by") {
    std::size_t into = at + 4;
    while (!IsPauseAt(*tokens, into) && !IsOneOf(WordAt(*tokens, into), {"into", "in"})) ++into;
    if (IsPauseAt(*tokens, into) || !NamesThing(*tokens, at + 4)) return;
    std::vector<Token> said = TokensBetween(*tokens, at + 4, into);
    for (const std::string_view word : {"splits", "the", "map"})
      said.push_back(WordLike(word, (*tokens)[at]));
    const std::size_t begin = at - (at > 0 && WordAt(*tokens, at - 1) == "the" ? 1 : 0);
    EraseTokens(tokens, begin, into - begin);
    InsertTokens(tokens, begin, said);
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at), {"splits", "divides", "cuts", "parts"})) return;
  std::size_t into = at + 1;
  while (!IsPauseAt(*tokens, into) && WordAt(*tokens, into) != "into" && into < at + 4) ++into;
  const auto side_at = [&](std::size_t i) -> std::string_view {
    return IsOneOf(WordAt(*tokens, i), {"a", "an"}) ? SideWord(WordAt(*tokens, i + 1))
                                                    : std::string_view();
  };
  const std::string first(side_at(into + 1)), second(side_at(into + 4));
  if (WordAt(*tokens, into) != "into" || first.empty() || second.empty() ||
      WordAt(*tokens, into + 3) != "and" ||
      !IsOneOf(WordAt(*tokens, into + 6), {"part", "half", "side"})) {
    return;
  }
  bool map = false;
  for (std::size_t i = at + 1; i < into; ++i)
    map = map || IsMapWord(WordAt(*tokens, i)) || WordAt(*tokens, i) == "ground";
  if (!map) return;
  // "..., all forest, and an eastern part, all fields": of TurnBanks.
  if (!IsStopAt(*tokens, into + 7)) return;
  for (std::size_t i = into + 7; i < tokens->size(); ++i) {
    if (WordAt(*tokens, i) == "one" && !SideWord(WordAt(*tokens, i - 1)).empty())
      (*tokens)[i].text = "half";
    if (IsOneOf(WordAt(*tokens, i), {"former", "latter"}))
      ReplaceTokens(tokens, i, 1, {WordAt(*tokens, i) == "former" ? first : second, "half"});
  }
  const bool rows = IsOneOf(first, {"north", "south"});
  ReplaceTokens(tokens, at, into + 7 - at,
                {"runs", "from", rows ? "west" : "north", "to", rows ? "east" : "south"});
}

// "A lake in one corner and a village in the opposite corner": two corners over against each other,
// and no words say which.
void TurnOppositeCorners(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "one" || WordAt(*tokens, at + 1) != "corner") return;
  for (std::size_t other = at + 2; !IsStopAt(*tokens, other); ++other) {
    if (WordAt(*tokens, other) != "the" ||
        !IsOneOf(WordAt(*tokens, other + 1), {"opposite", "other"}) ||
        !(WordAt(*tokens, other + 2) == "corner" ||
          (WordAt(*tokens, other + 1) == "opposite" && WordAt(*tokens, other + 2) == "one"))) {
      continue;
    }
    ReplaceTokens(tokens, other, 3, {"the", "south", "east", "corner"});
    ReplaceTokens(tokens, at, 2, {"the", "north", "west", "corner"});
    return;
  }
}

// "Half of the land is forest and half rock, separated by a river": with a river between them.
void TurnSeparatedBy(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || (*tokens)[at - 1].kind != TokenKind::kComma ||
      !IsOneOf(WordAt(*tokens, at), {"separated", "divided"}) || WordAt(*tokens, at + 1) != "by") {
    return;
  }
  const std::size_t end = PauseAfter(*tokens, at);
  int halves = 0;
  for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i)
    halves += WordAt(*tokens, i) == "half" ? 1 : 0;
  if (halves != 2 || !IsStopAt(*tokens, end) || !NamesThing(*tokens, at + 2)) return;
  InsertTokens(tokens, end, {WordLike("between", (*tokens)[at]), WordLike("them", (*tokens)[at])});
  ReplaceTokens(tokens, at, 2, {"with"});
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
  std::size_t begin = SentenceBegin(*tokens, at);
  if (begin > 0) begin = SentenceBegin(*tokens, begin - 1);
  for (std::size_t i = begin; i < at; ++i) halves += WordAt(*tokens, i) == "half" ? 1 : 0;
  if (halves == 2)
    ReplaceTokens(tokens, at, end - at, {"along", "the", "border", "between", "them"});
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

// "The south is grass and a river runs along the boundary", "a river runs diagonally and a road
// runs parallel to it": a sentence each.
void TurnAndRuns(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "and" || !IsOneOf(WordAt(*tokens, at + 1), {"a", "the", "one"}))
    return;
  std::size_t line = at + 2;
  if (IsOneOf(WordAt(*tokens, line), {"small", "narrow", "wide", "straight", "winding"})) ++line;
  const ClassWordMatch match = MatchClassWord(*tokens, line);
  if (match.word == nullptr || match.word->shape != WordShape::kLine ||
      !IsOneOf(WordAt(*tokens, line + match.tokens), {"runs", "flows", "winds"})) {
    return;
  }
  const std::size_t begin = SentenceBegin(*tokens, at);
  bool said = false;
  for (std::size_t i = begin; i < at; ++i)
    said = said || IsOneOf(WordAt(*tokens, i), {"is", "are", "diagonally"});
  if (said) (*tokens)[at] = StopLike((*tokens)[at]);
}

// "Trees everywhere except along the road": away from it. "Leave some space between the
// forest and the road": the forest away from it. "A third of the width of the map": a third of it.
void TurnSpaces(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  if (word == "everywhere" && IsOneOf(WordAt(*tokens, at + 1), {"except", "but"}) &&
      IsOneOf(WordAt(*tokens, at + 2), {"along", "beside", "near"})) {
    ReplaceTokens(tokens, at + 1, 2, {"away", "from"});
    return;
  }
  if (word == "of" && WordAt(*tokens, at + 1) == "the" &&
      IsOneOf(WordAt(*tokens, at + 2), {"width", "height"}) && WordAt(*tokens, at + 3) == "of") {
    EraseTokens(tokens, at, 3);
    return;
  }
  if (!IsOneOf(word, {"leave", "keep"})) return;
  std::size_t next = at + 1;
  while (IsOneOf(WordAt(*tokens, next), {"some", "a", "enough", "little", "bit", "of", "small"}))
    ++next;
  if (!IsOneOf(WordAt(*tokens, next), {"space", "room", "gap", "distance"}) ||
      WordAt(*tokens, next + 1) != "between") {
    return;
  }
  std::size_t and_at = next + 2;
  while (!IsPauseAt(*tokens, and_at) && WordAt(*tokens, and_at) != "and") ++and_at;
  if (WordAt(*tokens, and_at) != "and" || !NamesThing(*tokens, next + 2)) return;
  ReplaceTokens(tokens, and_at, 1, {"is", "away", "from"});
  EraseTokens(tokens, at, next + 2 - at);
}

// "Trees line the river": stand along it. "Runs alongside the river for its whole length", "a path
// beside the stream, all the way": along it.
void TurnAlong(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  if (IsOneOf(word, {"line", "lines"}) && at > 0 &&
      IsOneOf(WordAt(*tokens, at + 1), {"the", "a", "its", "this"}) &&
      MatchClassWord(*tokens, at - 1).tokens > 0 && MatchClassWord(*tokens, at + 2).tokens > 0) {
    ReplaceTokens(tokens, at, 1, {"stand", "along"});
    return;
  }
  if (!IsOneOf(word, {"alongside", "beside", "next", "by"})) return;
  const std::size_t the = at + (word == "next" ? 2 : 1);
  if (WordAt(*tokens, the) != "the" && WordAt(*tokens, the) != "a") return;
  std::size_t end = the + 1 + MatchClassWord(*tokens, the + 1).tokens;
  if (end == the + 1) return;
  const std::size_t noun_end = end;
  if (!IsStopAt(*tokens, end) && (*tokens)[end].kind == TokenKind::kComma) ++end;
  std::size_t after = end;
  if (WordAt(*tokens, end) == "all" && WordAt(*tokens, end + 1) == "the" &&
      WordAt(*tokens, end + 2) == "way") {
    after = end + 3;
  } else if (IsOneOf(WordAt(*tokens, end), {"for", "along"}) &&
             IsOneOf(WordAt(*tokens, end + 1), {"its", "the"}) &&
             IsOneOf(WordAt(*tokens, end + 2), {"whole", "entire", "full"}) &&
             WordAt(*tokens, end + 3) == "length") {
    after = end + 4;
  }
  if (after == end || !IsPauseAt(*tokens, after)) return;
  EraseTokens(tokens, noun_end, after - noun_end);
  ReplaceTokens(tokens, at, the - at, {"along"});
}

// "A right angle turn", "turns at a right angle": a bend, and nothing to the right.
void TurnRightAngle(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "right" || WordAt(*tokens, at + 1) != "angle") return;
  const std::size_t turn = at + 2;
  const bool noun = IsOneOf(WordAt(*tokens, turn), {"turn", "bend", "corner", "curve"});
  ReplaceTokens(tokens, at, noun ? 3 : 2, {"bend"});
}

// "Top: forest. Middle: grass. Bottom: water": the rows in the middle.
void TurnMiddleRow(std::vector<Token>* tokens) {
  const auto label = [&](std::size_t at, std::string_view word) {
    return WordAt(*tokens, at) == word && at + 1 < tokens->size() &&
           IsOneOf((*tokens)[at + 1].text, {":", "=", "-"}) &&
           (at == 0 || IsPauseAt(*tokens, at - 1));
  };
  std::size_t middle = 0;
  bool top = false, bottom = false;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (label(at, "middle")) middle = at;
    top = top || label(at, "top");
    bottom = bottom || label(at, "bottom");
  }
  if (top && bottom && middle > 0) ReplaceTokens(tokens, middle, 1, {"middle", "rows"});
}

}  // namespace

void TurnDivisions(std::vector<Token>* tokens) {
  TurnMiddleRow(tokens);
  for (std::size_t at = 0; at < tokens->size(); ++at) TurnAndRuns(tokens, at);
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnTaggedSides(tokens, at);
    TurnPartsOfMap(tokens, at);
    TurnOppositeCorners(tokens, at);
    TurnInnerBorder(tokens, at);
    TurnSeparatedBy(tokens, at);
    TurnBehindIt(tokens, at);
    TurnSpaces(tokens, at);
    TurnAlong(tokens, at);
    TurnRightAngle(tokens, at);
  }
}

}  // namespace latticeworld
