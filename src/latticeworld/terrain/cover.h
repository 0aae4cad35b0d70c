#ifndef LATTICEWORLD_TERRAIN_COVER_H_
#define LATTICEWORLD_TERRAIN_COVER_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld::internal {

// The letter of the largest weight in every cell (ties: the first in the alphabet).
Grid<char> DominantLetters(const SmoothedMasks& masks);

// What the ground of a class is made of, in both vocabularies.
SurfaceClass SurfaceOf(Vocabulary vocabulary, char letter);

// 1 where the letter stands, else 0.
Grid<unsigned char> MaskOf(char letter, const Grid<char>& letters);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_COVER_H_
