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

// Sentences that lean on the one before, and asides that say little of the land.
namespace latticeworld {
namespace {

bool IsSurrounded(std::string_view word) {
  return IsOneOf(word, {"surrounded", "encircled", "enclosed", "ringed", "flanked", "bordered",
                        "framed", "reached", "served"});
}

// "A manor. Surrounded by forest, reached by a lane": it is surrounded by forest, it is reached by
// a lane.
void TurnLeaning(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !IsStopAt(*tokens, at - 1) || !IsSurrounded(WordAt(*tokens, at)) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"by", "with"})) {
    return;
  }
  const std::vector<NamedThing> named = NamedBefore(*tokens, at - 1);
  if (named.empty()) return;
  // "Surrounded by forest, a lake lies in the south": the lake is.
  for (std::size_t i = at + 2; !IsStopAt(*tokens, i); ++i) {
    const bool thing = IsMark(*tokens, i) &&
                       IsOneOf(WordAt(*tokens, i + 1), {"a", "an", "the", "one"}) &&
                       NamesThing(*tokens, i + 1);
    const bool stands =
        IsOneOf(WordAt(*tokens, i), {"is", "are", "lies", "lie", "stands", "stand", "sits"}) &&
        WordAt(*tokens, i - 1) != "it";
    if (thing || stands) return;
  }
  const Token beside = (*tokens)[at];
  const std::vector<Token> it_is = {WordLike("it", beside), WordLike("is", beside)};
  for (std::size_t i = at + 2; !IsStopAt(*tokens, i); ++i) {
    std::size_t next = i;
    if (IsMark(*tokens, next)) ++next;
    if (WordAt(*tokens, next) == "and") ++next;
    if (next == i || !IsSurrounded(WordAt(*tokens, next)) || WordAt(*tokens, next + 1) != "by")
      continue;
    EraseTokens(tokens, i, next - i);
    InsertTokens(tokens, i, it_is);
    InsertTokens(tokens, i, {StopLike(beside)});
    break;
  }
  InsertTokens(tokens, at, it_is);
}

// "Hamlets stand along a road. It enters at the left edge": the road does.
void TurnItEnters(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !IsStopAt(*tokens, at - 1) || WordAt(*tokens, at) != "it" ||
      !IsOneOf(WordAt(*tokens, at + 1), {"enters", "leaves", "winds", "flows", "exits"})) {
    return;
  }
  std::string line;
  for (std::size_t i = SentenceBegin(*tokens, at - 1); i + 1 < at; ++i) {
    const ClassWordMatch match = MatchClassWord(*tokens, i);
    if (!match.is_line()) continue;
    if (!line.empty()) return;
    line = JoinWords(*tokens, i, i + match.tokens);
    i += match.tokens - 1;
  }
  if (line.empty()) return;
  ReplaceTokens(tokens, at, 1, {"the", line});
}

// "No houses in the north, which has a lake in the middle": there is a lake.
void TurnWhichHas(std::vector<Token>* tokens, std::size_t at) {
  if (!IsMark(*tokens, at) || WordAt(*tokens, at + 1) != "which" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"has", "holds", "contains"})) {
    return;
  }
  bool denied = false;
  for (std::size_t i = SentenceBegin(*tokens, at); i < at; ++i)
    denied = denied || IsOneOf(WordAt(*tokens, i), {"no", "nothing", "without"});
  if (!denied || IsOneOf(WordAt(*tokens, at + 3), {"no", "none", "neither"})) return;
  ReplaceTokens(tokens, at + 1, 2, {"there", "is"});
  (*tokens)[at] = StopLike((*tokens)[at]);
}

// "As it was in 1900", "about 1300": no number of things.
void TurnYears(std::vector<Token>* tokens, std::size_t at) {
  const Token& token = (*tokens)[at];
  const bool year = token.kind == TokenKind::kNumber && token.text.size() == 4 &&
                    (token.text[0] == '1' || token.text.substr(0, 2) == "20");
  if (!year || !IsPauseAt(*tokens, at + 1) || at == 0) return;
  if (!IsOneOf(WordAt(*tokens, at - 1), {"in", "around", "about", "year", "since", "from"})) return;
  std::size_t begin = at;
  while (begin > 0 &&
         IsOneOf(WordAt(*tokens, begin - 1), {"in", "around", "about", "year", "the", "of", "was",
                                              "it", "as", "since", "looked", "from"})) {
    --begin;
  }
  EraseTokens(tokens, begin, at + 1 - begin);
}

// "We need room to land, so bare earth should make up half": a sentence. "55 percent of the cells":
// of the map. "At the foot of the map": at the bottom.
void TurnMapWords(std::vector<Token>* tokens, std::size_t at) {
  const std::string_view word = WordAt(*tokens, at);
  if (word == "so" && at > 0 && IsMark(*tokens, at - 1) &&
      MatchClassWord(*tokens, at + 1).tokens > 0) {
    (*tokens)[at - 1] = StopLike((*tokens)[at - 1]);
    EraseTokens(tokens, at, 1);
    return;
  }
  if (word == "of" && WordAt(*tokens, at + 1) == "the" && at > 0 &&
      IsOneOf(WordAt(*tokens, at - 1), {"percent", "half", "third", "quarter", "most", "thirds",
                                        "quarters", "fifth", "fifths", "tenth"}) &&
      IsOneOf(WordAt(*tokens, at + 2), {"cells", "squares", "tiles", "pixels"})) {
    (*tokens)[at + 2].text = "map";
    return;
  }
  if (IsOneOf(word, {"foot", "head"}) && WordAt(*tokens, at + 1) == "of" &&
      WordAt(*tokens, at + 2) == "the" && IsMapWord(WordAt(*tokens, at + 3))) {
    (*tokens)[at].text = word == "foot" ? "bottom" : "top";
  }
}

// "And 5 houses and then grass where there is still room": the rest is grass.
void TurnRoom(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"where", "wherever"}) || WordAt(*tokens, at + 1) != "there" ||
      WordAt(*tokens, at + 2) != "is") {
    return;
  }
  std::size_t room = at + 3;
  if (WordAt(*tokens, room) == "still") ++room;
  if (!IsOneOf(WordAt(*tokens, room), {"room", "space"})) return;
  ++room;
  if (WordAt(*tokens, room) == "left") ++room;
  std::size_t noun = at;
  for (std::size_t i = at; i-- > 0 && i + 4 > at;)
    if (i + MatchClassWord(*tokens, i).tokens == at) noun = i;
  if (noun == at || !IsPauseAt(*tokens, room)) return;
  std::size_t begin = noun;
  while (begin > 0 && IsOneOf(WordAt(*tokens, begin - 1), {"and", "then", "just", "also"})) --begin;
  if (begin == noun) return;
  const Token beside = (*tokens)[at];
  EraseTokens(tokens, at, room - at);
  ReplaceTokens(tokens, begin, noun - begin, {"the", "rest", "is"});
  if (begin > 0 && IsMark(*tokens, begin - 1)) {
    (*tokens)[begin - 1] = StopLike(beside);
  } else if (begin > 0 && !IsStopAt(*tokens, begin - 1)) {
    InsertTokens(tokens, begin, {StopLike(beside)});
  }
}

// "They cut the map into four: woods in the north-west, ...": which is said by what lies there.
void TurnIntoFour(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"they", "which", "that", "these"}) ||
      !IsOneOf(WordAt(*tokens, at + 1), {"cut", "divide", "split", "part", "separate"})) {
    return;
  }
  std::size_t next = at + 2;
  while (WordAt(*tokens, next) == "the" || WordAt(*tokens, next) == "whole") ++next;
  if (!IsMapWord(WordAt(*tokens, next)) && WordAt(*tokens, next) != "land") return;
  if (WordAt(*tokens, next + 1) != "into" || WordAt(*tokens, next + 2) != "four") return;
  next += 3;
  while (IsOneOf(WordAt(*tokens, next), {"equal", "parts", "quarters", "sections", "pieces"}))
    ++next;
  if (!IsPauseAt(*tokens, next)) return;
  std::size_t begin = at;
  if (begin > 0 && WordAt(*tokens, begin - 1) == "and") --begin;
  if (begin > 0 && IsMark(*tokens, begin - 1)) --begin;
  if (IsMark(*tokens, next)) (*tokens)[next] = StopLike((*tokens)[next]);
  const bool stopped = begin == 0 || IsStopAt(*tokens, begin - 1);
  if (stopped && next < tokens->size()) ++next;
  EraseTokens(tokens, begin, next - begin);
}

// "Forest on half of the map, in a few large stands": which tells no number of forests. "A bank of
// shingle": some shingle.
void TurnStands(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "a" && WordAt(*tokens, at + 1) == "bank" &&
      WordAt(*tokens, at + 2) == "of") {
    const ClassWordMatch match = MatchClassWord(*tokens, at + 3);
    if (match.word != nullptr && match.word->shape == WordShape::kMass)
      ReplaceTokens(tokens, at, 3, {"some"});
    return;
  }
  if (WordAt(*tokens, at) != "in" || WordAt(*tokens, at + 1) != "a" ||
      WordAt(*tokens, at + 2) != "few") {
    return;
  }
  std::size_t next = at + 3;
  while (IsSize(WordAt(*tokens, next))) ++next;
  if (next == at + 3 ||
      !IsOneOf(WordAt(*tokens, next), {"stands", "blocks", "patches", "pieces", "areas"})) {
    return;
  }
  const std::size_t begin = at - (at > 0 && IsMark(*tokens, at - 1) ? 1 : 0);
  EraseTokens(tokens, begin, next + 1 - begin);
}

// "A snow-covered plain": mostly snow. "Three hamlets hang on a road like beads on a string": they
// stand along it.
void TurnCoveredPlain(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) == "covered" && at > 0 &&
      IsOneOf(WordAt(*tokens, at + 1), {"plain", "land", "landscape", "plateau", "country"}) &&
      MatchClassWord(TokensBetween(*tokens, at - 1, at), 0).tokens == 1) {
    const bool article = at > 1 && IsOneOf(WordAt(*tokens, at - 2), {"a", "the"});
    const std::string land((*tokens)[at - 1].text);
    const std::size_t begin = at - (article ? 2 : 1);
    ReplaceTokens(tokens, begin, at + 2 - begin, {"mostly", land});
    return;
  }
  if (WordAt(*tokens, at) != "like" || !IsOneOf(WordAt(*tokens, at + 1), {"beads", "pearls"})) {
    return;
  }
  std::size_t end = at + 2;
  while (IsOneOf(WordAt(*tokens, end), {"on", "a", "string", "necklace", "thread"})) ++end;
  for (std::size_t i = SentenceBegin(*tokens, at); i + 1 < at; ++i) {
    if (!IsOneOf(WordAt(*tokens, i), {"hang", "sit", "are", "strung", "lie", "threaded"})) continue;
    std::size_t on = i + 1;
    while (IsOneOf(WordAt(*tokens, on), {"strung", "threaded", "out"})) ++on;
    if (WordAt(*tokens, on) != "on" && WordAt(*tokens, on) != "along") continue;
    EraseTokens(tokens, at, end - at);
    ReplaceTokens(tokens, i, on + 1 - i, {"stand", "along"});
    return;
  }
}

// "Huts, none on the shore": not next to the water. "None on the seaward side": said of the other.
// "Each a block of its own": as each of them is.
void TurnNoneThere(std::vector<Token>* tokens, std::size_t at) {
  if (at == 0 || !IsMark(*tokens, at - 1)) return;
  if (WordAt(*tokens, at) == "each" && WordAt(*tokens, at + 1) == "a" &&
      WordAt(*tokens, at + 3) == "of" && WordAt(*tokens, at + 4) == "its" &&
      WordAt(*tokens, at + 5) == "own") {
    EraseTokens(tokens, at - 1, 6 + 1);
    return;
  }
  if (WordAt(*tokens, at) != "none") return;
  std::size_t next = at + 1;
  if (WordAt(*tokens, next) == "of" && WordAt(*tokens, next + 1) == "them") next += 2;
  const bool by = IsOneOf(WordAt(*tokens, next), {"on", "at", "by", "near", "along"});
  if (!by || WordAt(*tokens, next + 1) != "the") return;
  const std::string_view noun = WordAt(*tokens, next + 2);
  if (IsOneOf(noun, {"shore", "shores", "waterline", "waterfront", "coast", "beach", "bank"}) &&
      IsPauseAt(*tokens, next + 3)) {
    ReplaceTokens(tokens, at, next + 3 - at, {"not", "next", "to", "the", "water"});
    return;
  }
  if (IsOneOf(noun, {"seaward", "other", "far", "landward", "opposite"}) &&
      IsOneOf(WordAt(*tokens, next + 3), {"side", "one", "bank"}) && IsPauseAt(*tokens, next + 4)) {
    EraseTokens(tokens, at - 1, next + 4 - at + 1);
  }
}

// "The town is wooded on every side but one: towards the east it opens on meadows": to the east of
// the town there are meadows.
void TurnOpens(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "it" || !IsOneOf(WordAt(*tokens, at + 1), {"opens", "looks"}) ||
      !IsOneOf(WordAt(*tokens, at + 2), {"on", "onto", "to", "out", "over"}) || at < 2) {
    return;
  }
  std::size_t next = at + 3;
  while (IsOneOf(WordAt(*tokens, next), {"on", "onto", "to", "over"})) ++next;
  const std::string_view side = HeadingWord(WordAt(*tokens, at - 1));
  std::size_t to = at - 1;
  if (to > 0 && WordAt(*tokens, to - 1) == "the") --to;
  std::size_t noun = SentenceBegin(*tokens, at);
  while (noun < to && MatchClassWord(*tokens, noun).tokens == 0) ++noun;
  if (side.empty() || to == 0 || !IsOneOf(WordAt(*tokens, to - 1), {"towards", "toward", "to"}) ||
      !NamesThing(*tokens, next)) {
    return;
  }
  const std::string owner =
      noun < to ? JoinWords(*tokens, noun, noun + MatchClassWord(*tokens, noun).tokens) : "it";
  const std::string heading(side);
  if (IsMark(*tokens, to - 2)) (*tokens)[to - 2] = StopLike((*tokens)[to - 2]);
  ReplaceTokens(tokens, to - 1, next - to + 1, {"to", "the", heading, "of", owner, "there", "is"});
}

}  // namespace

void TurnAsides(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnLeaning(tokens, at);
    TurnItEnters(tokens, at);
    TurnWhichHas(tokens, at);
    TurnYears(tokens, at);
    TurnMapWords(tokens, at);
    TurnRoom(tokens, at);
    TurnIntoFour(tokens, at);
    TurnStands(tokens, at);
    TurnCoveredPlain(tokens, at);
    TurnNoneThere(tokens, at);
    TurnOpens(tokens, at);
  }
}

}  // namespace latticeworld
