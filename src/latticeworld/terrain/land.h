#ifndef LATTICEWORLD_TERRAIN_LAND_H_
#define LATTICEWORLD_TERRAIN_LAND_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld::internal {

// The land before water and paving [m]: gentle hills, finer undulation as each class has it, and
// mountains of rock and snow that rise with the distance from their border.
Grid<float> ShapedLand(const GridGeometry& geometry, const ClassWeights& weights,
                       const Grid<char>& letters, std::uint64_t seed);

// The user's land [m] on the world's grid. Where its heights come in steps the terraces are
// smoothed, each height by at most half a step: what the picture's depth left open.
Grid<float> ReliefLand(const GridGeometry& geometry, const Relief& relief);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_LAND_H_
