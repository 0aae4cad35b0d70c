#include "latticeworld/mapping/octree/asset_runs.h"

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
      CutBox(job, mapped.hangs);
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

// Places what stands from the ground of the column (from low_m, if that is lower) up to high_m.
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

void AssetCutter::CutBox(const Job& job, bool hangs) const {
  const Asset& asset = job.asset;
  const double c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
  // A fence is thinner than a column is wide: all columns that its middle line goes through have
  // it, so that there are no gaps.
  const double column_m = 0.5 * voxel_m_ * (std::abs(c) + std::abs(s));
  double half_length_m = asset.half_length_m, half_width_m = asset.half_width_m;
  if (half_width_m >= voxel_m_) half_length_m = std::max(half_length_m, column_m);
  if (double{asset.half_length_m} >= voxel_m_) half_width_m = std::max(half_width_m, column_m);
  const double reach_m = std::hypot(half_length_m, half_width_m);
  ForEachColumn(job, asset.x_m, asset.y_m, reach_m, [&](int x, int y, double dx, double dy) {
    if (std::abs(c * dx + s * dy) <= half_length_m && std::abs(-s * dx + c * dy) <= half_width_m) {
      if (hangs) {
        Place(job, x, y, asset.z_m, asset.z_m + asset.height_m);
      } else {
        PlaceStanding(job, x, y, asset.z_m, asset.z_m + asset.height_m);
      }
    }
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

// The stem lies as its axis says, and the crown around its upper part; what of them would be in the
// ground is the ground's.
void AssetCutter::CutFallenTree(const MappedAsset& tree, const Job& job) const {
  const Asset& asset = tree.asset;
  const double c = std::cos(tree.heading_rad), s = std::sin(tree.heading_rad);
  const double radius_m = asset.trunk_radius_m;
  const double trunk_m = tree.Level_m(kTrunkTop * asset.height_m);
  // A column sees so much of a steep stem below and above its axis.
  const double steep_m = 0.5 * std::abs(tree.AxisHeight_m(voxel_m_) - tree.AxisHeight_m(0.0));
  // Calls visit(x, y, along, across) for the columns near a place on the stem, whose own column may
  // lie outside the world.
  const auto for_each_column = [&](double from_foot_m, double reach_m, const auto& visit) {
    const double x_m = asset.x_m + c * from_foot_m, y_m = asset.y_m + s * from_foot_m;
    ForEachColumn(job, x_m, y_m, reach_m, [&](int x, int y, double, double) {
      const double dx = VoxelCenter_m(x, voxel_m_) - asset.x_m;
      const double dy = VoxelCenter_m(y, voxel_m_) - asset.y_m;
      visit(x, y, c * dx + s * dy, -s * dx + c * dy);
    });
  };
  const auto place = [&](int x, int y, double low_m, double high_m) {
    const double ground_m = VoxelCenter_m(job.window.at(x, y), voxel_m_);
    if (high_m >= ground_m) Place(job, x, y, std::max(low_m, ground_m), high_m);
  };
  // Thin trunks show on coarse voxels too.
  const double half_width_m = std::max(radius_m, 0.5 * voxel_m_);
  for_each_column(0.0, trunk_m + half_width_m, [&](int x, int y, double along, double across) {
    if (along < -0.5 * voxel_m_ || along > std::max(trunk_m, 0.5 * voxel_m_)) return;
    if (std::abs(across) > half_width_m) return;
    const double half_m = std::sqrt(std::max(radius_m * radius_m - across * across, 0.0)) + steep_m;
    const double z_m = tree.AxisHeight_m(std::clamp(along, 0.0, trunk_m));
    place(x, y, z_m - half_m, z_m + half_m);
  });

  const double half_length_m = 0.5 * (1.0 - kCrownBase) * asset.height_m;
  const double crown_radius_m = asset.half_length_m;
  const double crown_m = std::hypot(tree.Level_m(half_length_m), tree.rise_share * crown_radius_m);
  if (crown_m <= 0.0 || crown_radius_m <= 0.0) return;
  const double middle_z_m = tree.AxisHeight_m(trunk_m);
  // Height over way of the middle of the ellipse's upright chords.
  const double tilt = tree.rise_share * tree.level_share *
                      (half_length_m * half_length_m - crown_radius_m * crown_radius_m) /
                      (crown_m * crown_m);
  const double chord_m = half_length_m * crown_radius_m / crown_m;
  for_each_column(trunk_m, std::max(crown_m, crown_radius_m),
                  [&](int x, int y, double along, double across) {
                    const double u = (along - trunk_m) / crown_m, v = across / crown_radius_m;
                    const double share = u * u + v * v;
                    if (share > 1.0) return;
                    const double half_m = chord_m * std::sqrt(1.0 - share);
                    const double z_m = middle_z_m + tilt * (along - trunk_m);
                    place(x, y, z_m - half_m, z_m + half_m);
                  });
}

}  // namespace latticeworld
