// What stands in rows: crops and orchards.

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/vegetation/fields.h"
#include "latticeworld/scene/vegetation/scatter.h"
#include "latticeworld/scene/vegetation/trees.h"

namespace latticeworld {
namespace {

constexpr double kRowSpacing_m = 2.5;
constexpr double kOrchardRows_m = 7.0, kOrchardTrees_m = 5.0, kOrchardJitter = 0.05;

float YawOf(const Field& field) {
  return static_cast<float>(std::remainder(field.row_rad, 2.0 * M_PI));
}

Asset MakeFrom(const Field& field) {
  Asset asset;
  asset.kind = field.kind;
  asset.model = field.choice.model;
  asset.season_variant = field.choice.season_variant;
  asset.material = field.choice.material;
  return asset;
}

// Returns the random numbers of the i-th field.
PointRandom OrchardRandom(const Placement& placement, std::size_t i) {
  return PointRandom(StreamSeed(placement.seed, "scene/orchards"), i);
}

std::vector<WorldPoint> OrchardRows(const Placement& placement, const Field& field,
                                    PointRandom* random) {
  return RowsOf(field, placement.terrain.geometry(), kOrchardRows_m, kOrchardTrees_m,
                kOrchardJitter, random);
}

}  // namespace

double OrchardPlaces(const Placement& placement) {
  double places = 0.0;
  const std::vector<Field>& fields = placement.fields->fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].kind != AssetKind::kTree) continue;
    PointRandom random = OrchardRandom(placement, i);
    places += static_cast<double>(OrchardRows(placement, fields[i], &random).size());
  }
  return places;
}

void PlaceOrchards(Placement* placement) {
  const Terrain& terrain = placement->terrain;
  const FieldPlan& plan = *placement->fields;
  const double thinning = placement->thinning[AssetKind::kTree];
  Tally::Kind& trees = placement->tally.Of(AssetKind::kTree);
  Tally::Kind& crops = placement->tally.Of(AssetKind::kCrop);
  constexpr double kTreesPerM2 = 1.0 / (kOrchardRows_m * kOrchardTrees_m);
  for (std::size_t i = 0; i < plan.fields().size(); ++i) {
    const Field& field = plan.fields()[i];
    if (field.kind != AssetKind::kTree) continue;
    PointRandom random = OrchardRandom(*placement, i);
    const std::vector<WorldPoint> places = OrchardRows(*placement, field, &random);
    // They stand instead of crops.
    const double area_m2 = static_cast<double>(places.size()) / kTreesPerM2 / InnerShareOf(field);
    trees.wanted += thinning * static_cast<double>(places.size());
    crops.wanted = std::max(
        0.0, crops.wanted - area_m2 * field.crop_per_m2 * placement->thinning[AssetKind::kCrop]);
    for (const WorldPoint& point : places) {
      if (thinning < 1.0 && !random.Chance(thinning)) continue;
      Asset tree = MakeFrom(field);
      StandAt(terrain, point, &tree);
      SizeTree(placement->catalogue.models()[tree.model], field.choice.vigour, kTreesPerM2, &random,
               &tree);
      const double radius_m = SolidRadius(tree);
      if (!IsSlopeAtMost(terrain, tree.position(), kSteepestForCrops_deg)) {
        trees.Refuse(Refusal::kTooSteep);
      } else if (!IsBuildable(terrain, tree.position(), radius_m + kRoadMargin_m)) {
        trees.Refuse(Refusal::kWaterOrRoad);
      } else if (placement->solids.Overlaps(tree.position(), radius_m)) {
        trees.Refuse(Refusal::kOccupied);
      } else {
        AddAsset(placement, tree);
      }
    }
  }
}

void PlaceCrops(Placement* placement, const AssetIndex& solids) {
  const Terrain& terrain = placement->terrain;
  const FieldPlan& plan = *placement->fields;
  const double thinning = placement->thinning[AssetKind::kCrop];
  if (thinning <= 0.0) return;
  const std::uint64_t seed = StreamSeed(placement->seed, "scene/crops");
  const auto count = static_cast<int>(plan.fields().size());
  std::vector<std::vector<Asset>> grown(count);
  std::vector<Tally::Kind> tallies(count);
  ParallelFor(count, placement->threads, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Field& field = plan.fields()[i];
      if (field.kind != AssetKind::kCrop) continue;
      const AssetModel& model = placement->catalogue.models()[field.choice.model];
      const double growth =
          placement->catalogue.season_variants(AssetType::kCrops)[field.choice.season_variant]
              .growth;
      // Rows are spread out where thinning or a low density would leave less than a plant per row
      // spacing. What the margin takes stands closer inside.
      const double per_m2 = thinning * field.crop_per_m2 / InnerShareOf(field);
      const double rows_m = std::max(kRowSpacing_m, 0.5 / std::sqrt(per_m2));
      PointRandom random(seed, static_cast<std::uint64_t>(i));
      for (const WorldPoint& point :
           RowsOf(field, terrain.geometry(), rows_m, 1.0 / (rows_m * per_m2), 0.15, &random)) {
        Asset crop = MakeFrom(field);
        StandAt(terrain, point, &crop);
        const double full_m = DrawSize(model.height_m, &random);
        crop.height_m = static_cast<float>(full_m * growth);
        crop.scale = static_cast<float>(full_m / model.height_m.mean);
        crop.half_length_m = static_cast<float>(full_m * DrawSize(model.spread, &random));
        crop.half_width_m = crop.half_length_m;
        crop.yaw_rad = YawOf(field);
        if (!IsSlopeAtMost(terrain, crop.position(), kSteepestForCrops_deg)) {
          tallies[i].Refuse(Refusal::kTooSteep);
        } else if (!IsBuildable(terrain, crop.position(), 0.0)) {
          tallies[i].Refuse(Refusal::kWaterOrRoad);
        } else if (!IsFreeOfSolids(*placement, solids, crop.position())) {
          tallies[i].Refuse(Refusal::kOccupied);
        } else {
          grown[i].push_back(crop);
        }
      }
    }
  });
  std::size_t total = placement->assets.size();
  for (const std::vector<Asset>& crops : grown) total += crops.size();
  placement->assets.reserve(total);
  Tally::Kind& tally = placement->tally.Of(AssetKind::kCrop);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < kRefusalCount; ++k) tally.refused[k] += tallies[i].refused[k];
    for (const Asset& crop : grown[i]) AddAsset(placement, crop);
  }
}

}  // namespace latticeworld
