#include "latticeworld/scene/settlements/gardens.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/scene/vegetation/scatter.h"
#include "latticeworld/scene/vegetation/trees.h"

namespace latticeworld {
namespace {

constexpr double kHedgeSpacing_m = 1.9;
constexpr double kHedgeRoom_m = 0.25;  // kept free around each bush of a hedge
constexpr double kHedgeToWall_m = 1.0;
constexpr double kHedgeHeight_m = 1.4;
constexpr double kTreeToWall_m = 3.2;
constexpr double kCrownToWall = 0.8;  // of the crown's radius: few branches over roofs
constexpr double kFlowerToWall_m = 0.5;
constexpr double kFlowerRoom_m = 0.05;
constexpr float kLeastBuiltUpOfGardens = 0.35f;
constexpr double kStemsPerM2 = 0.01;  // as a tree of a garden grows: freely

// Plants of one kind with a stream of their own.
class Planter {
 public:
  Planter(Placement* placement, AssetKind kind, std::string_view stream)
      : placement_(placement),
        kind_(kind),
        seed_(StreamSeed(placement->seed, stream)),
        mixture_(placement->catalogue, placement->environment, kind,
                 placement->terrain.weights.vocabulary, seed_),
        thinning_(placement->thinning[kind]),
        density_(placement->environment.fine_of(TypeOf(kind)).density * thinning_) {}

  PointRandom RandomOf(std::size_t garden) const { return PointRandom(seed_, garden); }
  double thinning() const { return thinning_; }
  double density() const { return density_; }  // thinned

  // The model of that name, or else the one that the environment's values call for.
  std::uint8_t ModelNamed(std::string_view name) const {
    for (const std::uint8_t model : placement_->catalogue.models_of(kind_)) {
      if (placement_->catalogue.models()[model].name == name) return model;
    }
    return MakeAsset(*placement_, kind_).model;
  }
  std::uint8_t UsualModel() const { return MakeAsset(*placement_, kind_).model; }

  // Makes an asset of the model at the point, without adding it.
  Asset Make(std::uint8_t model, WorldPoint point, PointRandom* random) const {
    const ModelMixture::Choice choice = mixture_.Dress(model, random);
    const AssetModel& data = placement_->catalogue.models()[model];
    const double growth =
        placement_->catalogue.season_variants(TypeOf(kind_))[choice.season_variant].growth;
    Asset asset;
    asset.kind = kind_;
    asset.model = choice.model;
    asset.season_variant = choice.season_variant;
    asset.material = choice.material;
    StandAt(placement_->terrain, point, &asset);
    if (kind_ == AssetKind::kTree) {
      SizeTree(data, choice.vigour, kStemsPerM2, random, &asset);
      return asset;
    }
    const double full_m = DrawSize(data.height_m, random);
    asset.height_m = static_cast<float>(full_m * growth);
    asset.scale = static_cast<float>(full_m / data.height_m.mean);
    asset.half_length_m = static_cast<float>(full_m * DrawSize(data.spread, random));
    asset.half_width_m = asset.half_length_m;
    asset.yaw_rad = static_cast<float>(random->Uniform(-M_PI, M_PI));
    return asset;
  }

 private:
  Placement* placement_;
  AssetKind kind_;
  std::uint64_t seed_;
  ModelMixture mixture_;
  double thinning_;
  double density_;
};

bool HasGarden(BuildingUse use) {
  return use == BuildingUse::kDetachedHouse || use == BuildingUse::kRowHouse ||
         use == BuildingUse::kFarmhouse;
}

class Gardener {
 public:
  Gardener(const Builder& builder, Placement* placement)
      : builder_(builder),
        placement_(placement),
        hedges_(placement, AssetKind::kBush, "scene/gardens/hedges"),
        trees_(placement, AssetKind::kTree, "scene/gardens/trees"),
        flowers_(placement, AssetKind::kFlower, "scene/gardens/flowers"),
        weight_(placement->terrain.weights.Find(suburb_letter::kBuilding)) {}

  void Plant() {
    // Every hedge before any tree: a tree may stand on no hedge.
    const std::vector<Built>& built = builder_.built();
    for (std::size_t i = 0; i < built.size(); ++i) {
      if (HasGarden(built[i].plan.use)) PlantHedge(i, built[i].plan);
    }
    for (std::size_t i = 0; i < built.size(); ++i) {
      if (!HasGarden(built[i].plan.use)) continue;
      PlantTrees(i, built[i].plan);
      PlantFlowers(i, built[i].plan);
    }
  }

 private:
  // Whether something of that radius may stand at the point.
  bool IsFree(WorldPoint point, double radius_m, double to_wall_m) const {
    const Terrain& terrain = placement_->terrain;
    if (!IsBuildable(terrain, point, radius_m + kRoadMargin_m)) return false;
    if ((*weight_)[terrain.geometry().CellAt(point)] < kLeastBuiltUpOfGardens) return false;
    const Footprint spot = {point, 0.0, 1e-3, 1e-3};
    return builder_.IsClear(spot, to_wall_m, -1);
  }
  // No hedge, trunk or the like overlaps the circle. Buildings are asked for by their walls, and
  // not by the circles that placement->solids knows of them.
  bool IsUnplanted(WorldPoint point, double radius_m) const {
    return !planted_.Overlaps(point, radius_m);
  }

  // Plants a hedge behind and on one side of the house.
  void PlantHedge(std::size_t garden, const BuildingPlan& plan) {
    PointRandom random = hedges_.RandomOf(garden);
    const Footprint& house = plan.footprint;
    const double depth_m = random.Uniform(9.0, 15.0);
    const double side_m =
        plan.terrace >= 0 ? house.half_width_m : house.half_width_m + random.Uniform(2.2, 3.5);
    const bool left = random.Chance(0.5), hedged = random.Chance(0.75 * hedges_.thinning());
    const std::uint8_t model =
        random.Chance(0.3) ? hedges_.UsualModel() : hedges_.ModelNamed("hazel");
    if (!hedged) return;
    const double back_m = -house.half_length_m - depth_m;
    const auto plant = [&](double along_m, double left_m) {
      const WorldPoint point =
          house.At(along_m + random.Uniform(-0.15, 0.15), left_m + random.Uniform(-0.15, 0.15));
      Asset bush = hedges_.Make(model, point, &random);
      // Cut to one height.
      const auto cut =
          static_cast<float>(kHedgeHeight_m * random.Uniform(0.85, 1.15)) / bush.height_m;
      bush.height_m *= cut;
      bush.scale *= cut;
      bush.half_length_m *= cut;
      bush.half_width_m *= cut;
      if (!IsFree(point, kHedgeRoom_m, kHedgeToWall_m) ||
          !IsUnplanted(point, 0.4 * kHedgeSpacing_m)) {
        return;
      }
      planted_.Add(point, 0.4 * kHedgeSpacing_m);
      placement_->solids.Add(point, kHedgeRoom_m);
      if (hedges_.density() > 0.0) AddAsset(placement_, bush);
    };
    const double sign = left ? 1.0 : -1.0;
    for (double at_m = -side_m; at_m <= side_m; at_m += kHedgeSpacing_m) plant(back_m, at_m);
    for (double at_m = back_m + kHedgeSpacing_m; at_m < house.half_length_m;
         at_m += kHedgeSpacing_m) {
      plant(at_m, sign * side_m);
    }
  }

  void PlantTrees(std::size_t garden, const BuildingPlan& plan) {
    PointRandom random = trees_.RandomOf(garden);
    const Footprint& house = plan.footprint;
    for (int i = 0; i < 2; ++i) {
      const double along_m = -house.half_length_m - random.Uniform(4.0, 12.0);
      const double left_m = random.Uniform(-1.1, 1.1) * (house.half_width_m + 1.5);
      const WorldPoint point = house.At(along_m, left_m);
      const std::uint8_t model =
          random.Chance(0.85) ? trees_.ModelNamed("fruit tree") : trees_.UsualModel();
      const bool grows = random.Chance(std::min(1.0, 1.4 * trees_.density()));
      const Asset tree = trees_.Make(model, point, &random);
      if (!grows ||
          !IsFree(point, SolidRadius(tree),
                  std::max(kTreeToWall_m, kCrownToWall * tree.half_length_m)) ||
          !IsUnplanted(point, SolidRadius(tree) + 0.8)) {
        continue;
      }
      planted_.Add(point, 2.0);
      AddAsset(placement_, tree);
    }
  }

  // A bed below the front windows.
  void PlantFlowers(std::size_t garden, const BuildingPlan& plan) {
    PointRandom random = flowers_.RandomOf(garden);
    const Footprint& house = plan.footprint;
    const std::uint8_t model = flowers_.UsualModel();
    for (double left_m = -house.half_width_m + 0.8; left_m < house.half_width_m - 0.5;
         left_m += 0.9) {
      const WorldPoint point = house.At(house.half_length_m + random.Uniform(0.6, 1.3),
                                        left_m + random.Uniform(-0.2, 0.2));
      const bool grows = random.Chance(flowers_.density());
      const Asset flower = flowers_.Make(model, point, &random);
      if (!IsFree(point, kFlowerRoom_m, kFlowerToWall_m) || !IsUnplanted(point, 0.3)) continue;
      placement_->solids.Add(point, kFlowerRoom_m);
      if (grows) AddAsset(placement_, flower);
    }
  }

  const Builder& builder_;
  Placement* placement_;
  Planter hedges_, trees_, flowers_;
  const WeightGrid* weight_;
  SolidSet planted_ = SolidSet(placement_->terrain.geometry().size_m());
};

}  // namespace

void PlantGardens(const Builder& builder, Placement* placement) {
  Gardener(builder, placement).Plant();
}

}  // namespace latticeworld
