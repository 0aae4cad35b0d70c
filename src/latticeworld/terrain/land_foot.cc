#include "latticeworld/terrain/land_foot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/terrain/cones.h"
#include "latticeworld/terrain/lattice.h"

namespace latticeworld::internal {

Grid<float> FootOf(const GridGeometry& lattice, const WaterBodies& water,
                   const Grid<float>& level_m, const Grid<float>& hills_m) {
  constexpr double kLakeFall = 0.12;  // [m/m]
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const int n = lattice.rows();
  Grid<unsigned char> runs(n, n, 0);
  Grid<float> above_m(n, n, -kInfinity), below_m(n, n, kInfinity);
  bool any_lake = false;
  for (const std::int32_t cell : water.bodies.cells) {
    const std::int32_t body = water.bodies.label.data()[cell];
    if (std::isnan(level_m.data()[cell])) continue;
    if (water.at_edge[body] || water.has_sea[body]) {
      runs.data()[cell] = 1;
    } else {
      above_m.data()[cell] = below_m.data()[cell] = level_m.data()[cell];
      any_lake = true;
    }
  }
  Grid<float> foot_m = hills_m;
  const Grid<std::int32_t> nearest = NearestOf(runs);
  if (nearest(0, 0) >= 0) {
    for (std::size_t i = 0; i < foot_m.size(); ++i) {
      foot_m.data()[i] = level_m.data()[nearest.data()[i]];
    }
    GaussianBlur(2.0 * LatticeCellsPerLayoutCell(lattice), &foot_m);
  }
  if (any_lake) {
    const auto fall_m = static_cast<float>(kLakeFall * lattice.resolution_m());
    UpperCones(fall_m, &above_m);
    LowerCones(fall_m, &below_m);
    for (std::size_t i = 0; i < foot_m.size(); ++i) {
      foot_m.data()[i] = std::min(std::max(foot_m.data()[i], above_m.data()[i]), below_m.data()[i]);
    }
  }
  return foot_m;
}

}  // namespace latticeworld::internal
