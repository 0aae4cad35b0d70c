#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/vegetation/model_mixture.h"
#include "latticeworld/scene/vegetation/scatter.h"

namespace latticeworld {
namespace {

// A number for where it stands, to the millimetre: what stands elsewhere, or comes before it among
// the assets, changes no draw.
std::uint64_t PlaceOf(const Asset& asset) {
  const auto x_mm = static_cast<std::int64_t>(std::lround(1000.0 * asset.x_m));
  const auto y_mm = static_cast<std::int64_t>(std::lround(1000.0 * asset.y_m));
  return static_cast<std::uint64_t>(x_mm) << 32 ^ (static_cast<std::uint64_t>(y_mm) & 0xffffffffu);
}

}  // namespace

void PlaceDeadBranches(Placement* placement, const AssetIndex& solids) {
  const Terrain& terrain = placement->terrain;
  const GridGeometry& geometry = terrain.geometry();
  const DensityField branches = DensityFor(*placement, AssetKind::kDeadBranch);
  const DensityField trees = DensityFor(*placement, AssetKind::kTree);
  if (branches.largest_per_m2() <= 0.0) return;
  const std::uint64_t seed = StreamSeed(placement->seed, "scene/dead_branches");
  const ModelMixture mixture(placement->catalogue, placement->environment, AssetKind::kDeadBranch,
                             terrain.weights.vocabulary, seed);
  const double turn_rad =
      placement->environment.fine_of(AssetType::kDeadBranch).rotation_deg[2] * M_PI / 180.0;
  Tally::Kind& tally = placement->tally.Of(AssetKind::kDeadBranch);

  // Below every so many trees lies one, so that no more can lie than there are trees for.
  tally.wanted = 0.0;
  const std::size_t standing = placement->assets.size();
  for (std::size_t i = 0; i < standing; ++i) {
    if (placement->assets[i].kind != AssetKind::kTree) continue;
    const Asset tree = placement->assets[i];  // a copy: the vector grows below
    PointRandom random(seed, PlaceOf(tree));
    const CellIndex cell = geometry.CellAt(tree.position());
    const double trees_per_m2 = trees.per_m2_At(cell);
    const double per_tree =
        trees_per_m2 > 0.0 ? std::min(1.0, branches.per_m2_At(cell) / trees_per_m2) : 0.0;
    tally.wanted += per_tree;
    if (!random.Chance(per_tree)) continue;
    // Fallen between the trunk and the edge of the crown.
    const double distance_m = random.Uniform(tree.trunk_radius_m + 0.3, tree.half_length_m + 0.3);
    const double angle_rad = random.Uniform(-M_PI, M_PI);
    Asset branch;
    branch.kind = AssetKind::kDeadBranch;
    StandAt(
        terrain,
        {tree.x_m + distance_m * std::cos(angle_rad), tree.y_m + distance_m * std::sin(angle_rad)},
        &branch);
    if (!IsBuildable(terrain, branch.position(), 0.0)) {
      tally.Refuse(Refusal::kWaterOrRoad);
      continue;
    }
    if (!IsFreeOfSolids(*placement, solids, branch.position())) {
      tally.Refuse(Refusal::kOccupied);
      continue;
    }
    const std::optional<ModelMixture::Choice> choice =
        mixture.At(branch.position(), placement->sites.At(branch.position()),
                   placement->canopy.At(branch.position()),
                   terrain.weights.DominantAt(geometry.CellAt(branch.position())), &random);
    if (!choice) {
      tally.Refuse(Refusal::kHabitat);
      continue;
    }
    const AssetModel& model = placement->catalogue.models()[choice->model];
    branch.model = choice->model;
    branch.season_variant = choice->season_variant;
    branch.material = choice->material;
    branch.height_m = static_cast<float>(DrawSize(model.height_m, &random));
    branch.scale = static_cast<float>(branch.height_m / model.height_m.mean);
    branch.half_length_m = static_cast<float>(branch.height_m * DrawSize(model.spread, &random));
    branch.half_width_m = branch.half_length_m;
    branch.yaw_rad =
        static_cast<float>(std::remainder(random.Uniform(-M_PI, M_PI) + turn_rad, 2.0 * M_PI));
    AddAsset(placement, branch);
  }
}

}  // namespace latticeworld
