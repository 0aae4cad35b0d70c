// Kinds that are scattered by blue noise, thinned to the density of the place.

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/blue_noise.h"
#include "latticeworld/scene/densities.h"
#include "latticeworld/scene/placement.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;

// Steepest ground that each kind stands on.
constexpr double kSteepestForTrees_deg = 40.0;
constexpr double kSteepestForStones_deg = 50.0;
constexpr double kSteepestForGroundCover_deg = 45.0;

// Calls place(point) for points as dense as the kind is there: a Poisson-disk set of the largest
// density, of which each point stays with the probability of its cell. Both draw from the stream
// in a fixed order, whatever is refused later, so that what stands elsewhere moves nothing here.
template <typename Place>
void Scatter(const Placement& placement, AssetKind kind, RandomStream* random, Place&& place) {
  const GridGeometry& geometry = placement.terrain.geometry();
  const DensityField density(placement.terrain.weights, placement.environment, kind,
                             placement.thinning);
  if (density.largest_per_m2() <= 0.0) return;
  for (const WorldPoint& point : BlueNoise(geometry.size_m(), density.largest_per_m2(), random)) {
    const double draw = random->Uniform() * density.largest_per_m2();
    if (draw < density.per_m2_At(geometry.CellAt(point))) place(point);
  }
}

bool IsSlopeAtMost(const Terrain& terrain, WorldPoint point, double limit_deg) {
  return terrain.ground.SlopeAt(point) <= limit_deg * kDegree;
}

Asset StandAt(Asset asset, const Terrain& terrain, WorldPoint point) {
  asset.x_m = static_cast<float>(point.x_m);
  asset.y_m = static_cast<float>(point.y_m);
  asset.z_m = static_cast<float>(terrain.ground.HeightAt(asset.position()));
  return asset;
}

void AddSolid(Placement* placement, const Asset& asset, double margin_m, double limit_deg) {
  const double radius_m = SolidRadius(asset);
  if (!IsSlopeAtMost(placement->terrain, asset.position(), limit_deg) ||
      !IsBuildable(placement->terrain, asset.position(), radius_m + margin_m) ||
      placement->solids.Overlaps(asset.position(), radius_m)) {
    return;
  }
  AddAsset(placement, asset);
}

// A kind of ground cover: height and radius drawn around a mean.
struct CoverSize {
  double low_m, high_m;        // of the height
  double radius_per_height_m;  // [m/m]
  double typical_height_m;     // that scale 1 stands for
};

void PlaceCover(Placement* placement, const AssetIndex& solids, AssetKind kind,
                const CoverSize& size, const char* stream_name) {
  RandomStream random(placement->seed, stream_name);
  const Asset proto = MakeAsset(placement->environment, kind);
  Scatter(*placement, kind, &random, [&](WorldPoint point) {
    Asset asset = StandAt(proto, placement->terrain, point);
    asset.yaw_rad = static_cast<float>(random.Uniform(-M_PI, M_PI));
    asset.height_m = static_cast<float>(random.Uniform(size.low_m, size.high_m));
    asset.scale = static_cast<float>(asset.height_m / size.typical_height_m);
    asset.half_length_m =
        static_cast<float>(asset.height_m * size.radius_per_height_m * random.Uniform(0.8, 1.2));
    asset.half_width_m = asset.half_length_m;
    if (IsSlopeAtMost(placement->terrain, asset.position(), kSteepestForGroundCover_deg) &&
        IsBuildable(placement->terrain, asset.position(), 0.0) &&
        IsFreeOfSolids(*placement, solids, asset.position())) {
      AddAsset(placement, asset);
    }
  });
}

}  // namespace

void PlaceTrees(Placement* placement) {
  RandomStream random(placement->seed, "scene/trees");
  const Asset proto = MakeAsset(placement->environment, AssetKind::kTree);
  constexpr double kMeanHeight_m = 14.0, kDeviation_m = 4.0;
  constexpr double kLowest_m = 4.0, kHighest_m = 28.0;
  Scatter(*placement, AssetKind::kTree, &random, [&](WorldPoint point) {
    Asset asset = StandAt(proto, placement->terrain, point);
    const double height_m =
        std::clamp(random.Normal(kMeanHeight_m, kDeviation_m), kLowest_m, kHighest_m);
    asset.height_m = static_cast<float>(height_m);
    asset.scale = static_cast<float>(height_m / kMeanHeight_m);
    // Elastic similarity (McMahon 1973, Size and Shape in Biology): trees stand at a quarter of the
    // height at which they would buckle, height = 23.6 diameter^(2/3), and vary around that.
    const double diameter_m = std::pow(height_m / 23.6, 1.5) * random.Uniform(0.85, 1.15);
    asset.trunk_radius_m = static_cast<float>(0.5 * diameter_m);
    asset.half_length_m = static_cast<float>(height_m * random.Uniform(0.14, 0.24));
    asset.half_width_m = asset.half_length_m;
    asset.yaw_rad = static_cast<float>(random.Uniform(-M_PI, M_PI));
    AddSolid(placement, asset, kRoadMargin_m, kSteepestForTrees_deg);
  });
}

void PlaceStones(Placement* placement) {
  RandomStream random(placement->seed, "scene/stones");
  const Asset proto = MakeAsset(placement->environment, AssetKind::kStone);
  constexpr double kTypicalRadius_m = 0.5;
  Scatter(*placement, AssetKind::kStone, &random, [&](WorldPoint point) {
    Asset asset = StandAt(proto, placement->terrain, point);
    // Few large ones among many small ones: log-normal.
    const double radius_m =
        std::clamp(kTypicalRadius_m * std::exp(random.Normal(0.0, 0.5)), 0.15, 2.0);
    asset.half_length_m = static_cast<float>(radius_m);
    asset.half_width_m = asset.half_length_m;
    asset.height_m = static_cast<float>(radius_m * random.Uniform(0.7, 1.4));
    asset.scale = static_cast<float>(radius_m / kTypicalRadius_m);
    asset.yaw_rad = static_cast<float>(random.Uniform(-M_PI, M_PI));
    AddSolid(placement, asset, kRoadMargin_m, kSteepestForStones_deg);
  });
}

void PlaceBushes(Placement* placement, const AssetIndex& solids) {
  PlaceCover(placement, solids, AssetKind::kBush, {0.4, 2.0, 0.55, 1.2}, "scene/bushes");
}

void PlaceFlowers(Placement* placement, const AssetIndex& solids) {
  PlaceCover(placement, solids, AssetKind::kFlower, {0.1, 0.5, 0.4, 0.3}, "scene/flowers");
}

void PlaceGrassTufts(Placement* placement, const AssetIndex& solids) {
  PlaceCover(placement, solids, AssetKind::kGrassTuft, {0.15, 0.7, 0.6, 0.4}, "scene/grass");
}

void PlaceDeadBranches(Placement* placement, const AssetIndex& solids) {
  RandomStream random(placement->seed, "scene/dead_branches");
  const Asset proto = MakeAsset(placement->environment, AssetKind::kDeadBranch);
  const DensityField branches(placement->terrain.weights, placement->environment,
                              AssetKind::kDeadBranch, placement->thinning);
  const DensityField trees(placement->terrain.weights, placement->environment, AssetKind::kTree,
                           placement->thinning);
  const GridGeometry& geometry = placement->terrain.geometry();
  const std::size_t standing = placement->assets.size();
  for (std::size_t i = 0; i < standing; ++i) {
    if (placement->assets[i].kind != AssetKind::kTree) continue;
    const Asset tree = placement->assets[i];  // a copy: the vector grows below
    const CellIndex cell = geometry.CellAt(tree.position());
    const double trees_per_m2 = trees.per_m2_At(cell);
    const double per_tree =
        trees_per_m2 > 0.0 ? std::min(1.0, branches.per_m2_At(cell) / trees_per_m2) : 0.0;
    if (!random.Chance(per_tree)) continue;
    // Fallen between the trunk and the edge of the crown.
    const double distance_m = random.Uniform(tree.trunk_radius_m + 0.3, tree.half_length_m + 0.3);
    const double angle_rad = random.Uniform(-M_PI, M_PI);
    const WorldPoint point = {tree.x_m + distance_m * std::cos(angle_rad),
                              tree.y_m + distance_m * std::sin(angle_rad)};
    Asset asset = StandAt(proto, placement->terrain, point);
    asset.half_length_m = static_cast<float>(random.Uniform(0.3, 1.2));
    asset.half_width_m = asset.half_length_m;
    asset.height_m = static_cast<float>(random.Uniform(0.05, 0.2));
    asset.scale = asset.half_length_m / 0.75f;
    asset.yaw_rad = static_cast<float>(random.Uniform(-M_PI, M_PI));
    if (IsBuildable(placement->terrain, asset.position(), 0.0) &&
        IsFreeOfSolids(*placement, solids, asset.position())) {
      AddAsset(placement, asset);
    }
  }
}

}  // namespace latticeworld
