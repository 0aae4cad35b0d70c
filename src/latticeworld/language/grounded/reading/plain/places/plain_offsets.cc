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

// How far off, what lies outside, and strips that are called paths and bridges.
namespace latticeworld {
namespace {

bool IsCellWord(std::string_view word) {
  return IsOneOf(word, {"cell", "cells", "step", "steps", "tile", "tiles", "row", "rows", "column",
                        "columns", "metre", "metres", "meter", "meters"});
}

// "A few cells above the bottom", "two steps south of the river": above the bottom, south of it.
// "Two cells from the top": near the top.
void TurnCellsOff(std::vector<Token>* tokens, std::size_t at) {
  std::size_t unit = at;
  if (WordAt(*tokens, unit) == "a" && IsOneOf(WordAt(*tokens, unit + 1), {"few", "couple"})) {
    unit += 2;
    if (WordAt(*tokens, unit) == "of") ++unit;
  } else if (IsOneOf(WordAt(*tokens, unit),
                     {"one", "two", "three", "four", "five", "six", "some", "several"}) ||
             (unit < tokens->size() && (*tokens)[unit].kind == TokenKind::kNumber)) {
    ++unit;
  } else {
    return;
  }
  if (!IsCellWord(WordAt(*tokens, unit))) return;
  std::size_t begin = at;
  if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"about", "only", "just", "roughly"}))
    --begin;
  // "at least two cells north of", "a strip two cells wide": other things.
  if (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"least", "most", "than", "by", "of"}))
    return;
  std::size_t next = unit + 1;
  if (IsOneOf(WordAt(*tokens, next), {"away", "off"}) && WordAt(*tokens, next + 1) != "from")
    ++next;
  const std::string_view word = WordAt(*tokens, next);
  if (word == "from" || word == "off") {
    std::string place;
    const std::size_t end = TakeSideWords(*tokens, next + 1, &place);
    if (end == 0 || WordAt(*tokens, next + 1) != "the" || !IsPauseAt(*tokens, end)) return;
    ReplaceTokens(tokens, begin, next + 1 - begin, {"near"});
    return;
  }
  const bool above = IsOneOf(word, {"above", "below"});
  const bool heading = !HeadingWord(word).empty() && WordAt(*tokens, next + 1) == "of";
  const bool to = word == "to" && WordAt(*tokens, next + 1) == "the" &&
                  !SideWord(WordAt(*tokens, next + 2)).empty();
  const bool left = IsOneOf(word, {"left", "right"}) && WordAt(*tokens, next + 1) == "of";
  if (!above && !heading && !to && !left) return;
  if (above) {
    std::string place;
    const std::size_t end = TakeSideWords(*tokens, next + 1, &place);
    if (end != 0 && IsPauseAt(*tokens, end)) {
      ReplaceTokens(tokens, begin, next + 1 - begin, {"near"});
      return;
    }
  }
  // "the two rows below the lake are houses"
  if (begin > 0 && WordAt(*tokens, begin - 1) == "the") --begin;
  EraseTokens(tokens, begin, next - begin);
}

// "A road from east to west, one third from the top": in the northern third.
void TurnFractionFrom(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view how = WordAt(*tokens, at);
  if (!IsOneOf(how, {"one", "a", "two", "three"})) return;
  const std::string_view part = WordAt(*tokens, at + 1);
  if (!IsOneOf(part, {"third", "thirds", "quarter", "quarters", "fourth", "fourths"})) return;
  std::size_t next = at + 2;
  if (WordAt(*tokens, next) == "of") {
    if (WordAt(*tokens, next + 1) != "the" || WordAt(*tokens, next + 2) != "way") return;
    next += 3;
  }
  if (IsOneOf(WordAt(*tokens, next), {"in", "down", "up", "over"})) ++next;
  if (WordAt(*tokens, next) != "from") return;
  std::string place;
  const std::size_t end = TakeSideWords(*tokens, next + 1, &place);
  if (end == 0 || !(IsPauseAt(*tokens, end) || WordAt(*tokens, end) == "of")) return;
  std::size_t last = end;
  if (WordAt(*tokens, end) == "of") {
    if (WordAt(*tokens, end + 1) != "the" || !IsMapWord(WordAt(*tokens, end + 2))) return;
    last = end + 3;
  }
  if (at == 0 ||
      (!IsPauseAt(*tokens, at - 1) &&
       !IsOneOf(WordAt(*tokens, at - 1), {"runs", "flows", "goes", "lies", "about", "stands",
                                          "road", "river", "roughly", "is"}))) {
    return;
  }
  const std::string side(place.substr(0, place.find("ern ")));
  const bool far = how == "two" || how == "three";
  if (how == "two" && part.substr(0, 5) != "third") return;
  const std::string where = std::string(far ? OppositeOf(side) : side) + "ern";
  std::size_t begin = at;
  if (IsOneOf(WordAt(*tokens, begin - 1), {"about", "roughly"})) --begin;
  ReplaceTokens(tokens, begin, last - begin, {"in", "the", where, "third"});
}

// Land that lies all around a thing, when it is said to lie outside it: not "a lake".
bool IsSurrounding(const std::vector<Token>& tokens, std::size_t at) {
  const ClassWordMatch match = MatchClassWord(tokens, at);
  return match.word != nullptr && match.word->shape == WordShape::kMass;
}

// "outside the town", "inside the ring of the road" at a word for it.
struct Bounds {
  std::size_t thing = 0;  // "the town", "it"
  std::size_t end = 0;    // the token after it; 0: none
  bool ring = false;      // a road or a river around what is inside
  bool it = false;
};
Bounds BoundsAt(const std::vector<Token>& tokens, std::size_t at) {
  Bounds bounds;
  bounds.thing = at + 1 + (WordAt(tokens, at + 1) == "of" ? 1 : 0);
  std::size_t noun = bounds.thing;
  bounds.it = IsOneOf(WordAt(tokens, noun), {"it", "this"});
  if (bounds.it) {
    bounds.end = noun + 1;
    return bounds;
  }
  if (WordAt(tokens, noun++) != "the") return bounds;
  if (IsOneOf(WordAt(tokens, noun), {"ring", "loop", "circle"})) {
    bounds.ring = true;
    ++noun;
    if (WordAt(tokens, noun) == "of" && WordAt(tokens, noun + 1) == "the") noun += 2;
  }
  const ClassWordMatch match = MatchClassWord(tokens, noun);
  if (match.word != nullptr || bounds.ring) bounds.end = noun + match.tokens;
  bounds.ring = bounds.ring || match.is_line();
  return bounds;
}

// "Outside the town there is only farmland", "outside the town: fields": around the town there is
// farmland. "Inside the ring road there are only houses": there are houses, and others elsewhere.
void TurnInOrOutside(std::vector<Token>* tokens, std::size_t at) {
  const bool out = WordAt(*tokens, at) == "outside";
  if (!out && !IsOneOf(WordAt(*tokens, at), {"inside", "within"})) return;
  if (at != SentenceBegin(*tokens, at)) return;
  const Bounds bounds = BoundsAt(*tokens, at);
  if (bounds.end == 0) return;
  std::size_t land = bounds.end;
  if (land < tokens->size() && (*tokens)[land].kind == TokenKind::kComma) ++land;
  const bool colon = land > bounds.end && (*tokens)[bounds.end].text == ":";
  const bool there = WordAt(*tokens, land) == "there";
  if (there) ++land;
  const bool verb = IsOneOf(WordAt(*tokens, land), {"is", "are", "lie", "lies", "should"});
  if (!verb && !colon) return;
  while (IsOneOf(WordAt(*tokens, land), {"is", "are", "lie", "lies", "should", "be"})) ++land;
  std::size_t only = land;
  if (IsOneOf(WordAt(*tokens, only), {"only", "just"})) {
    ++land;
  } else if (WordAt(*tokens, only) == "nothing" && WordAt(*tokens, only + 1) == "but") {
    land += 2;
  }
  if (!NamesThing(*tokens, land)) return;
  const bool around = out && !bounds.ring && !bounds.it && IsSurrounding(*tokens, land);
  EraseTokens(tokens, only, land - only);
  if (around) ReplaceTokens(tokens, at, bounds.thing - at, {"around"});
}

// "Only fields lie outside the town", "there are only fields outside it": fields do.
void TurnLyingOutside(std::vector<Token>* tokens, std::size_t at) {
  const bool out = WordAt(*tokens, at) == "outside";
  if (!out && !IsOneOf(WordAt(*tokens, at), {"inside", "within"})) return;
  const std::size_t begin = SentenceBegin(*tokens, at);
  const Bounds bounds = BoundsAt(*tokens, at);
  if (at == begin || bounds.end == 0 || !IsPauseAt(*tokens, bounds.end)) return;
  std::size_t only = begin;
  while (only < at && IsOneOf(WordAt(*tokens, only), {"there", "is", "are", "and"})) ++only;
  const bool said = IsOneOf(WordAt(*tokens, only), {"only", "just"});
  const std::size_t land = only + (said ? 1 : 0);
  std::size_t verb = land + MatchClassWord(*tokens, land).tokens;
  if (verb == land) return;
  while (IsOneOf(WordAt(*tokens, verb), {"lie", "lies", "is", "are", "stand", "stands"})) ++verb;
  if (verb != at) return;
  if (out && !bounds.ring && !bounds.it && IsSurrounding(*tokens, land))
    ReplaceTokens(tokens, at, bounds.thing - at, {"around"});
  if (said) EraseTokens(tokens, only, 1);
}

// Land that a strip may be of, and no road is made of.
bool IsLand(const std::vector<Token>& tokens, std::size_t at, std::size_t* length) {
  if (IsOneOf(WordAt(tokens, at), {"land", "ground"})) {
    *length = 1;
    return true;
  }
  *length = MatchClassWord(tokens, at).tokens;
  const std::string words = JoinWords(tokens, at, at + *length);
  return IsOneOf(words, {"bare ground", "bare soil", "bare earth", "grass", "meadow", "grassland",
                         "forest", "trees", "bushes", "snow", "bare land", "woodland", "heath"});
}

// "A path of bare ground", "a bridge of grass": a strip of it, no road. "A land bridge": a strip
// of land. "A path of gravel": a path.
void TurnPathOf(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "land" && WordAt(*tokens, at + 1) == "bridge") {
    // "a land bridge of rock"
    const bool of = WordAt(*tokens, at + 2) == "of" && NamesThing(*tokens, at + 3);
    ReplaceTokens(tokens, at, of ? 3 : 2, {"strip", "of"});
    if (!of) InsertTokens(tokens, at + 2, {WordLike("land", (*tokens)[at])});
    return;
  }
  if (!IsOneOf(WordAt(*tokens, at), {"path", "track", "road", "trail", "bridge", "lane"}) ||
      WordAt(*tokens, at + 1) != "of" || at == 0 ||
      !(IsOneOf(WordAt(*tokens, at - 1), {"a", "an", "the", "one"}) ||
        IsSize(WordAt(*tokens, at - 1)))) {
    return;
  }
  // "a path of gravel": how it is paved.
  if (IsOneOf(WordAt(*tokens, at + 2),
              {"gravel", "cobblestones", "cobbles", "asphalt", "planks"})) {
    EraseTokens(tokens, at + 1, 2);
    return;
  }
  std::size_t length = 0;
  if (!IsLand(*tokens, at + 2, &length)) return;
  ReplaceTokens(tokens, at, 1, {"strip"});
}

}  // namespace

void TurnOffsets(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnCellsOff(tokens, at);
    TurnFractionFrom(tokens, at);
    TurnInOrOutside(tokens, at);
    TurnLyingOutside(tokens, at);
    TurnPathOf(tokens, at);
  }
}

}  // namespace latticeworld
