#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

std::vector<std::string_view> WordsOf(Heading heading) {
  std::vector<std::string_view> words;
  if (heading.south != 0) words.push_back(heading.south < 0 ? "upper" : "lower");
  if (heading.east != 0) words.push_back(heading.east < 0 ? "left" : "right");
  return words;
}

// Corners or sides that an instruction gives away one after the other.
struct TakenPlaces {
  std::string noun;
  std::vector<Heading> taken;

  void Take(Heading heading, std::string_view of) {
    if (noun != of || (!taken.empty() && taken.front().IsDiagonal() != heading.IsDiagonal())) {
      noun = of;
      taken.clear();
    }
    const bool known = std::any_of(taken.begin(), taken.end(), [&](Heading other) {
      return other.east == heading.east && other.south == heading.south;
    });
    if (!known) taken.push_back(heading);
  }
  std::vector<Heading> Left() const {
    std::vector<Heading> left;
    if (taken.empty()) return left;
    const bool diagonal = taken.front().IsDiagonal();
    for (const int south : {-1, 0, 1}) {
      for (const int east : {-1, 0, 1}) {
        const Heading heading{east, south};
        if (heading.IsDiagonal() != diagonal || (east == 0 && south == 0)) continue;
        const bool known = std::any_of(taken.begin(), taken.end(), [&](Heading other) {
          return other.east == east && other.south == south;
        });
        if (!known) left.push_back(heading);
      }
    }
    return left;
  }
};

// How many places "the other two", "the remaining three quadrants" speak of, and the words that it
// takes; 0: of none.
int OthersAt(const std::vector<Token>& tokens, std::size_t at, const TakenPlaces& places,
             std::size_t* end) {
  std::size_t next = at;
  if (WordAt(tokens, next) == "the") ++next;
  if (!IsOneOf(WordAt(tokens, next), {"other", "remaining", "last"})) return 0;
  ++next;
  int count = 0;
  if (WordAt(tokens, next) == "one") count = 1;
  if (WordAt(tokens, next) == "two") count = 2;
  if (WordAt(tokens, next) == "three") count = 3;
  if (count > 0) ++next;
  const std::string_view noun = NounOfPlace(WordAt(tokens, next));
  if (!noun.empty()) {
    if (noun != places.noun) return 0;
    if (count == 0)
      count = WordAt(tokens, next) == noun ? 1 : static_cast<int>(places.Left().size());
    ++next;
  } else if (count == 0 || MatchClassWord(tokens, next).word != nullptr) {
    return 0;
  }
  *end = next;
  return count;
}

// What follows is spoken of anew: "..., the other two are grass".
void BeginSentence(std::vector<Token>* words) {
  while (!words->empty() &&
         IsOneOf(WordAt(*words, words->size() - 1), {"the", "and", "but", "while", "with"})) {
    words->pop_back();
  }
  if (words->empty() || words->back().kind == TokenKind::kStop) return;
  if (words->back().kind == TokenKind::kComma) words->pop_back();
  if (!words->empty())
    words->push_back({TokenKind::kStop, ".", words->back().end, words->back().end});
}

}  // namespace

// "fields in the NW and SE quadrant, forest in the other two"
std::vector<Token> WithOtherPlaces(std::vector<Token> tokens) {
  std::vector<Token> whole;
  TakenPlaces places;
  for (std::size_t at = 0; at < tokens.size();) {
    // The list of directions before one noun: the noun goes with each.
    PlaceCursor cursor(tokens, at);
    const Direction direction = TakeDirection(&cursor);
    const std::size_t after = cursor.at();
    if (direction.found && (direction.heading.east != 0 || direction.heading.south != 0)) {
      std::string_view noun = NounOfPlace(WordAt(tokens, after));
      bool put_in = false;
      const bool diagonal = direction.heading.IsDiagonal();
      if (noun.empty()) {
        std::size_t next = after;
        for (int items = 0; items < 3 && noun.empty(); ++items) {
          if (next < tokens.size() && tokens[next].kind == TokenKind::kComma) ++next;
          if (IsOneOf(WordAt(tokens, next), {"and", "or"})) ++next;
          if (WordAt(tokens, next) == "the") ++next;
          PlaceCursor more(tokens, next);
          const Direction second = TakeDirection(&more);
          if (!second.found || second.heading.IsDiagonal() != diagonal || next == after) break;
          next = more.at();
          noun = NounOfPlace(WordAt(tokens, next));
          // "the west, north and east edges", of the map
          const bool edges =
              IsOneOf(WordAt(tokens, next), {"edges", "borders", "edge", "border"}) &&
              (WordAt(tokens, next + 1) != "of" ||
               MatchClassWord(tokens, next + 3).word == nullptr);
          if (!diagonal && !edges) noun = {};
        }
        put_in = !noun.empty();
      }
      for (; at < after; ++at) whole.push_back(tokens[at]);
      if (put_in) whole.push_back(WordLike(noun, whole.back()));
      if (!noun.empty()) places.Take(direction.heading, noun);
      continue;
    }
    std::size_t end = at;
    const int count = OthersAt(tokens, at, places, &end);
    const std::vector<Heading> left = places.Left();
    if (count > 0 && static_cast<std::size_t>(count) == left.size()) {
      const Token beside = tokens[at];
      if (IsOneOf(WordAt(tokens, end), {"is", "are", "should", "must", "shall", "stay", "stays"}))
        BeginSentence(&whole);
      for (std::size_t i = 0; i < left.size(); ++i) {
        if (i > 0) whole.push_back(WordLike("and", beside));
        whole.push_back(WordLike("the", beside));
        for (const std::string_view word : WordsOf(left[i]))
          whole.push_back(WordLike(word, beside));
        whole.push_back(WordLike(places.noun, beside));
      }
      places = TakenPlaces();
      at = end;
      continue;
    }
    whole.push_back(tokens[at++]);
  }
  return whole;
}

}  // namespace latticeworld
