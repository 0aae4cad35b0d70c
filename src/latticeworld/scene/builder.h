#ifndef LATTICEWORLD_SCENE_BUILDER_H_
#define LATTICEWORLD_SCENE_BUILDER_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/settlements/building_models.h"
#include "latticeworld/scene/settlements/settlement_map.h"
#include "latticeworld/scene/vegetation/model_mixture.h"

namespace latticeworld {

// A building that is to stand somewhere.
struct BuildingPlan {
  BuildingUse use = BuildingUse::kDetachedHouse;
  Footprint footprint;
  double height_m = 0.0;
  int terrace = -1;  // houses of one terrace may touch; -1: stands alone
};

// A building that stands.
struct Built {
  BuildingPlan plan;
  int settlement = 0;
};

// Builds one by one what the rules of settlement_rules.h allow, and refuses the rest.
class Builder {
 public:
  Builder(Placement* placement, const SettlementMap& map);

  const BuildingModels& models() const { return models_; }
  const std::vector<Built>& built() const { return built_; }

  // Whether the building may stand, with the reason against it counted.
  bool Fits(const BuildingPlan& plan) { return AssetOf(plan).has_value(); }
  // Adds the building; false: it may not stand.
  bool Build(const BuildingPlan& plan, PointRandom* random);
  // Whether the walls of every building are at least that far from the rectangle; those of the
  // terrace may touch it.
  bool IsClear(const Footprint& footprint, double gap_m, int terrace) const;

 private:
  // Calls visit(built) for the buildings whose circles come within reach_m of the rectangle's,
  // until one returns true; whether one did.
  template <typename Visit>
  bool AnyNear(const Footprint& footprint, double reach_m, Visit&& visit) const;
  // The building as it would stand, nullopt: it may not.
  std::optional<Asset> AssetOf(const BuildingPlan& plan);
  bool IsInside(const Footprint& footprint) const;
  // Dry, off the road, level enough: the lowest ground below it [m], NaN: not.
  double BaseOf(const Footprint& footprint) const;
  int BucketOf(double coordinate_m) const;

  Placement* placement_;
  const SettlementMap& map_;
  BuildingModels models_;
  ModelMixture mixture_;
  const WeightGrid* weight_;
  std::vector<Built> built_;
  Grid<std::vector<int>> buckets_;  // indices into built_, by their centres
  double largest_radius_m_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_BUILDER_H_
