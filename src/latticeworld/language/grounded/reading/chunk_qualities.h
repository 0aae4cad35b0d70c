#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_CHUNK_QUALITIES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_CHUNK_QUALITIES_H_

#include "latticeworld/language/grounded/reading/chunk.h"
#include "latticeworld/language/grounded/reading/lexeme.h"

namespace latticeworld {

// Whether the lexeme tells a quality; it is added then.
bool AddQuality(const Lexeme& lexeme, Qualities* said);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_CHUNK_QUALITIES_H_
