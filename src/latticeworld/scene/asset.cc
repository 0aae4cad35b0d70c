#include "latticeworld/scene/asset.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

static_assert(sizeof(Asset) <= 64, "a world holds many assets: keep them small");

double SolidRadius(const Asset& asset) {
  switch (asset.kind) {
    case AssetKind::kTree:
      return asset.trunk_radius_m;
    case AssetKind::kStone:
      return asset.half_length_m;
    case AssetKind::kBuilding:
      return std::hypot(double{asset.half_length_m}, double{asset.half_width_m});
    default:
      return 0.0;
  }
}

bool SolidContains(const Asset& asset, WorldPoint point, double margin_m) {
  if (!IsSolid(asset.kind)) return false;
  const double dx = point.x_m - asset.x_m, dy = point.y_m - asset.y_m;
  if (asset.kind != AssetKind::kBuilding) {
    return std::hypot(dx, dy) < SolidRadius(asset) + margin_m;
  }
  // Distance to the rectangle, in the building's own axes.
  const double cosine = std::cos(asset.yaw_rad), sine = std::sin(asset.yaw_rad);
  const double along = std::abs(cosine * dx + sine * dy) - asset.half_length_m;
  const double across = std::abs(-sine * dx + cosine * dy) - asset.half_width_m;
  if (along < 0.0 && across < 0.0) return std::max(along, across) < margin_m;
  return std::hypot(std::max(along, 0.0), std::max(across, 0.0)) < margin_m;
}

}  // namespace latticeworld
