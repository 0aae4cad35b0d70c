#include "latticeworld/mapping/mapped_assets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
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

Status Validate(const SceneChanges& changes, const Scene& scene) {
  std::vector<Violation> violations;
  std::vector<bool> named(scene.assets.size(), false);
  const auto check = [&](const std::string& field, std::uint32_t asset, bool must_be_tree) {
    const auto add = [&](const char* code, std::string message) {
      violations.push_back({code, field, std::move(message), std::to_string(asset)});
    };
    if (asset >= scene.assets.size()) {
      add("out_of_range",
          "must be below the scene's " + std::to_string(scene.assets.size()) + " assets");
      return;
    }
    if (named[asset]) add("duplicate", "asset " + std::to_string(asset) + " is named twice");
    named[asset] = true;
    if (must_be_tree && scene.assets[asset].kind != AssetKind::kTree)
      add("wrong_kind", "only trees fall, and asset " + std::to_string(asset) + " is a " +
                            std::string(NameOf(scene.assets[asset].kind)));
  };
  for (std::size_t i = 0; i < changes.fallen.size(); ++i) {
    const std::string field = "fallen/" + std::to_string(i);
    check(field + "/asset", changes.fallen[i].asset, true);
    if (!std::isfinite(changes.fallen[i].heading_rad))
      violations.push_back({"not_finite", field + "/heading_rad", "must be a finite angle",
                            FormatDouble(changes.fallen[i].heading_rad)});
  }
  for (std::size_t i = 0; i < changes.gone.size(); ++i)
    check("gone/" + std::to_string(i), changes.gone[i], false);
  return Status::FromViolations("illegal scene changes", std::move(violations));
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
      entry.lies = true;
      entry.heading_rad = changes.fallen[fate[i]].heading_rad;
      entry.tip_z_m = scene.terrain->ground.HeightAt(
          {asset.x_m + asset.height_m * std::cos(entry.heading_rad),
           asset.y_m + asset.height_m * std::sin(entry.heading_rad)});
    }
    mapped.push_back(entry);
  }
  return mapped;
}

}  // namespace latticeworld
