#ifndef LATTICEWORLD_SCENE_BLUE_NOISE_H_
#define LATTICEWORLD_SCENE_BLUE_NOISE_H_

#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Least distance between the points of BlueNoise(size, per_m2) [m].
double BlueNoiseSpacing(double per_m2);

// Points over the whole world, about per_m2 of them a square metre (within 5 %, away from the
// borders of tiny worlds), none closer to another than BlueNoiseSpacing: a Poisson-disk set made by
// throwing darts into a background grid that holds one point a cell (Bridson 2007), several rounds
// over its cells. In row order from the south-west. per_m2 > 0.
std::vector<WorldPoint> BlueNoise(double size_m, double per_m2, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_BLUE_NOISE_H_
