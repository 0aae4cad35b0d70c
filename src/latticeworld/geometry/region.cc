#include "latticeworld/geometry/region.h"

#include <algorithm>

namespace latticeworld {

UnitBox BoxOf(Region region) {
  if (region == Region::kAnywhere) return {};
  const int index = static_cast<int>(region);
  const int row = index / 3;
  const int col = index % 3;
  return {col / 3.0, (col + 1) / 3.0, row / 3.0, (row + 1) / 3.0};
}

Region RegionAt(const GridGeometry& geometry, WorldPoint point) {
  const double u = (point.x_m + geometry.half_size_m()) / geometry.size_m();
  const double v = (geometry.half_size_m() - point.y_m) / geometry.size_m();
  const int row = std::clamp(static_cast<int>(v * 3.0), 0, 2);
  const int col = std::clamp(static_cast<int>(u * 3.0), 0, 2);
  return static_cast<Region>(row * 3 + col);
}

bool IsIn(Region region, const GridGeometry& geometry, WorldPoint point) {
  return region == Region::kAnywhere || RegionAt(geometry, point) == region;
}

}  // namespace latticeworld
