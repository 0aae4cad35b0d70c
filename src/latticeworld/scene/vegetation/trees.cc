#include "latticeworld/scene/vegetation/trees.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/scene/vegetation/model_mixture.h"
#include "latticeworld/scene/vegetation/patch_noise.h"
#include "latticeworld/scene/vegetation/scatter.h"

namespace latticeworld {
namespace {

// Cover of crowns that a forest's trees see around them before any stand (Canopy comes after them).
constexpr double kForestCanopy = 0.7;
constexpr double kTallestAmongHouses_m = 8.0;

}  // namespace

Stand StandOf(double mean_height_m, double stems_per_m2) {
  constexpr double kSolitary = 40.0, kMostSlender = 100.0;  // height over diameter
  constexpr double kStandDensity = 700.0;                   // stems a hectare of the diameter
  constexpr double kReference_m = 0.254;                    //   of ten inches
  const double thinned_m =
      kReference_m * std::pow(kStandDensity / (stems_per_m2 * kHectare_m2), 1.0 / 1.605);
  const double diameter_m = std::min(mean_height_m / kSolitary, thinned_m);
  Stand stand;
  stand.slenderness = std::min(mean_height_m / diameter_m, kMostSlender);
  stand.height = std::min(1.0, kMostSlender * diameter_m / mean_height_m);
  return stand;
}

void SizeTree(const AssetModel& model, double vigour, double stems_per_m2, PointRandom* random,
              Asset* tree) {
  const Stand stand = StandOf(model.height_m.mean, stems_per_m2);
  // Near their limit of altitude trees are stunted.
  const double stunting = 0.45 + 0.55 * vigour;
  const double height_m = DrawSize(model.height_m, random) * stand.height * stunting;
  const double diameter_m = height_m / stand.slenderness * random->Uniform(0.85, 1.15);
  tree->height_m = static_cast<float>(height_m);
  tree->scale = static_cast<float>(height_m / model.height_m.mean);
  tree->trunk_radius_m = static_cast<float>(0.5 * diameter_m);
  tree->half_length_m = static_cast<float>(model.crown_per_trunk * double{tree->trunk_radius_m});
  tree->half_width_m = tree->half_length_m;
  tree->yaw_rad = static_cast<float>(random->Uniform(-M_PI, M_PI));
}

void PlaceTrees(Placement* placement) {
  const Terrain& terrain = placement->terrain;
  const std::uint64_t seed = StreamSeed(placement->seed, "scene/trees/models");
  ModelMixture mixture(placement->catalogue, placement->environment, AssetKind::kTree,
                       terrain.weights.vocabulary, seed);
  if (terrain.weights.vocabulary == Vocabulary::kSuburb) {
    mixture.Keep(suburb_letter::kBuilding, [](const AssetModel& model) {
      return model.height_m.high <= kTallestAmongHouses_m;
    });
  }
  const PatchNoise thickets(StreamSeed(seed, "thickets"), 30.0);
  const PatchNoise groves(StreamSeed(seed, "groves"), 50.0);
  const double clumping = mixture.clumping();

  // A forest has thickets and glades; on open land trees stand in groups, a few by themselves.
  const ClumpedDensity::Clumping clump = [&](WorldPoint point, char letter) {
    if (letter == class_letter::kForest) {
      return 1.0 + (0.3 + 1.2 * clumping) * (thickets.At(point) - 0.5);
    }
    const double grove = std::max(0.0, groves.At(point) - 0.7) / 0.3;
    return 0.08 + (4.0 + 8.0 * clumping) * grove;
  };
  const ClumpedDensity density(*placement, AssetKind::kTree, clump, [](char letter) {
    return letter == class_letter::kForest ? 1.5 : 8.0;
  });
  const auto make = [&](const ScatterPlace& place, PointRandom* random, Asset* tree) {
    if (!IsSlopeAtMost(terrain, tree->position(), kSteepestForTrees_deg)) return Refusal::kTooSteep;
    const std::optional<ModelMixture::Choice> choice = mixture.At(
        place.point, placement->sites.At(place.point),
        place.letter == class_letter::kForest ? kForestCanopy : 0.0, place.letter, random);
    if (!choice) return Refusal::kHabitat;
    tree->model = choice->model;
    tree->season_variant = choice->season_variant;
    tree->material = choice->material;
    SizeTree(placement->catalogue.models()[choice->model], choice->vigour, place.per_m2, random,
             tree);
    return IsBuildable(terrain, tree->position(), SolidRadius(*tree) + kRoadMargin_m)
               ? Refusal::kNone
               : Refusal::kWaterOrRoad;
  };
  Scatter(placement, AssetKind::kTree, "scene/trees", density, make);
}

}  // namespace latticeworld
