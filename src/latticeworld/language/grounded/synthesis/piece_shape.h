#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_PIECE_SHAPE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_PIECE_SHAPE_H_

#include <optional>

#include "latticeworld/common/random.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {

// What a compact piece pays for each cell when it grows around `middle` to so many cells, (32 x
// 32): low cells make up the shape. Unsaid: a natural blob.
struct PieceShape {
  Grid<float> cost;
  int cells = 0;  // what the shape needs at least, or what was asked
  Spot seed;      // where it starts: on the ring, not within
};
PieceShape ShapeOf(std::optional<ClaimShape> shape, Spot middle, int cells, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_PIECE_SHAPE_H_
