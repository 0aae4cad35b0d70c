#include <algorithm>
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

// "three of the four corners", "of the four corners three", "three corners": tokens [first, last);
// the noun of one of them, "" where nothing of the kind starts here.
struct Three {
  std::size_t first = 0;
  std::size_t last = 0;
  std::string noun;
  bool diagonal = false;
};

Three ThreeAt(const std::vector<Token>& tokens, std::size_t at) {
  Three three;
  three.first = at;
  std::size_t next = at;
  // "three", "three of", or "of ... three"
  const bool of_first = WordAt(tokens, next) == "of";
  if (of_first) {
    ++next;
  } else if (WordAt(tokens, next) == "three") {
    ++next;
    if (WordAt(tokens, next) == "of") ++next;
  } else {
    return three;
  }
  const bool bare = next == at + 1 && !of_first;  // "three corners"
  // The noun must be of the map: its corners, quadrants or edges.
  if (WordAt(tokens, next) == "the") ++next;
  if (IsOneOf(WordAt(tokens, next), {"four", "map"})) ++next;
  const std::string_view noun = WordAt(tokens, next);
  if (noun == "corners") {
    three.noun = "corner";
  } else if (noun == "quadrants" || (noun == "quarters" && !bare)) {
    three.noun = "quadrant";
  } else if (IsOneOf(noun, {"edges", "borders", "margins"}) || (noun == "sides" && !bare)) {
    three.noun = "edge";
  } else {
    return three;
  }
  three.diagonal = three.noun != "edge";
  ++next;
  // "of the map" may follow; corners of anything else are none.
  bool of_map = false;
  if (WordAt(tokens, next) == "of") {
    std::size_t map = next + 1;
    if (WordAt(tokens, map) == "the") ++map;
    of_map = IsMapWord(WordAt(tokens, map));
    if (!of_map) {
      three.noun.clear();  // "three corners of the lake"
      return three;
    }
    next = map + 1;
  }
  if (of_first) {
    if (next < tokens.size() && tokens[next].kind == TokenKind::kComma) ++next;
    if (WordAt(tokens, next) != "three") {
      three.noun.clear();
      return three;
    }
    ++next;
  }
  three.last = next;
  return three;
}

// "the fourth, in the south-east,": tokens [first, last) and where it is.
struct Fourth {
  bool found = false;
  std::size_t first = 0;
  std::size_t last = 0;
  Heading at;
};

Fourth FourthAfter(const std::vector<Token>& tokens, std::size_t from, const Three& three) {
  constexpr std::size_t kReach = 28;
  Fourth fourth;
  for (std::size_t at = from; at < from + kReach && at < tokens.size(); ++at) {
    if (WordAt(tokens, at) != "the" ||
        !IsOneOf(WordAt(tokens, at + 1), {"fourth", "last", "other", "remaining"})) {
      continue;
    }
    std::size_t next = at + 2;
    if (IsOneOf(WordAt(tokens, next), {"one", "corner", "quarter", "quadrant", "edge", "side"})) {
      ++next;
    }
    if (MatchClassWord(tokens, next).word != nullptr) continue;  // "the other wood"
    fourth.found = true;
    fourth.first = at;
    fourth.last = next;
    fourth.at = three.diagonal ? Heading{1, 1} : Heading{0, 1};
    std::size_t place = next;
    const bool comma = place < tokens.size() && tokens[place].kind == TokenKind::kComma;
    if (comma) ++place;
    if (IsOneOf(WordAt(tokens, place), {"in", "at", "namely"})) ++place;
    if (WordAt(tokens, place) == "the") ++place;
    PlaceCursor cursor(tokens, place);
    const Direction taken = TakeDirection(&cursor);
    const bool fits = taken.found && taken.heading.IsDiagonal() == three.diagonal &&
                      (taken.heading.east != 0 || taken.heading.south != 0);
    if (!fits) return fourth;
    std::size_t end = cursor.at();
    if (IsOneOf(WordAt(tokens, end), {"one", "quarter", "quadrant", "corner", "edge", "side"})) {
      ++end;
    }
    const bool closes = comma && end < tokens.size() && tokens[end].kind == TokenKind::kComma;
    fourth.at = taken.heading;
    fourth.last = end + (closes ? 1 : 0);
    return fourth;
  }
  return fourth;
}

void AppendName(Heading heading, std::string_view noun, std::vector<std::string_view>* words) {
  words->push_back("the");
  if (heading.south != 0) words->push_back(heading.south < 0 ? "upper" : "lower");
  if (heading.east != 0) words->push_back(heading.east < 0 ? "left" : "right");
  words->push_back(noun);
}

// "Trees top left and bottom right, a wall from the other corner to the other corner": between the
// two that are left.
void TurnOtherCorners(std::vector<Token>* tokens) {
  std::vector<Heading> taken;
  for (std::size_t at = 0; at + 5 < tokens->size(); ++at) {
    // Corners that are named are collected.
    PlaceCursor cursor(*tokens, at);
    const Direction direction = TakeDirection(&cursor);
    if (direction.found && direction.heading.IsDiagonal() && WordAt(*tokens, cursor.at()) != "of") {
      const bool known = std::any_of(taken.begin(), taken.end(), [&](Heading other) {
        return other.east == direction.heading.east && other.south == direction.heading.south;
      });
      if (!known) taken.push_back(direction.heading);
      at = cursor.at() - 1;
      continue;
    }
    // After two of them: "from the other corner to the other", "between the other two corners".
    if (taken.size() != 2 || !IsOneOf(WordAt(*tokens, at), {"from", "between"})) continue;
    std::size_t next = at + 1;
    if (WordAt(*tokens, next) == "one" && WordAt(*tokens, next + 1) == "of") next += 2;
    if (WordAt(*tokens, next) == "the") ++next;
    const bool two = WordAt(*tokens, next) == "other" && WordAt(*tokens, next + 1) == "two";
    if (!IsOneOf(WordAt(*tokens, next), {"other", "one", "remaining"})) continue;
    next += two ? 2 : 1;
    if (!IsOneOf(WordAt(*tokens, next), {"corner", "corners"})) continue;
    ++next;
    if (IsOneOf(WordAt(*tokens, next), {"to", "and"}) && WordAt(*tokens, next + 1) == "the" &&
        WordAt(*tokens, next + 2) == "other") {
      next += 3;
      if (IsOneOf(WordAt(*tokens, next), {"corner", "one"})) ++next;
    } else if (!two) {
      continue;
    }
    // The two that are left take their place.
    std::vector<std::string_view> words = {"from"};
    for (const int south : {-1, 1}) {
      for (const int east : {-1, 1}) {
        const bool known = std::any_of(taken.begin(), taken.end(), [&](Heading other) {
          return other.east == east && other.south == south;
        });
        if (known) continue;
        if (words.size() > 1) words.push_back("to");
        AppendName({east, south}, "corner", &words);
      }
    }
    ReplaceTokens(tokens, at, next - at, words);
    at += words.size() - 1;
  }
}

// "a wood in each corner except the north-eastern, which is a pond": in the other three; in the
// north-eastern corner there is a pond.
void TurnAllButOne(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    // "each corner", "all four edges" ...
    std::size_t next = at;
    if (IsOneOf(WordAt(*tokens, next), {"each", "every"})) {
      ++next;
    } else if (WordAt(*tokens, next) == "all") {
      ++next;
      while (IsOneOf(WordAt(*tokens, next), {"the", "four", "of"})) ++next;
    } else {
      continue;
    }
    const std::string plural(WordAt(*tokens, next));
    if (!IsOneOf(plural, {"corner", "corners", "quadrant", "quadrants", "edge", "edges"})) continue;
    const std::string noun = plural.back() == 's' ? plural.substr(0, plural.size() - 1) : plural;
    const bool diagonal = noun != "edge";
    ++next;
    if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
    // ... except one, which a direction names.
    if (!IsOneOf(WordAt(*tokens, next), {"except", "but", "save"})) continue;
    ++next;
    while (IsOneOf(WordAt(*tokens, next), {"for", "in", "at", "the", "not"})) ++next;
    PlaceCursor cursor(*tokens, next);
    const Direction out = TakeDirection(&cursor);
    const bool fits = out.found && out.heading.IsDiagonal() == diagonal &&
                      (out.heading.east != 0 || out.heading.south != 0);
    if (!fits) continue;
    std::size_t end = cursor.at();
    if (IsOneOf(WordAt(*tokens, end), {"one", noun})) ++end;
    // The others are listed in its place.
    std::vector<std::string_view> words;
    for (int south = -1; south <= 1; ++south) {
      for (int east = -1; east <= 1; ++east) {
        const Heading heading{east, south};
        const bool same = east == out.heading.east && south == out.heading.south;
        const bool center = east == 0 && south == 0;
        if (same || center || heading.IsDiagonal() != diagonal) continue;
        if (!words.empty()) words.push_back("and");
        AppendName(heading, noun, &words);
      }
    }
    // What is said of the excepted one becomes a sentence about its place.
    std::size_t which = end;
    if (which < tokens->size() && (*tokens)[which].kind == TokenKind::kComma) ++which;
    if (IsOneOf(WordAt(*tokens, which), {"which", "where"})) {
      ++which;
      while (IsOneOf(WordAt(*tokens, which), {"is", "has", "holds", "there", "contains"})) ++which;
      std::vector<std::string_view> there = {"x", "in"};
      AppendName(out.heading, noun, &there);
      there.insert(there.end(), {"there", "is"});
      ReplaceTokens(tokens, end, which - end, there);
      (*tokens)[end] = {TokenKind::kStop, ".", (*tokens)[end].begin, (*tokens)[end].begin};
    }
    ReplaceTokens(tokens, at, end - at, words);
    at += words.size() - 1;
  }
}

}  // namespace

// If nobody says which of them the fourth is, it is the south-eastern one, or the southern edge.
void TurnCorners(std::vector<Token>* tokens) {
  TurnOtherCorners(tokens);
  TurnAllButOne(tokens);
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const Three three = ThreeAt(*tokens, at);
    if (three.noun.empty()) continue;
    const Fourth fourth = FourthAfter(*tokens, three.last, three);
    if (!fourth.found) continue;
    std::vector<std::string_view> last;
    AppendName(fourth.at, three.noun, &last);
    std::vector<std::string_view> others;
    for (int south = -1; south <= 1; ++south) {
      for (int east = -1; east <= 1; ++east) {
        const Heading heading{east, south};
        const bool is_center = east == 0 && south == 0;
        const bool is_fourth = east == fourth.at.east && south == fourth.at.south;
        if (is_center || is_fourth || heading.IsDiagonal() != three.diagonal) continue;
        if (!others.empty()) others.push_back("and");
        AppendName(heading, three.noun, &others);
      }
    }
    ReplaceTokens(tokens, fourth.first, fourth.last - fourth.first, last);
    ReplaceTokens(tokens, three.first, three.last - three.first, others);
    at += others.size();
  }
}

}  // namespace latticeworld
