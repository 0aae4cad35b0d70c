#ifndef LATTICEWORLD_TESTS_SCENE_VEGETATION_EVEN_POINTS_H_
#define LATTICEWORLD_TESTS_SCENE_VEGETATION_EVEN_POINTS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/scene/vegetation/blue_noise.h"

namespace latticeworld {

// All points of a full set.
inline std::vector<WorldPoint> EvenPoints(double size_m, double per_m2, std::uint64_t seed) {
  const RankedBlueNoise noise(
      size_m, per_m2, seed, [](WorldPoint, WorldPoint) { return 1.0; }, 1);
  std::vector<WorldPoint> points;
  for (int tile = 0; tile < noise.tiles(); ++tile) {
    noise.ForEachIn(tile, [&](const RankedBlueNoise::Point& point) {
      points.push_back({point.x_m, point.y_m});
    });
  }
  return points;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SCENE_VEGETATION_EVEN_POINTS_H_
