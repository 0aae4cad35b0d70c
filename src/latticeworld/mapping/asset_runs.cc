#include "latticeworld/mapping/asset_runs.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

struct AssetCutter::Job {
  const Asset& asset;
  const SurfaceWindow& window;
  std::vector<VoxelRun>* runs;
};

void AssetCutter::Cut(const MappedAsset& mapped, const SurfaceWindow& window,
                      std::vector<VoxelRun>* runs) const {
  const Asset& asset = mapped.asset;
  const Job job = {asset, window, runs};
  switch (asset.kind) {
    case AssetKind::kTree:
      if (mapped.lies) {
        CutFallenTree(mapped, job);
        break;
      }
      CutCylinder(job, asset.trunk_radius_m, kTrunkTop * asset.height_m);
      CutEllipsoid(job, kCrownBase * asset.height_m);
      break;
    case AssetKind::kBush:
      CutEllipsoid(job, 0.0);
      break;
    case AssetKind::kStone:
      CutCylinder(job, asset.half_length_m, asset.height_m);
      break;
    case AssetKind::kBuilding:
      CutBox(job);
      break;
    case AssetKind::kDeadBranch:
    case AssetKind::kGrassTuft:
    case AssetKind::kFlower:
    case AssetKind::kCrop:
      break;  // bodies pass through them
  }
}

// Calls visit(x, y, dx, dy) for the columns of the window whose centre is at most reach_m from
// (x_m, y_m) along each axis, at (dx, dy) [m] from it, and with (0, 0) for the column that holds
// it.
template <typename Visit>
void AssetCutter::ForEachColumn(const Job& job, double x_m, double y_m, double reach_m,
                                Visit&& visit) const {
  const auto index_of = [this](double coordinate_m) {
    return std::clamp(VoxelIndexOf(coordinate_m, voxel_m_), world_.x_low, world_.x_high);
  };
  const VoxelBox& box = job.window.box;
  const int x_own = index_of(x_m), y_own = index_of(y_m);
  const int x_low = std::max(index_of(x_m - reach_m), box.x_low);
  const int x_high = std::min(index_of(x_m + reach_m), box.x_high);
  const int y_high = std::min(index_of(y_m + reach_m), box.y_high);
  for (int y = std::max(index_of(y_m - reach_m), box.y_low); y <= y_high; ++y) {
    const double dy = VoxelCenter_m(y, voxel_m_) - y_m;
    for (int x = x_low; x <= x_high; ++x) {
      if (x == x_own && y == y_own) {
        visit(x, y, 0.0, 0.0);
      } else {
        visit(x, y, VoxelCenter_m(x, voxel_m_) - x_m, dy);
      }
    }
  }
}

void AssetCutter::Place(const Job& job, int x, int y, double low_m, double high_m) const {
  const VoxelBox& box = job.window.box;
  int low = std::clamp(VoxelIndexOf(low_m, voxel_m_), kMinVoxel, kMaxVoxel);
  int high = std::clamp(VoxelIndexOf(high_m, voxel_m_), low, kMaxVoxel);
  low = std::max(low, box.z_low);
  high = std::min(high, box.z_high);
  if (low > high) return;
  job.runs->push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                       static_cast<std::int16_t>(low), static_cast<std::int16_t>(high)});
}

// From the ground of the column up to high_m.
void AssetCutter::PlaceStanding(const Job& job, int x, int y, double low_m, double high_m) const {
  Place(job, x, y, std::min(low_m, VoxelCenter_m(job.window.at(x, y), voxel_m_)), high_m);
}

void AssetCutter::CutCylinder(const Job& job, double radius_m, double height_m) const {
  const Asset& asset = job.asset;
  ForEachColumn(job, asset.x_m, asset.y_m, radius_m, [&](int x, int y, double dx, double dy) {
    if (dx * dx + dy * dy <= radius_m * radius_m)
      PlaceStanding(job, x, y, asset.z_m, asset.z_m + height_m);
  });
}

void AssetCutter::CutBox(const Job& job) const {
  const Asset& asset = job.asset;
  const double c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
  const double reach_m = std::hypot(asset.half_length_m, asset.half_width_m);
  ForEachColumn(job, asset.x_m, asset.y_m, reach_m, [&](int x, int y, double dx, double dy) {
    if (std::abs(c * dx + s * dy) <= asset.half_length_m &&
        std::abs(-s * dx + c * dy) <= asset.half_width_m)
      PlaceStanding(job, x, y, asset.z_m, asset.z_m + asset.height_m);
  });
}

// The ellipsoid of the asset's radius between bottom_m above its base and its top.
void AssetCutter::CutEllipsoid(const Job& job, double bottom_m) const {
  const Asset& asset = job.asset;
  const double radius_m = asset.half_length_m;
  const double half_height_m = 0.5 * (asset.height_m - bottom_m);
  const double center_z_m = asset.z_m + bottom_m + half_height_m;
  ForEachColumn(job, asset.x_m, asset.y_m, radius_m, [&](int x, int y, double dx, double dy) {
    const double share = radius_m > 0.0 ? (dx * dx + dy * dy) / (radius_m * radius_m) : 0.0;
    if (share > 1.0) return;
    const double half_chord_m = half_height_m * std::sqrt(1.0 - share);
    Place(job, x, y, center_z_m - half_chord_m, center_z_m + half_chord_m);
  });
}

// The trunk lies on the ground from the foot to below the tip, and the crown around its axis; what
// of them would be in the ground is the ground's.
void AssetCutter::CutFallenTree(const MappedAsset& tree, const Job& job) const {
  const Asset& asset = tree.asset;
  const double c = std::cos(tree.heading_rad), s = std::sin(tree.heading_rad);
  const double radius_m = asset.trunk_radius_m;
  const double rise = asset.height_m > 0.0 ? (tree.tip_z_m - asset.z_m) / asset.height_m : 0.0;
  const auto axis_z_m = [&](double along_m) { return asset.z_m + radius_m + rise * along_m; };
  const double trunk_m = kTrunkTop * asset.height_m;
  ForEachColumn(
      job, asset.x_m, asset.y_m, trunk_m + radius_m, [&](int x, int y, double dx, double dy) {
        const double along_m = c * dx + s * dy, across_m = -s * dx + c * dy;
        // Thin trunks show on coarse voxels too.
        const double half_width_m = std::max(radius_m, 0.5 * voxel_m_);
        if (along_m < 0.0 || along_m > trunk_m || std::abs(across_m) > half_width_m) return;
        const double height_m = std::sqrt(std::max(radius_m * radius_m - across_m * across_m, 0.0));
        PlaceStanding(job, x, y, asset.z_m, axis_z_m(along_m) + height_m);
      });

  const double crown_m = 0.5 * (1.0 - kCrownBase) * asset.height_m;  // half its length
  const double crown_radius_m = asset.half_length_m;
  const double x_m = asset.x_m + c * trunk_m, y_m = asset.y_m + s * trunk_m;
  ForEachColumn(
      job, x_m, y_m, std::max(crown_m, crown_radius_m), [&](int x, int y, double, double) {
        // Its middle may lie outside the world: no column holds it then.
        const double dx = VoxelCenter_m(x, voxel_m_) - x_m;
        const double dy = VoxelCenter_m(y, voxel_m_) - y_m;
        const double along = crown_m > 0.0 ? (c * dx + s * dy) / crown_m : 0.0;
        const double across = crown_radius_m > 0.0 ? (-s * dx + c * dy) / crown_radius_m : 0.0;
        const double share = along * along + across * across;
        if (share > 1.0) return;
        const double half_chord_m = crown_radius_m * std::sqrt(1.0 - share);
        const double z_m = axis_z_m(trunk_m + along * crown_m);
        const double ground_m = VoxelCenter_m(job.window.at(x, y), voxel_m_);
        if (z_m + half_chord_m >= ground_m)
          Place(job, x, y, std::max(z_m - half_chord_m, ground_m), z_m + half_chord_m);
      });
}

}  // namespace latticeworld
