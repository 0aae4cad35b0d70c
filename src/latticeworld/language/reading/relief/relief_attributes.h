#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_ATTRIBUTES_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_ATTRIBUTES_H_

#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/language/reading/relief/relief_sentence.h"
#include "latticeworld/layout/relief_wish.h"

namespace latticeworld {

// Adds what a sentence says of one of its mentions to its wish: number, size, measures, place and
// course. What stands between the things around a mention is said of it. Of two measures that
// differ the later counts, with a warning.
void ReadReliefAttributes(std::size_t mention, ReliefSentence* sentence, ReliefWish* wish,
                          std::vector<std::string>* warnings);

// The side that land is said to rise to in [begin, end): "rises to the north", "falls to the
// south", "slopes down to the east"; {0, 0}: nothing said.
Claim::Heading RiseOf(const ReliefSentence& sentence, std::size_t begin, std::size_t end);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_ATTRIBUTES_H_
