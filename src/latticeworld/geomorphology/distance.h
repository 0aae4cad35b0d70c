#ifndef LATTICEWORLD_GEOMORPHOLOGY_DISTANCE_H_
#define LATTICEWORLD_GEOMORPHOLOGY_DISTANCE_H_

#include <limits>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

inline constexpr float kNoFeature = std::numeric_limits<float>::infinity();

// Computes in place values(x) = min over y of values(y) + curvature * |x - y|^2, distances in
// cells, with kNoFeature where y carries nothing (all of them: unchanged). curvature > 0. Exact, in
// linear time: Felzenszwalb and Huttenlocher 2012, "Distance transforms of sampled functions".
// threads: 0 for as many as cores; the result is the same with any.
void LowerEnvelope(double curvature, Grid<float>* values, int threads = 0);

// Euclidean distance [cells] of every cell to the nearest cell whose mask is `feature`; kNoFeature
// everywhere when there is none.
Grid<float> DistanceTo(bool feature, const Grid<unsigned char>& mask, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_DISTANCE_H_
