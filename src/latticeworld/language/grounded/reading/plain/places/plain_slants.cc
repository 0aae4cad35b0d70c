#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/slants.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// What lies on either side of a line that is drawn across the map for the telling only.
namespace latticeworld {
namespace {

bool IsEdgeNoun(std::string_view word) {
  return IsOneOf(word, {"edge", "side", "border", "margin"});
}

// "the lower left corner", "the middle of the east edge", "the left edge"; the token after it, 0:
// no such point.
std::size_t TakePoint(const std::vector<Token>& tokens, std::size_t at, RimPoint* point) {
  if (WordAt(tokens, at) == "the") ++at;
  const bool middle =
      IsOneOf(WordAt(tokens, at), {"middle", "centre", "center", "midpoint", "mid"}) &&
      WordAt(tokens, at + 1) == "of";
  if (middle) {
    at += 2;
    if (WordAt(tokens, at) == "the") ++at;
  }
  PlaceCursor cursor(tokens, at);
  const Direction direction = TakeDirection(&cursor);
  const Heading heading = direction.heading;
  if (!direction.found || (heading.east == 0 && heading.south == 0)) return 0;
  std::size_t end = cursor.at();
  const std::string_view noun = WordAt(tokens, end);
  if (heading.IsDiagonal()) {
    if (middle) return 0;
    if (noun == "corner") ++end;
  } else {
    if (!middle && !IsEdgeNoun(noun)) return 0;
    if (IsEdgeNoun(noun)) ++end;
  }
  *point = {heading.east + 1, heading.south + 1};
  return end;
}

struct DrawnLine {
  RimPoint from;
  RimPoint to;
  std::size_t end = 0;  // 0: none
};

// "a line from A to B", "the diagonal from A to B", "a line between A and B".
DrawnLine TakeLine(const std::vector<Token>& tokens, std::size_t at) {
  DrawnLine line;
  if (IsOneOf(WordAt(tokens, at), {"a", "the", "an"})) ++at;
  while (IsOneOf(WordAt(tokens, at), {"straight", "imaginary", "oblique", "slanting", "dividing",
                                      "diagonal", "main"}) &&
         IsOneOf(WordAt(tokens, at + 1), {"line", "diagonal", "straight", "dividing"})) {
    ++at;
  }
  if (!IsOneOf(WordAt(tokens, at), {"line", "diagonal"})) return line;
  ++at;
  while (IsOneOf(WordAt(tokens, at), {"running", "drawn", "that", "which", "runs", "going", "goes",
                                      "leading", "joining"})) {
    ++at;
  }
  const bool between = WordAt(tokens, at) == "between";
  if (between || WordAt(tokens, at) == "from") ++at;
  const std::size_t to = TakePoint(tokens, at, &line.from);
  if (to == 0 || !IsOneOf(WordAt(tokens, to), {"to", "and"})) return line;
  const std::size_t end = TakePoint(tokens, to + 1, &line.to);
  const bool same = line.from.east == line.to.east && line.from.south == line.to.south;
  if (end > 0 && !same) line.end = end;
  return line;
}

// "below", "north-east of", "to the left of"; the token after it, 0: none.
std::size_t TakeSide(const std::vector<Token>& tokens, std::size_t at, Heading* heading) {
  const std::string_view word = WordAt(tokens, at);
  if (IsOneOf(word, {"above", "over"})) {
    *heading = {0, -1};
    return at + 1;
  }
  if (IsOneOf(word, {"below", "beneath", "under", "underneath"})) {
    *heading = {0, 1};
    return at + 1;
  }
  if (IsOneOf(word, {"to", "on"})) ++at;
  if (WordAt(tokens, at) == "the") ++at;
  PlaceCursor cursor(tokens, at);
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found) return 0;
  std::size_t end = cursor.at();
  if (IsEdgeNoun(WordAt(tokens, end))) ++end;
  if (WordAt(tokens, end) != "of") return 0;
  *heading = direction.heading;
  return end + 1;
}

// Puts the side of the line in the place of tokens [first, last): a place of its own before a verb
// or a thing, "in ..." behind one. The number of tokens put in.
std::size_t PutSide(std::vector<Token>* tokens, std::size_t first, std::size_t last,
                    const Slant& slant) {
  // "everything below ...", "the land above ..."
  std::size_t begin = first;
  while (begin > 0 &&
         IsOneOf(WordAt(*tokens, begin - 1),
                 {"everything", "all", "land", "that", "which", "lies", "is", "whatever", "what",
                  "area", "part", "the", "ground", "anything", "in", "of", "it"})) {
    --begin;
  }
  const bool fronts = begin == 0 || IsPauseAt(*tokens, begin - 1) ||
                      IsOneOf(WordAt(*tokens, begin - 1), {"and", "with", "while", "but"});
  std::vector<std::string_view> words;
  const std::string name = WordOf(slant);
  if (!fronts) {
    begin = first;
    words = {"in", "the", name};
  } else {
    words = {"the", name};
    if (last < tokens->size() && (*tokens)[last].text == ",") ++last;
    if (WordAt(*tokens, last) == "it") ++last;
    if (!IsOneOf(WordAt(*tokens, last), {"is", "are", "should", "must", "belongs", "shall", "will",
                                         "lies", "holds", "becomes"})) {
      words.push_back("is");
    }
  }
  ReplaceTokens(tokens, begin, last - begin, words);
  return begin + words.size();
}

// "above it", "south-west of that line"; the token after it, 0: none.
std::size_t TakeSideOfIt(const std::vector<Token>& tokens, std::size_t at, Heading* heading) {
  const std::size_t side = TakeSide(tokens, at, heading);
  if (side == 0) return 0;
  if (WordAt(tokens, side) == "it") return side + 1;
  if (IsOneOf(WordAt(tokens, side), {"the", "this", "that"}) &&
      IsOneOf(WordAt(tokens, side + 1), {"line", "diagonal"})) {
    return side + 2;
  }
  return 0;
}

// What is said of the sides of the line in the same sentence and in the next one.
void PutOtherSides(std::vector<Token>* tokens, std::size_t from, const DrawnLine& line) {
  int stops = 0;
  for (std::size_t at = from; at < tokens->size() && stops < 2; ++at) {
    if ((*tokens)[at].kind == TokenKind::kStop) ++stops;
    Heading heading;
    const std::size_t end = TakeSideOfIt(*tokens, at, &heading);
    if (end == 0) continue;
    const std::optional<Slant> slant = SlantToward(line.from, line.to, heading);
    if (!slant.has_value()) continue;
    at = PutSide(tokens, at, end, *slant) - 1;
  }
}

// "a line from A to B divides the map: forest above it, fields below it"
bool TurnDivide(std::vector<Token>* tokens, std::size_t at) {
  const DrawnLine line = TakeLine(*tokens, at);
  if (line.end == 0) return false;
  if (!IsOneOf(WordAt(*tokens, line.end),
               {"divides", "splits", "cuts", "parts", "separates", "halves", "bisects"})) {
    return false;
  }
  std::size_t end = line.end + 1;
  while (!IsPauseAt(*tokens, end)) {
    if (MatchClassWord(*tokens, end).word != nullptr) return false;
    ++end;
  }
  if (end < tokens->size()) ++end;
  EraseTokens(tokens, at, end - at);
  PutOtherSides(tokens, at, line);
  return true;
}

// "cut along the diagonal: the north-east belongs to the snow, the south-west to the rock"
bool TurnCut(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"cut", "split", "divided", "halved", "parted"})) return false;
  std::size_t end = at + 1;
  while (IsOneOf(WordAt(*tokens, end), {"in", "into", "two", "half", "halves", "along", "by", "on",
                                        "across", "the", "a", "its", "main"})) {
    ++end;
  }
  if (!IsOneOf(WordAt(*tokens, end), {"diagonal", "diagonally"})) return false;
  ++end;
  std::vector<Heading> told;
  for (std::size_t i = end; i < end + 30 && i < tokens->size(); ++i) {
    PlaceCursor cursor(*tokens, i);
    const Direction side = TakeDirection(&cursor);
    if (!side.found || !side.heading.IsDiagonal()) continue;
    told.push_back(side.heading);
    i = cursor.at();
  }
  if (told.size() < 2 || told[0].east != -told[1].east || told[0].south != -told[1].south) {
    return false;
  }
  // The diagonal between the two corners that are not named.
  const RimPoint from{1 + told[0].south, 1 - told[0].east};
  const RimPoint to{1 - told[0].south, 1 + told[0].east};
  int found = 0;
  for (std::size_t i = end; i < tokens->size() && found < 2; ++i) {
    PlaceCursor cursor(*tokens, i);
    const Direction side = TakeDirection(&cursor);
    if (!side.found || !side.heading.IsDiagonal()) continue;
    const std::optional<Slant> slant = SlantToward(from, to, side.heading);
    if (!slant.has_value()) return false;
    std::size_t last = cursor.at();
    if (IsOneOf(WordAt(*tokens, last), {"half", "part", "side", "triangle", "corner"})) ++last;
    const bool belongs = IsOneOf(WordAt(*tokens, last), {"belongs", "goes", "to"});
    if (belongs) {
      while (IsOneOf(WordAt(*tokens, last), {"belongs", "goes", "to"})) ++last;
      ReplaceTokens(tokens, i, last - i, {WordOf(*slant), "is"});
    } else {
      ReplaceTokens(tokens, i, last - i, {WordOf(*slant)});
    }
    ++found;
  }
  EraseTokens(tokens, at, end - at);
  return true;
}

}  // namespace

void TurnSlants(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (TurnDivide(tokens, at) || TurnCut(tokens, at)) return;
    Heading heading;
    const std::size_t side = TakeSide(*tokens, at, &heading);
    if (side == 0) continue;
    const DrawnLine line = TakeLine(*tokens, side);
    if (line.end == 0) continue;
    const std::optional<Slant> slant = SlantToward(line.from, line.to, heading);
    if (!slant.has_value()) continue;
    PutOtherSides(tokens, PutSide(tokens, at, line.end, *slant), line);
    return;
  }
}

}  // namespace latticeworld
