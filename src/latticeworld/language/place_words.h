#ifndef LATTICEWORLD_LANGUAGE_PLACE_WORDS_H_
#define LATTICEWORLD_LANGUAGE_PLACE_WORDS_H_

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "latticeworld/language/places.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Reads the words of a place one after the other; its reach ends at punctuation.
class PlaceCursor {
 public:
  PlaceCursor(const std::vector<Token>& tokens, std::size_t at) : tokens_(tokens), at_(at) {}

  // "" at the end and at punctuation; numbers are no words.
  std::string_view word(std::size_t ahead = 0) const;
  // The word before the next one; "" at the beginning and after punctuation.
  std::string_view previous() const;
  bool Take(std::initializer_list<std::string_view> words);
  void Skip(std::size_t count) { at_ += count; }
  std::size_t at() const { return at_; }
  void set_at(std::size_t at) { at_ = at; }
  const std::vector<Token>& tokens() const { return tokens_; }

 private:
  const std::vector<Token>& tokens_;
  std::size_t at_;
};

bool IsOneOf(std::string_view word, std::initializer_list<std::string_view> words);

// What the words for a direction say together.
struct Direction {
  Heading heading;
  bool center = false;   // a word for the middle was among them
  bool extreme = false;  // "far north", "northernmost"
  // "north-north-west": the heading is that of north-west, closer to this one.
  bool between = false;
  Heading nearer = {};
  bool found = false;
};

// "upper left", "left top", "middle right", "far north", "NNW", "center": at most one word an axis.
// Nothing is found at "right now", "left over" and before an opposite ("north-south").
Direction TakeDirection(PlaceCursor* cursor);
bool IsCenterWord(std::string_view word);

// "of the map", "in the whole picture": true when it was there.
bool TakeWholeMap(PlaceCursor* cursor);
// "map", "scene", "picture", ...
bool IsMapWord(std::string_view word);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_PLACE_WORDS_H_
