#ifndef LATTICEWORLD_LANGUAGE_READING_TEXT_UNITS_H_
#define LATTICEWORLD_LANGUAGE_READING_TEXT_UNITS_H_

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/sentences/sentence_tables.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// TextUnit is a word of a text that says something, or a phrase that names one thing ("fire
// engine", "upper left", "a dozen"). Its keys tell what it may mean, so that words of a text can be
// compared with those of the sentences that it was read as: "orc" and "goblin" share a key.
struct TextUnit {
  std::size_t begin = 0;  // bytes of the text: [begin, end)
  std::size_t end = 0;
  std::vector<std::string> keys;
  bool known = false;  // a noun, a place or a number that the program knows
};

// Returns the units of a text, in its order: all words but those that only hold it together.
std::vector<TextUnit> UnitsOf(std::string_view text, SentenceKind kind, Vocabulary vocabulary);

// Returns all keys of the units of sentences.
std::set<std::string> KeysOf(const std::vector<std::string>& sentences, SentenceKind kind,
                             Vocabulary vocabulary);

// Returns whether one of the unit's keys is among `keys`.
bool IsCarried(const TextUnit& unit, const std::set<std::string>& keys);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_TEXT_UNITS_H_
