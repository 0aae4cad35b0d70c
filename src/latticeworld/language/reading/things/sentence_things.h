#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_THINGS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_THINGS_H_

#include <string_view>

#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/chunk.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {

// The number of a phrase of slot {n}.
double NumberOf(const Phrase& phrase);

// The share of the map that a phrase of slot {percent} means: "30 %" leaves eight points of room to
// either side, bounds leave none.
ShareMatch ShareOf(const Phrase& percent);

// Adds what a word of the lists "size" or "shape" says of a thing.
void AddSize(std::string_view size, Qualities* qualities);
void AddShape(std::string_view shape, Qualities* qualities);

// A thing's words, of slot {thing} or {noun}: its class, number, sizes and shapes. Without a class
// (`noun` is nullptr) nothing is known by that noun.
NounPhrase NounOf(const Phrase& thing);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_THINGS_H_
