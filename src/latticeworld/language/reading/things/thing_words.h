#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_THING_WORDS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_THING_WORDS_H_

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/places.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// ThingWords goes through the words of a text in which single things are looked for. What begins
// with Take reads what it is named for at the place where the reader stands, and goes behind it; or
// it stays, and returns false or nothing.
class ThingWords {
 public:
  // A word of an arrangement: "a row of", "in a ring".
  struct Arrangement {
    std::string_view word;
    ThingArrangement arrangement;
    int usual;  // things, where no number is said
  };

  // text: outlives this.
  ThingWords(std::string_view text, Vocabulary vocabulary);

  const std::vector<Token>& tokens() const { return tokens_; }
  Vocabulary vocabulary() const { return vocabulary_; }
  std::size_t at() const { return at_; }
  void GoTo(std::size_t at) { at_ = at; }
  bool IsComma(std::size_t at) const;
  // "" where no word stands.
  std::string_view WordAt(std::size_t at) const;
  std::string_view Word() const { return WordAt(at_); }
  // The text from a token to before another.
  std::string Text(std::size_t begin, std::size_t end) const;

  void TakeComma();
  bool TakeWords(std::initializer_list<std::string_view> words);  // all, one after the other
  bool TakeAny(std::initializer_list<std::string_view> words);    // one of them
  void TakeCopula();                                              // "that stands": says nothing
  std::optional<int> TakeNumber();                                // in digits or words
  bool TakeMetres();
  // "every 20 m", "20 metres apart", "at intervals of 20 m": a distance in metres; 0: none.
  double TakeSpacing();

  // The longest noun of a kind; nullptr: none. A house in a suburb is land. plural: whether it is.
  const ThingKind* TakeKind(bool* plural);
  // Houses as well, and buildings that are no kind but come near one.
  const ThingKind* TakeBuilding(bool* plural);
  // Whether a noun may end here.
  bool IsEndOfNoun() const;
  // Whether the noun that begins here is land too. Piers, tents and ruins, which no class but
  // buildings comes near, are not.
  bool IsLand() const;
  const Arrangement* TakeArrangement();  // nullptr: none

  // "north of", "just to the north of": on which side of something.
  ThingSide TakeSide();
  // The place that begins there; what is said behind "facing" is not of it.
  PlaceMatch PlaceAt(std::size_t at) const;
  // "in the north" says where on the map, "in the north of the forest" where in the forest.
  bool IsPlace() const;
  // "the middle of" the forest: the forest.
  void TakePlaceOf();
  // The class of land, or the ground, that is named behind at most three words.
  ThingTarget TakeLand();

 private:
  template <typename Find>
  const ThingKind* TakeNoun(const Find& find, bool* plural);

  const std::string_view text_;
  const Vocabulary vocabulary_;
  const std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_THING_WORDS_H_
