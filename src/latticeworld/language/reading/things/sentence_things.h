#ifndef LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_THINGS_H_
#define LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_THINGS_H_

#include <string_view>

#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/chunk.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {

// Returns the number that a phrase of slot {n} says.
double NumberOf(const Phrase& phrase);

// Whether a phrase of slot {thing} has a number or "a" before its noun.
bool IsSaidSingly(const Phrase& thing);

// Returns the share of the map that a phrase of slot {percent} means. "30 %" leaves eight points of
// room to either side; bounds leave none.
ShareMatch ShareOf(const Phrase& percent);

// Adds to `qualities` what a word of the list "size" or "shape" says of a thing.
void AddSize(std::string_view size, Qualities* qualities);
void AddShape(std::string_view shape, Qualities* qualities);

// Reads a thing's words, of slot {thing} or {noun}: its class, number, sizes and shapes. Where
// `noun` of the result is nullptr, no class is known by the noun.
NounPhrase NounOf(const Phrase& thing);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_THINGS_SENTENCE_THINGS_H_
