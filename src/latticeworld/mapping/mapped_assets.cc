#include "latticeworld/mapping/mapped_assets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

bool IsMapped(AssetKind kind) { return IsSolid(kind) || kind == AssetKind::kBush; }

}  // namespace

double MappedAsset::reach_m() const {
  const double radius_m = asset.kind == AssetKind::kBuilding
                              ? SolidRadius(asset)
                              : std::max(double{asset.half_length_m}, SolidRadius(asset));
  return lies ? asset.height_m + radius_m : radius_m;
}

double MappedAsset::AxisHeight_m(double level_m) const {
  // An upright stem is its foot's column.
  constexpr double kSteepest = 0.01;
  return asset.z_m + rise_share / std::max(level_share, kSteepest) * level_m;
}

MappedAsset Lying(const Scene& scene, const FallenTree& tree) {
  const Eigen::Vector3d stem_m = tree.tip_m - tree.foot_m;
  MappedAsset mapped;
  mapped.asset = scene.assets[tree.asset];
  mapped.asset.x_m = static_cast<float>(tree.foot_m.x());
  mapped.asset.y_m = static_cast<float>(tree.foot_m.y());
  mapped.asset.z_m = static_cast<float>(tree.foot_m.z());
  mapped.lies = true;
  mapped.heading_rad = std::atan2(stem_m.y(), stem_m.x());
  mapped.level_share = stem_m.head<2>().norm() / stem_m.norm();
  mapped.rise_share = stem_m.z() / stem_m.norm();
  return mapped;
}

std::vector<MappedAsset> AssetsToMap(const Scene& scene, const SceneChanges& changes) {
  constexpr std::int32_t kStands = -1, kGone = -2;
  std::vector<std::int32_t> fate;  // by asset: its place in changes.fallen, or one of those
  if (!changes.empty()) {
    fate.assign(scene.assets.size(), kStands);
    for (const std::uint32_t asset : changes.gone) fate[asset] = kGone;
    for (std::size_t i = 0; i < changes.fallen.size(); ++i)
      fate[changes.fallen[i].asset] = static_cast<std::int32_t>(i);
  }
  std::vector<MappedAsset> mapped;
  for (std::size_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    if (!IsMapped(asset.kind)) continue;
    MappedAsset entry;
    entry.asset = asset;
    if (!fate.empty() && fate[i] != kStands) {
      if (fate[i] == kGone) continue;
      entry = Lying(scene, changes.fallen[fate[i]]);
    }
    mapped.push_back(entry);
  }
  return mapped;
}

}  // namespace latticeworld
