#include "latticeworld/mapping/octree/asset_blocks.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

double AssetBlocks::MarginOfThin_m(const Asset& asset) const {
  if (asset.kind != AssetKind::kBuilding) return 0.0;
  const double cell_m = ground_.geometry().resolution_m();
  const double thin_m = std::min(asset.half_length_m, asset.half_width_m);
  const double long_m = std::max(asset.half_length_m, asset.half_width_m);
  const double through_m =
      0.5 * cell_m * (std::abs(std::cos(asset.yaw_rad)) + std::abs(std::sin(asset.yaw_rad)));
  return long_m >= cell_m ? std::max(0.0, through_m - thin_m) : 0.0;
}

// The robot is a cylinder of its radius and clearance, level, on the ground at the cell. A crown's
// underside rises with the distance from the trunk, so that it is lowest over the robot's part
// nearest to the trunk.
bool AssetBlocks::CrownBlocks(const Asset& tree, CellIndex cell) const {
  const double radius_m = tree.half_length_m;
  const WorldPoint point = ground_.geometry().CenterOf(cell);
  const double distance_m = std::hypot(point.x_m - tree.x_m, point.y_m - tree.y_m);
  const double nearest_m = std::max(distance_m - limits_.radius_m, 0.0);
  if (nearest_m >= radius_m) return false;
  const double half_height_m = 0.5 * (1.0 - kCrownBase) * tree.height_m;
  const double share = nearest_m / radius_m;
  const double underside_m =
      tree.z_m + tree.height_m - half_height_m * (1.0 + std::sqrt(1.0 - share * share));
  return underside_m < ground_.height_m()[cell] + limits_.clearance_m;
}

bool AssetBlocks::FallenTreeBlocks(const MappedAsset& tree, CellIndex cell) const {
  // What hangs this much higher than the robot is tall, or than the ground, lets it through below.
  constexpr double kLeastGap_m = 0.1;
  const Asset& asset = tree.asset;
  const WorldPoint point = ground_.geometry().CenterOf(cell);
  const double dx = point.x_m - asset.x_m, dy = point.y_m - asset.y_m;
  const double c = std::cos(tree.heading_rad), s = std::sin(tree.heading_rad);
  const double along_m = c * dx + s * dy, across_m = std::abs(-s * dx + c * dy);
  const double trunk_m = tree.Level_m(kTrunkTop * asset.height_m);
  const double beyond_m = std::max({-along_m, along_m - trunk_m, 0.0});
  if (std::hypot(beyond_m, across_m) < asset.trunk_radius_m + limits_.radius_m) {
    const double axis_m = tree.AxisHeight_m(std::clamp(along_m, 0.0, trunk_m));
    const double gap_m = axis_m - asset.trunk_radius_m - ground_.height_m()[cell];
    if (gap_m <= limits_.clearance_m + kLeastGap_m) return true;
  }
  if (limits_.clearance_m <= 0.0) return false;
  // An ellipse with both half axes grown holds every point that is closer than that to it.
  const double half_m = 0.5 * (1.0 - kCrownBase) * asset.height_m, radius_m = asset.half_length_m;
  const double crown_along_m =
      std::hypot(tree.Level_m(half_m), tree.rise_share * radius_m) + limits_.radius_m;
  const double crown_across_m = radius_m + limits_.radius_m;
  if (crown_along_m <= 0.0 || crown_across_m <= 0.0) return false;
  const double u = (along_m - trunk_m) / crown_along_m, v = across_m / crown_across_m;
  if (u * u + v * v >= 1.0) return false;
  const double lowest_m =
      tree.AxisHeight_m(trunk_m) - std::hypot(tree.rise_share * half_m, tree.Level_m(radius_m));
  return lowest_m < ground_.height_m()[cell] + limits_.clearance_m;
}

}  // namespace latticeworld
