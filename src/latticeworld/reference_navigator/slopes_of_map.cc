#include "latticeworld/reference_navigator/slopes_of_map.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

double SlopesOfMap::MostRise(WorldPoint from, WorldPoint to) const {
  const double far_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  const int steps = std::max(1, static_cast<int>(far_m / map_.geometry.resolution_m()));
  double rise_m = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps;
    const WorldPoint at{from.x_m + share * (to.x_m - from.x_m),
                        from.y_m + share * (to.y_m - from.y_m)};
    if (!map_.geometry.Contains(at)) continue;
    // Costs are whole numbers, and ground is rougher than a cell's mean slope.
    const int cost = std::clamp<int>(map_.cost[map_.geometry.CellAt(at)], 0, 50);
    rise_m += far_m / steps * std::tan(slope_ * std::min(1.0, 1.25 * (cost + 1) / 50.0));
  }
  return rise_m;
}

}  // namespace latticeworld
