#include "latticeworld/language/grounded/reading/side_words.h"

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {

bool IsFlank(std::string_view word) {
  return IsOneOf(word, {"side", "bank", "shore", "flank", "hand", "part", "half", "section"});
}

bool IsMark(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kComma;
}

std::string_view HeadingWord(std::string_view word) {
  for (const std::string_view heading : {"north", "south", "east", "west"}) {
    if (word.substr(0, heading.size()) != heading) continue;
    if (IsOneOf(word.substr(heading.size()), {"", "ward", "wards", "ern"})) return heading;
  }
  return "";
}

std::string_view SideWord(std::string_view word) {
  if (IsOneOf(word, {"top", "upper"})) return "north";
  if (IsOneOf(word, {"bottom", "lower"})) return "south";
  if (word == "left") return "west";
  if (word == "right") return "east";
  return HeadingWord(word);
}

std::string_view OppositeOf(std::string_view heading) {
  if (heading == "north") return "south";
  if (heading == "south") return "north";
  if (heading == "east") return "west";
  return heading == "west" ? "east" : "";
}

std::string_view NameOf(Heading heading) {
  if (heading.south != 0 && heading.east != 0) {
    if (heading.south < 0) return heading.east < 0 ? "northwest" : "northeast";
    return heading.east < 0 ? "southwest" : "southeast";
  }
  if (heading.south != 0) return heading.south < 0 ? "north" : "south";
  return heading.east < 0 ? "west" : "east";
}

std::size_t TakeHeading(const std::vector<Token>& tokens, std::size_t at, Heading* heading) {
  if (IsOneOf(WordAt(tokens, at), {"the", "a", "an", "its"})) ++at;
  PlaceCursor cursor(tokens, at);
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found || (direction.heading.east == 0 && direction.heading.south == 0)) return 0;
  *heading = direction.heading;
  return cursor.at();
}

std::size_t TakeSideWords(const std::vector<Token>& tokens, std::size_t at, std::string* place) {
  if (WordAt(tokens, at) == "the") ++at;
  const std::string_view side = SideWord(WordAt(tokens, at));
  if (side.empty() || !SideWord(WordAt(tokens, at + 1)).empty()) return 0;
  *place = std::string(side);
  ++at;
  if (IsOneOf(WordAt(tokens, at), {"edge", "border", "side", "margin"})) {
    *place += "ern edge";
    ++at;
  }
  return at;
}

std::string_view NounOfPlace(std::string_view word) {
  for (const auto& [plural, noun] :
       {std::pair<std::string_view, std::string_view>{"corners", "corner"},
        {"quadrants", "quadrant"},
        {"quarters", "quarter"},
        {"sides", "side"},
        {"edges", "edge"},
        {"borders", "border"}}) {
    if (word == plural || word == noun) return noun;
  }
  return {};
}

}  // namespace latticeworld
