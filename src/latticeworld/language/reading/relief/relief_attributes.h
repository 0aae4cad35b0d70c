#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_ATTRIBUTES_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_ATTRIBUTES_H_

#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/language/reading/relief/relief_sentence.h"
#include "latticeworld/layout/relief_wish.h"

namespace latticeworld {

// Adds what a sentence says of one of its mentions to that mention's wish: number, size, measures,
// place and course. The words between the things around a mention are taken to be said of it. Where
// two measures differ the later counts, and a warning says so.
void ReadReliefAttributes(std::size_t mention, ReliefSentence* sentence, ReliefWish* wish,
                          std::vector<std::string>* warnings);

// Returns the side to which the words [begin, end) say that land rises: "rises to the north",
// "falls to the south", "slopes down to the east". {0, 0} means that they say nothing of it.
Claim::Heading RiseOf(const ReliefSentence& sentence, std::size_t begin, std::size_t end);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_ATTRIBUTES_H_
