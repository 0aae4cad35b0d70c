#include "latticeworld/terrain/ways/embankment.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/terrain/cones.h"

namespace latticeworld::internal {

void LayInto(const Grid<unsigned char>& mask, const Grid<float>& built_m, float rise_per_cell,
             Grid<float>* land_m, Grid<float>* share) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kShoulder_cells = 1.6f;
  constexpr float kFading_cells = 3.0f;  // of what is finer than the lattice
  constexpr float kSteepening = 2.0f;
  constexpr float kGentleHeight_m = 3.0f;
  const Grid<float> to_built = DistanceTo(true, mask);
  const Grid<std::int32_t> nearest = NearestOf(mask);
  Grid<float> highest(mask.rows(), mask.cols(), kInfinity);
  Grid<float> lowest(mask.rows(), mask.cols(), -kInfinity);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (to_built.data()[i] > kShoulder_cells) continue;
    highest.data()[i] = lowest.data()[i] = built_m.data()[nearest.data()[i]];
  }
  Grid<float> steep_highest = highest, steep_lowest = lowest;
  LowerCones(rise_per_cell, &highest);
  UpperCones(rise_per_cell, &lowest);
  LowerCones(kSteepening * rise_per_cell, &steep_highest);
  UpperCones(kSteepening * rise_per_cell, &steep_lowest);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    highest.data()[i] = std::max(highest.data()[i], steep_highest.data()[i] - kGentleHeight_m);
    lowest.data()[i] = std::min(lowest.data()[i], steep_lowest.data()[i] + kGentleHeight_m);
  }
  for (std::size_t i = 0; i < mask.size(); ++i) {
    float& land = land_m->data()[i];
    const float high = highest.data()[i], low = lowest.data()[i];
    // Unlike heights side by side: half-way.
    const float shaped = low > high ? 0.5f * (low + high) : std::clamp(land, low, high);
    const float near =
        std::clamp(1.0f + (kShoulder_cells - to_built.data()[i]) / kFading_cells, 0.0f, 1.0f);
    share->data()[i] = std::max({share->data()[i], near, shaped != land ? 1.0f : 0.0f});
    land = shaped;
  }
}

}  // namespace latticeworld::internal
