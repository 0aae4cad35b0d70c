#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_SURFACE_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_SURFACE_H_

#include <cstdint>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "latticeworld/relief/sketch/sketch_courses.h"

namespace latticeworld::internal {

// The smooth land through the strokes, before water works on it. All grids (cells x cells), over
// the unit square.
struct SketchSurface {
  Grid<float> height;  // 0 at the lowest mouth, about 1 on ridges over low land
  Courses courses;
  Grid<unsigned char> ridge;  // 1 along the middle of the ridge strokes
};

// A membrane that springs pull: hard to the floors along the valleys, towards peaks and saddles
// along the ridges, weakly to rolling land everywhere. So the height of a ridge comes out of what
// lies around it: low beside a valley, falling off at its ends. land: heights of any scale (n x n)
// that take the place of the rolling land and of what ridges strive for; null: none. Errors:
// CANCELLED.
Result<SketchSurface> MakeSketchSurface(const Sketch& sketch, const Grid<float>* land, int cells,
                                        std::uint64_t seed, int threads, const Progress& progress);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_SURFACE_H_
