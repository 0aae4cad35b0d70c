#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_EROSION_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_EROSION_H_

#include <cstdint>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/sketch/sketch_surface.h"

namespace latticeworld::internal {

// Marks with 1, on the surface's grid, where water leaves the land or comes to rest: along the
// drawn valleys, whose floors stay; at their mouths; in the dips of the border; and at the bottom
// of deep hollows (a crater), which would otherwise be drained through their rim.
Grid<unsigned char> FindOutlets(const SketchSurface& surface, int threads);

// Lets water cut its valleys into the surface, first broadly on a coarse grid, then finer: what a
// grid has changed is carried to the next one, which adds finer roughness. Floors along drawn
// valleys stay, so that everything drains to them. Gives (n x n) heights, n up to 1024 and no more
// than samples. Errors: CANCELLED.
Result<Grid<float>> ErodeSurface(const SketchSurface& surface, int samples, std::uint64_t seed,
                                 int threads, const Progress& progress);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_EROSION_H_
