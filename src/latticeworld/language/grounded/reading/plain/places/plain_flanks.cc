#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// The other side of a thing, and what lies on a side of it.
namespace latticeworld {
namespace {

// "on the town's other side, to the west, the waste began": to the west of the town.
void TurnOtherFlanks(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"on", "at", "along"})) continue;
    // "on its other side", "on the town's far bank"
    std::size_t next = at + 1;
    const bool own = IsOneOf(WordAt(*tokens, next), {"its", "the"});
    if (!own) continue;
    const bool its = WordAt(*tokens, next) == "its";
    ++next;
    const ClassWordMatch owner = MatchClassWord(*tokens, next);
    const std::size_t owner_at = next;
    if (owner.word != nullptr) next += owner.tokens;
    if (!IsOneOf(WordAt(*tokens, next), {"other", "one", "opposite", "far"}) ||
        !IsFlank(WordAt(*tokens, next + 1))) {
      continue;
    }
    next += 2;
    // "... of the town"
    std::size_t of_begin = 0;
    std::size_t of_end = 0;
    if (WordAt(*tokens, next) == "of" && owner.word == nullptr) {
      of_begin = next + 1;
      const std::size_t thing = of_begin + (WordAt(*tokens, of_begin) == "the" ? 1 : 0);
      const ClassWordMatch noun = MatchClassWord(*tokens, thing);
      of_end = WordAt(*tokens, thing) == "it" ? thing + 1 : thing + noun.tokens;
      if (of_end == thing) continue;
      next = of_end;
    }
    // The direction follows between commas.
    if (!IsMark(*tokens, next)) continue;
    ++next;
    if (IsOneOf(WordAt(*tokens, next), {"to", "on", "in"})) ++next;
    Heading heading;
    std::size_t end = TakeHeading(*tokens, next, &heading);
    if (end == 0) continue;
    if (IsFlank(WordAt(*tokens, end)) || WordAt(*tokens, end) == "one") ++end;
    if (!IsMark(*tokens, end)) continue;
    // It is said of the owner instead: "to the west of the town".
    const Token beside = (*tokens)[at];
    std::vector<Token> turned = {WordLike("to", beside), WordLike("the", beside),
                                 WordLike(NameOf(heading), beside), WordLike("of", beside)};
    if (owner.word != nullptr) {
      turned.push_back(WordLike("the", beside));
      for (std::size_t i = 0; i < owner.tokens; ++i) turned.push_back((*tokens)[owner_at + i]);
    } else if (of_end > of_begin) {
      for (std::size_t i = of_begin; i < of_end; ++i) turned.push_back((*tokens)[i]);
    } else {
      turned.push_back(WordLike("it", beside));
    }
    if (its) turned.back().text = "it";
    EraseTokens(tokens, at, end + 1 - at);
    InsertTokens(tokens, at, turned);
    at += turned.size() - 1;
  }
}

// "what lies north of it is forest", "the land south of the road is fields": there is forest.
void TurnWhatLies(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 5 < tokens->size(); ++at) {
    std::size_t next = at;
    if (WordAt(*tokens, next) == "the") ++next;
    if (!IsOneOf(WordAt(*tokens, next), {"what", "whatever", "land", "ground", "part", "area"})) {
      continue;
    }
    const bool what = IsOneOf(WordAt(*tokens, next), {"what", "whatever"});
    ++next;
    if (IsOneOf(WordAt(*tokens, next), {"that", "which"})) ++next;
    const bool lies = IsOneOf(WordAt(*tokens, next), {"lies", "is", "stands", "stretches"});
    if (lies) ++next;
    if (what && !lies) continue;
    const std::size_t side = next;
    if (IsOneOf(WordAt(*tokens, next), {"to", "on"})) ++next;
    Heading heading;
    const bool above = IsOneOf(WordAt(*tokens, next), {"above", "below", "beyond", "behind"});
    const std::size_t of = above ? next + 1 : TakeHeading(*tokens, next, &heading);
    if (of == 0 || (!above && WordAt(*tokens, of) != "of")) continue;
    std::size_t thing = of + (above ? 0 : 1);
    if (WordAt(*tokens, thing) == "it") {
      ++thing;
    } else {
      if (IsOneOf(WordAt(*tokens, thing), {"the", "this", "that"})) ++thing;
      const ClassWordMatch noun = MatchClassWord(*tokens, thing);
      if (noun.word == nullptr) continue;
      thing += noun.tokens;
    }
    if (!IsOneOf(WordAt(*tokens, thing), {"is", "are", "should", "must", "stays", "remains"})) {
      continue;
    }
    std::size_t verb = thing + 1;
    if (WordAt(*tokens, verb) == "be") ++verb;
    ReplaceTokens(tokens, thing, verb - thing, {"there", "is"});
    EraseTokens(tokens, at, side - at);
    at = thing - (side - at);
  }
}

// "West of the road there is forest, on the other side of it houses": east of the road.
void TurnOppositeSides(std::vector<Token>* tokens) {
  Heading told;
  std::vector<Token> line;
  int stops = 0;
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at) && ++stops > 1) line.clear();
    // "West of the road": the side and the line are remembered for this sentence and the next.
    Heading heading;
    const std::size_t of = TakeHeading(*tokens, at, &heading);
    if (of > 0 && WordAt(*tokens, of) == "of") {
      const std::size_t noun = of + (WordAt(*tokens, of + 1) == "the" ? 2 : 1);
      const ClassWordMatch match = MatchClassWord(*tokens, noun);
      if (match.word != nullptr && match.word->shape == WordShape::kLine) {
        told = heading;
        stops = 0;
        line.assign(tokens->begin() + static_cast<std::ptrdiff_t>(noun),
                    tokens->begin() + static_cast<std::ptrdiff_t>(noun + match.tokens));
        at = noun;
        continue;
      }
    }
    // "on the other side", of that line or without saying of what
    if (line.empty() || !IsOneOf(WordAt(*tokens, at), {"on", "to", "at"}) ||
        WordAt(*tokens, at + 1) != "the" ||
        !IsOneOf(WordAt(*tokens, at + 2), {"other", "opposite", "far"}) ||
        !IsFlank(WordAt(*tokens, at + 3))) {
      continue;
    }
    std::size_t end = at + 4;
    if (WordAt(*tokens, end) == "of") {
      const std::size_t noun = end + (WordAt(*tokens, end + 1) == "the" ? 2 : 1);
      const bool same =
          WordAt(*tokens, noun) == "it" ||
          JoinWords(*tokens, noun, noun + line.size()) == JoinWords(line, 0, line.size());
      if (!same) continue;
      end = WordAt(*tokens, noun) == "it" ? noun + 1 : noun + line.size();
    }
    // It becomes the opposite direction.
    const Heading opposite{-told.east, -told.south};
    std::vector<std::string> names;
    for (const Token& token : line) names.push_back(token.text);
    std::vector<std::string_view> words = {"to", "the", NameOf(opposite), "of", "the"};
    for (const std::string& name : names) words.push_back(name);
    if (MatchClassWord(*tokens, end).word != nullptr ||
        IsOneOf(WordAt(*tokens, end), {"a", "an", "only", "some", "the"})) {
      words.insert(words.end(), {"there", "is"});
    }
    ReplaceTokens(tokens, at, end - at, words);
    line.clear();
  }
}

// "The lake is in one corner, the top right": in the top right corner. "in the corner diagonally
// opposite": in the opposite corner.
void TurnNamedCorner(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    const std::string noun(WordAt(*tokens, at));
    if (!IsOneOf(noun, {"corner", "half", "side", "edge", "quarter", "end"})) continue;
    if (noun == "corner" && WordAt(*tokens, at + 1) == "diagonally" &&
        WordAt(*tokens, at + 2) == "opposite") {
      // Both words stand for all three.
      (*tokens)[at].end = (*tokens)[at + 2].end;
      EraseTokens(tokens, at + 1, 2);
      InsertTokens(tokens, at, {WordLike("opposite", (*tokens)[at])});
      continue;
    }
    if (!IsOneOf(WordAt(*tokens, at - 1), {"one", "a", "far"}) || !IsMark(*tokens, at + 1))
      continue;
    const std::size_t place = at + 2 + (WordAt(*tokens, at + 2) == "namely" ? 1 : 0);
    Heading heading;
    std::size_t end = TakeHeading(*tokens, place, &heading);
    if (end == 0 || heading.IsDiagonal() != (noun == "corner" || noun == "quarter")) continue;
    const std::vector<Token> side(tokens->begin() + static_cast<std::ptrdiff_t>(place),
                                  tokens->begin() + static_cast<std::ptrdiff_t>(end));
    if (IsOneOf(WordAt(*tokens, end), {"one", noun})) ++end;
    const bool closes = IsMark(*tokens, end) && (*tokens)[at + 1].text == "(";
    if (!closes && !IsPauseAt(*tokens, end)) continue;
    EraseTokens(tokens, at + 1, end + (closes ? 1 : 0) - at - 1);
    std::vector<Token> turned = side;
    if (WordAt(side, 0) != "the") turned.insert(turned.begin(), WordLike("the", side.front()));
    const std::size_t one = WordAt(*tokens, at - 2) == "the" ? 2 : 1;  // "the far corner"
    EraseTokens(tokens, at - one, one);
    InsertTokens(tokens, at - one, turned);
  }
}

// "the higher one", of two that were named: the upper one.
void TurnHigher(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) == "the" && WordAt(*tokens, at + 1) == "higher" &&
        WordAt(*tokens, at + 2) == "one") {
      (*tokens)[at + 1].text = "upper";
      // "the higher one, further north, among rocks"
      if (!IsMark(*tokens, at + 3) ||
          !IsOneOf(WordAt(*tokens, at + 4), {"further", "farther", "more", "that"})) {
        continue;
      }
      const std::size_t end = PauseAfter(*tokens, at + 4);
      if (IsMark(*tokens, end) && end < at + 8) EraseTokens(tokens, at + 3, end + 1 - at - 3);
    }
  }
}

// "Rocks on the right: the sea at the very edge": at the right edge.
void TurnVeryEdge(std::vector<Token>* tokens) {
  std::vector<Token> side;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) side.clear();
    if (IsOneOf(WordAt(*tokens, at), {"on", "in"}) && WordAt(*tokens, at + 1) == "the") {
      Heading heading;
      const std::size_t end = TakeHeading(*tokens, at + 1, &heading);
      if (end > 0 && !heading.IsDiagonal() && WordAt(*tokens, end) != "of") {
        side.assign(tokens->begin() + static_cast<std::ptrdiff_t>(at + 2),
                    tokens->begin() + static_cast<std::ptrdiff_t>(end));
        at = end - 1;
        continue;
      }
    }
    if (side.empty() || !IsOneOf(WordAt(*tokens, at), {"at", "along", "on"}) ||
        WordAt(*tokens, at + 1) != "the") {
      continue;
    }
    std::size_t edge = at + 2;
    while (IsOneOf(WordAt(*tokens, edge), {"very", "extreme", "outermost", "outer"})) ++edge;
    if (edge == at + 2 || WordAt(*tokens, edge) != "edge" || WordAt(*tokens, edge + 1) == "of") {
      continue;
    }
    EraseTokens(tokens, at + 2, edge - at - 2);
    std::vector<Token> words;
    for (const Token& token : side) words.push_back(WordLike(token.text, (*tokens)[at + 2]));
    InsertTokens(tokens, at + 2, words);
  }
}

}  // namespace

void TurnFlanks(std::vector<Token>* tokens) {
  TurnOtherFlanks(tokens);
  TurnWhatLies(tokens);
  TurnOppositeSides(tokens);
  TurnNamedCorner(tokens);
  TurnHigher(tokens);
  TurnVeryEdge(tokens);
}

}  // namespace latticeworld
