#ifndef LATTICEWORLD_GEOMORPHOLOGY_RESAMPLE_H_
#define LATTICEWORLD_GEOMORPHOLOGY_RESAMPLE_H_

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// The same surface on another grid over the same area, values at cell centres. Finer: Catmull-Rom
// (Keys 1981, "Cubic convolution interpolation"), which goes through the samples and may overshoot
// beside a step by 1/8 of it. Coarser: a triangle as wide as two new cells, so that nothing
// aliases. Beyond the outermost centres the nearest one continues. threads: 0 for as many as cores;
// the result is the same with any.
Grid<float> Resample(const Grid<float>& values, int rows, int cols, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_RESAMPLE_H_
