#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_THINGS_OF_TEXT_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_THINGS_OF_TEXT_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// TextThings holds the single things of free text, and the text without them.
struct TextThings {
  std::vector<ThingWish> things;
  std::string rest;   // what is left for readers of land; the text itself where there are no things
  std::string taken;  // the words that were taken out
  std::vector<std::string> warnings;  // of kinds that only come near a noun, of land that is none
  // Whether they are all single things of the text, with all that is said of them.
  bool whole = true;
};

// Takes the noun phrases of single things out of a text, with how and where the things stand:
// "three trees in a row beside", "a well in front of a church", "a row of six lamps along". The
// land that they stand by stays in the text. Nouns that are land too (data/class_words.txt) count
// where an arrangement or, for trees, bushes and boulders, a number says that single ones are
// meant, buildings that are no kind only where they are counted and arranged.
TextThings TakeThings(std::string_view text, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_THINGS_OF_TEXT_H_
