#ifndef LATTICEWORLD_LANGUAGE_CLASS_WORDS_H_
#define LATTICEWORLD_LANGUAGE_CLASS_WORDS_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// How the thing that a word names lies on the land.
enum class WordShape {
  kMass,   // spreads: forest, farmland
  kThing,  // compact and countable: lake, village
  kLine,   // runs: road, river
};

// A noun phrase of an instruction and the class that it names in either vocabulary.
struct ClassWord {
  std::string_view phrase;  // lower case, singular
  char suburb;              // letter; '\0': the suburb vocabulary has nothing like it
  bool suburb_exact;        // false: the letter is only the nearest class
  char wild;
  bool wild_exact;
  WordShape shape;
  int cells;  // usual size of one piece, in cells of the layout; 0 where shape is kLine

  char LetterIn(Vocabulary vocabulary) const {
    return vocabulary == Vocabulary::kSuburb ? suburb : wild;
  }
  bool IsExactIn(Vocabulary vocabulary) const {
    return vocabulary == Vocabulary::kSuburb ? suburb_exact : wild_exact;
  }
};

struct ClassWordMatch {
  const ClassWord* word = nullptr;  // nullptr: the tokens name no class
  std::size_t tokens = 0;           // how many of them the phrase takes
  bool plural = false;

  bool is_line() const { return word != nullptr && word->shape == WordShape::kLine; }
};

// The longest class phrase that starts at tokens[at]; its first or last word may be a plural.
ClassWordMatch MatchClassWord(const std::vector<Token>& tokens, std::size_t at);

// The whole table: data/class_words.txt.
const std::vector<ClassWord>& AllClassWords();
std::string_view ClassWordFile();

// Reads a file like data/class_words.txt, which says its own form. INVALID_ARGUMENT names every
// line that is wrong. The words view `text`, which must outlive them.
Result<std::vector<ClassWord>> ReadClassWords(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CLASS_WORDS_H_
