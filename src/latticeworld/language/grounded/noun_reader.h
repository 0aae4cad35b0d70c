#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_NOUN_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_NOUN_READER_H_

#include <string_view>

#include "latticeworld/language/grounded/quality_reader.h"
#include "latticeworld/language/grounded/reading_state.h"

namespace latticeworld {

// Turns nouns into mentions.
class NounReader {
 public:
  explicit NounReader(ReadingState* state) : state_(*state) {}

  // What a noun stands for. index: -1 where the vocabulary has nothing like it (with a warning).
  struct Found {
    int index = -1;
    bool is_new = false;
    std::size_t begin = 0;  // of the noun and what was said before it
    std::size_t end = 0;
  };
  // points_back: the words ask for something known ("next to the lake"), as "the" does.
  Found Read(const LayoutItem& item, const Modifiers& said, bool points_back);

  // "treeless": a negation that names its class itself.
  void AddAbsent(std::string_view phrase, const LayoutItem& item);

 private:
  int Known(const LayoutItem& item, char letter, const Modifiers& said, bool points_back) const;
  Mention MentionOf(const LayoutItem& item, char letter, const Modifiers& said) const;

  ReadingState& state_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_NOUN_READER_H_
