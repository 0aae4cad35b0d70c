#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_LAND_BY_THINGS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_LAND_BY_THINGS_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// A sentence and the bytes of a text that it is, [begin, end).
struct SaidSentence {
  Sentence sentence;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Land that a sentence about a single thing names, "between 2 villages", and that sentence's bytes.
struct LandByThing {
  Phrase land;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Returns the land by things that sentences about land leave unsaid: of each class, the first that
// is said singly, else the first. A class that is said singly is left unsaid where no sentence
// about land says it singly, another where none names it.
std::vector<LandByThing> LandLeftUnsaid(const std::vector<LandByThing>& by_things,
                                        const std::vector<SaidSentence>& about_land,
                                        Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_LAND_BY_THINGS_H_
