#include "latticeworld/scene/vegetation/thinning.h"

#include <algorithm>

#include "latticeworld/scene/placement.h"

namespace latticeworld {
namespace {

constexpr double kLeastCover = 0.1;  // of its density, as long as trees are not thinned

// These are plants around a building, at density 1. Sheds and the like have no garden.
constexpr double kGardenBushes = 10.0, kGardenFlowers = 9.0, kGardenTrees = 1.0;

bool IsCover(AssetKind kind) {
  return kind == AssetKind::kBush || kind == AssetKind::kGrassTuft || kind == AssetKind::kFlower ||
         kind == AssetKind::kCrop;
}

}  // namespace

Thinning::Thinning(const OfKinds& expected, double most) : Thinning() {
  double cover = 0.0, buildings = 0.0, others = 0.0;
  for (const auto& kind : EnumNames(AssetKind{})) {
    const double count = expected[static_cast<std::size_t>(kind.value)];
    (IsCover(kind.value)                  ? cover
     : kind.value == AssetKind::kBuilding ? buildings
                                          : others) += count;
  }
  const double room = std::max(0.0, most - buildings);
  if (cover + others <= room) return;
  double of_others = 1.0, of_cover = 0.0;
  if (others + kLeastCover * cover <= room) {
    of_cover = (room - others) / cover;
  } else {
    of_others = room / (others + kLeastCover * cover);
    of_cover = kLeastCover * of_others;
  }
  for (const auto& kind : EnumNames(AssetKind{})) {
    if (kind.value == AssetKind::kBuilding) continue;
    factors_[static_cast<std::size_t>(kind.value)] = IsCover(kind.value) ? of_cover : of_others;
  }
}

OfKinds ExpectedAssets(const Placement& placement) {
  OfKinds expected{};
  const auto of = [&expected](AssetKind kind) -> double& {
    return expected[static_cast<std::size_t>(kind)];
  };
  const auto density_of = [&placement](AssetKind kind) {
    return placement.environment.fine_of(TypeOf(kind)).density;
  };
  const double shore_m2 = placement.sites.ShoreArea_m2(kShoreBelt_m);
  for (const auto& kind : EnumNames(AssetKind{})) {
    const DensityField full(placement.terrain.weights, placement.environment, placement.catalogue,
                            kind.value, 1.0);
    of(kind.value) = full.Expected(placement.terrain.geometry()) +
                     shore_m2 * ShorePerM2(kind.value) * density_of(kind.value);
  }
  const double buildings = of(AssetKind::kBuilding);
  // Hedges are whole or not there.
  if (density_of(AssetKind::kBush) > 0.0) of(AssetKind::kBush) += buildings * kGardenBushes;
  of(AssetKind::kFlower) += buildings * kGardenFlowers * density_of(AssetKind::kFlower);
  of(AssetKind::kTree) += buildings * kGardenTrees * density_of(AssetKind::kTree);
  of(AssetKind::kTree) += OrchardPlaces(placement);
  return expected;
}

}  // namespace latticeworld
