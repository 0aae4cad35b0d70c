#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/class_areas.h"
#include "latticeworld/scene/densities.h"
#include "latticeworld/scene/placement.h"

namespace latticeworld {
namespace {

constexpr double kRowSpacing_m = 2.5;
constexpr double kSteepestForCrops_deg = 15.0;
constexpr double kLeastFieldWeight = 0.5;  // rows end where the field does, not in its blended hem

}  // namespace

void PlaceCrops(Placement* placement, const AssetIndex& solids) {
  const Terrain& terrain = placement->terrain;
  const GridGeometry& geometry = terrain.geometry();
  const DensityField density(terrain.weights, placement->environment, AssetKind::kCrop,
                             placement->thinning);
  const WeightGrid* weight =
      terrain.weights.vocabulary == Vocabulary::kSuburb ? terrain.weights.Find('A') : nullptr;
  if (weight == nullptr || density.largest_per_m2() <= 0.0) return;

  // Rows lie square in a plane that is turned by each field's own direction. They are spread out as
  // one where thinning or a low density would leave less than a plant per row spacing.
  RandomStream random(placement->seed, "scene/crops");
  const ClassAreas fields(geometry, *weight);
  const double row_m = std::max(kRowSpacing_m, 1.0 / std::sqrt(density.largest_per_m2()) / 2.0);
  const double plant_m = 1.0 / (row_m * density.largest_per_m2());
  const double turn_rad =
      placement->environment.fine_of(AssetType::kCrops).rotation_deg[2] * M_PI / 180.0;
  const Asset proto = MakeAsset(placement->environment, AssetKind::kCrop);
  for (std::size_t field = 0; field < fields.areas().size(); ++field) {
    const ClassAreas::Area& area = fields.areas()[field];
    const double direction_rad = area.direction_rad + turn_rad;
    const double cosine = std::cos(direction_rad), sine = std::sin(direction_rad);
    const int rows = static_cast<int>(area.reach_m / row_m) + 1;
    const int plants = static_cast<int>(area.reach_m / plant_m) + 1;
    for (int row = -rows; row <= rows; ++row) {
      for (int plant = -plants; plant <= plants; ++plant) {
        const double across = row * row_m, along_exact = plant * plant_m;
        const WorldPoint exact = {area.centre.x_m + cosine * along_exact - sine * across,
                                  area.centre.y_m + sine * along_exact + cosine * across};
        if (!geometry.Contains(exact) || fields.AreaAt(exact) != static_cast<int>(field)) continue;
        const double along = along_exact + random.Uniform(-0.15, 0.15) * plant_m;
        const WorldPoint point = {area.centre.x_m + cosine * along - sine * across,
                                  area.centre.y_m + sine * along + cosine * across};
        Asset asset = proto;
        asset.x_m = static_cast<float>(point.x_m);
        asset.y_m = static_cast<float>(point.y_m);
        asset.yaw_rad = static_cast<float>(std::remainder(direction_rad, 2.0 * M_PI));
        asset.height_m = static_cast<float>(random.Uniform(0.6, 1.4));
        asset.scale = asset.height_m;
        asset.half_length_m = static_cast<float>(asset.height_m * random.Uniform(0.2, 0.35));
        asset.half_width_m = asset.half_length_m;
        if (!IsBuildable(terrain, asset.position(), 0.0) ||
            (*weight)[geometry.CellAt(asset.position())] < kLeastFieldWeight ||
            terrain.ground.SlopeAt(asset.position()) > kSteepestForCrops_deg * M_PI / 180.0 ||
            !IsFreeOfSolids(*placement, solids, asset.position())) {
          continue;
        }
        asset.z_m = static_cast<float>(terrain.ground.HeightAt(asset.position()));
        AddAsset(placement, asset);
      }
    }
  }
}

}  // namespace latticeworld
