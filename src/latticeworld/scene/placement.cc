#include "latticeworld/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace latticeworld {
namespace {

constexpr int kRimPoints = 8;

// Validate has refused names that the type does not know; the first value stands for the rest.
std::uint8_t IndexOf(const std::vector<std::string_view>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0 : static_cast<std::uint8_t>(found - names.begin());
}

bool IsDryAndOffRoad(const Terrain& terrain, WorldPoint point) {
  return terrain.SurfaceAt(point) != SurfaceClass::kRoad && terrain.WaterDepthAt(point) <= 0.0;
}

}  // namespace

DensityField DensityFor(const Placement& placement, AssetKind kind) {
  return DensityField(placement.terrain.weights, placement.environment, placement.catalogue, kind,
                      placement.thinning[kind]);
}

Asset MakeAsset(const Placement& placement, AssetKind kind) {
  const Catalogue& catalogue = placement.catalogue;
  const AssetType type = TypeOf(kind);
  const AssetTypeValues& values = catalogue.ValuesOf(type);
  const FineAttribute& fine = placement.environment.fine_of(type);
  Asset asset;
  asset.kind = kind;
  asset.season_variant = IndexOf(values.season_variants, fine.season_variant);
  asset.material = IndexOf(values.materials, fine.material);
  asset.model = catalogue.models_of(kind).front();
  for (const std::uint8_t model : catalogue.models_of(kind)) {
    if (!catalogue.CanWear(model, asset.season_variant) ||
        !catalogue.CanBeOf(model, asset.material)) {
      continue;
    }
    asset.model = model;
    break;
  }
  return asset;
}

void AddAsset(Placement* placement, const Asset& asset) {
  if (placement->assets.size() >= static_cast<std::size_t>(kMaxAssets)) {
    ++placement->left_out;
    return;
  }
  if (IsSolid(asset.kind)) placement->solids.Add(asset.position(), SolidRadius(asset));
  placement->assets.push_back(asset);
}

bool IsBuildable(const Terrain& terrain, WorldPoint point, double radius_m) {
  const double limit_m = terrain.geometry().half_size_m() - radius_m;
  if (!(std::abs(point.x_m) <= limit_m && std::abs(point.y_m) <= limit_m)) return false;
  if (!IsDryAndOffRoad(terrain, point)) return false;
  if (radius_m <= 0.0) return true;
  for (int i = 0; i < kRimPoints; ++i) {
    const double angle_rad = 2.0 * M_PI * i / kRimPoints;
    const WorldPoint rim = {point.x_m + radius_m * std::cos(angle_rad),
                            point.y_m + radius_m * std::sin(angle_rad)};
    if (!IsDryAndOffRoad(terrain, rim)) return false;
  }
  return true;
}

bool IsFreeOfSolids(const Placement& placement, const AssetIndex& solids, WorldPoint point) {
  bool is_free = true;
  solids.ForEachNear(point, 0.0, [&](std::uint32_t i) {
    is_free = is_free && !SolidContains(placement.assets[i], point, 0.0);
  });
  return is_free;
}

bool IsSlopeAtMost(const Terrain& terrain, WorldPoint point, double limit_deg) {
  return terrain.ground.SlopeAt(point) <= limit_deg * M_PI / 180.0;
}

double DrawSize(const SizeRange& range, PointRandom* random) {
  double size = range.mean + range.deviation * random->Normal();
  // What falls below the least is turned back up, so that no heap of equal sizes forms there.
  if (size < range.low) size = 2.0 * range.low - size;
  return std::clamp(size, range.low, range.high);
}

}  // namespace latticeworld
