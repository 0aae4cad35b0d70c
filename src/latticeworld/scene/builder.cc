#include "latticeworld/scene/builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/scene/settlements/settlement_rules.h"

namespace latticeworld {
namespace {

constexpr double kBucket_m = 32.0;
constexpr double kLevelBeside_m = 0.5;  // of the walls
constexpr double kTouching_m = 0.01;    // what rounding takes from houses that touch

double LeastBuiltUpOf(BuildingUse use) {
  return use == BuildingUse::kBarn || use == BuildingUse::kShed ? kLeastBuiltUpOfBarns
                                                                : kLeastBuiltUp;
}

}  // namespace

Builder::Builder(Placement* placement, const SettlementMap& map)
    : placement_(placement),
      map_(map),
      models_(placement->catalogue, placement->environment.fine_of(AssetType::kArchitecture).scale),
      mixture_(placement->catalogue, placement->environment, AssetKind::kBuilding,
               placement->terrain.weights.vocabulary,
               StreamSeed(placement->seed, "scene/buildings/models")),
      weight_(placement->terrain.weights.Find(suburb_letter::kBuilding)) {
  const int buckets =
      std::max(1, static_cast<int>(placement->terrain.geometry().size_m() / kBucket_m));
  buckets_ = Grid<std::vector<int>>(buckets, buckets);
}

int Builder::BucketOf(double coordinate_m) const {
  const double half_m = placement_->terrain.geometry().half_size_m();
  const double bucket = (coordinate_m + half_m) / (2.0 * half_m) * buckets_.rows();
  return static_cast<int>(std::clamp(bucket, 0.0, buckets_.rows() - 1.0));
}

template <typename Visit>
bool Builder::AnyNear(const Footprint& footprint, double reach_m, Visit&& visit) const {
  const double near_m = footprint.radius_m() + reach_m, most_m = near_m + largest_radius_m_;
  const WorldPoint centre = footprint.centre;
  const int row_end = BucketOf(centre.y_m + most_m), col_end = BucketOf(centre.x_m + most_m);
  for (int row = BucketOf(centre.y_m - most_m); row <= row_end; ++row) {
    for (int col = BucketOf(centre.x_m - most_m); col <= col_end; ++col) {
      for (const int i : buckets_(row, col)) {
        const Footprint& other = built_[i].plan.footprint;
        const double dx = other.centre.x_m - centre.x_m, dy = other.centre.y_m - centre.y_m;
        const double within_m = near_m + other.radius_m();
        if (dx * dx + dy * dy <= within_m * within_m && visit(built_[i])) return true;
      }
    }
  }
  return false;
}

bool Builder::IsClear(const Footprint& footprint, double gap_m, int terrace) const {
  const double radius_m = footprint.radius_m();
  const double inscribed_m = std::min(footprint.half_length_m, footprint.half_width_m);
  return !AnyNear(footprint, gap_m, [&](const Built& other) {
    if (terrace >= 0 && other.plan.terrace == terrace) {
      return GapBetween(footprint, other.plan.footprint) < -kTouching_m;
    }
    // The circles around and in the rectangle mostly tell.
    const double to_centre_m = GapTo(other.plan.footprint, footprint.centre);
    if (to_centre_m >= gap_m + radius_m) return false;
    if (to_centre_m < gap_m + inscribed_m) return true;
    return GapBetween(footprint, other.plan.footprint) < gap_m;
  });
}

bool Builder::IsInside(const Footprint& footprint) const {
  const double limit_m = placement_->terrain.geometry().half_size_m() - footprint.radius_m();
  return std::abs(footprint.centre.x_m) <= limit_m && std::abs(footprint.centre.y_m) <= limit_m;
}

double Builder::BaseOf(const Footprint& footprint) const {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  const Terrain& terrain = placement_->terrain;
  const double step_m = std::clamp(terrain.geometry().resolution_m(), 0.5, 2.0);
  const double reach_x_m = footprint.half_length_m + kLeastSetback_m;
  const double reach_y_m = footprint.half_width_m + kLeastSetback_m;
  const int steps_x = static_cast<int>(std::ceil(2.0 * reach_x_m / step_m));
  const int steps_y = static_cast<int>(std::ceil(2.0 * reach_y_m / step_m));
  // Relief is measured from wall to wall: the steps between terraces are steep, but low.
  const double most_relief_m =
      std::min(kMostReliefBelow_m, std::tan(kSteepestForBuildings_deg * M_PI / 180.0) * 2.0 *
                                       std::min(footprint.half_length_m, footprint.half_width_m));
  Tally::Kind& tally = placement_->tally.Of(AssetKind::kBuilding);
  double lowest_m = INFINITY, highest_m = -INFINITY;
  const double cosine = std::cos(footprint.yaw_rad), sine = std::sin(footprint.yaw_rad);
  for (int i = 0; i <= steps_x; ++i) {
    for (int j = 0; j <= steps_y; ++j) {
      const double along_m = (2.0 * i / steps_x - 1.0) * reach_x_m;
      const double left_m = (2.0 * j / steps_y - 1.0) * reach_y_m;
      const WorldPoint point = {footprint.centre.x_m + cosine * along_m - sine * left_m,
                                footprint.centre.y_m + sine * along_m + cosine * left_m};
      if (!IsBuildable(terrain, point, 0.0)) {
        tally.Refuse(Refusal::kWaterOrRoad);
        return kNowhere;
      }
      // Embankments and the steps between terraces may begin a little beside the walls.
      const double off_x_m = std::max(0.0, std::abs(along_m) - footprint.half_length_m);
      const double off_y_m = std::max(0.0, std::abs(left_m) - footprint.half_width_m);
      if (off_x_m * off_x_m + off_y_m * off_y_m > kLevelBeside_m * kLevelBeside_m) continue;
      const double height_m = terrain.ground.HeightAt(point);
      lowest_m = std::min(lowest_m, height_m);
      highest_m = std::max(highest_m, height_m);
      if (highest_m - lowest_m > most_relief_m) {
        tally.Refuse(Refusal::kTooSteep);
        return kNowhere;
      }
    }
  }
  return lowest_m;
}

std::optional<Asset> Builder::AssetOf(const BuildingPlan& plan) {
  const Terrain& terrain = placement_->terrain;
  // The numbers are as the asset stores them, so that what is checked is what stands.
  Asset asset;
  asset.kind = AssetKind::kBuilding;
  asset.x_m = static_cast<float>(plan.footprint.centre.x_m);
  asset.y_m = static_cast<float>(plan.footprint.centre.y_m);
  asset.yaw_rad = static_cast<float>(std::remainder(plan.footprint.yaw_rad, 2.0 * M_PI));
  asset.half_length_m = static_cast<float>(plan.footprint.half_length_m);
  asset.half_width_m = static_cast<float>(plan.footprint.half_width_m);
  asset.height_m = static_cast<float>(plan.height_m);
  asset.scale = static_cast<float>(placement_->environment.fine_of(AssetType::kArchitecture).scale);
  const Footprint footprint = FootprintOf(asset);
  if (!IsInside(footprint) ||
      (*weight_)[terrain.geometry().CellAt(asset.position())] < LeastBuiltUpOf(plan.use)) {
    return std::nullopt;
  }
  if (!IsClear(footprint, kLeastWallGap_m, plan.terrace)) {
    placement_->tally.Of(AssetKind::kBuilding).Refuse(Refusal::kOccupied);
    return std::nullopt;
  }
  const double base_m = BaseOf(footprint);
  if (std::isnan(base_m)) return std::nullopt;
  // The lowest ground, so that no corner floats.
  asset.z_m = static_cast<float>(base_m);
  return asset;
}

bool Builder::Build(const BuildingPlan& plan, PointRandom* random) {
  std::optional<Asset> asset = AssetOf(plan);
  if (!asset) return false;
  const ModelMixture::Choice choice = mixture_.Dress(models_.ModelOf(plan.use), random);
  asset->model = choice.model;
  asset->season_variant = choice.season_variant;
  asset->material = choice.material;
  AddAsset(placement_, *asset);
  BuildingPlan standing = plan;
  standing.footprint = FootprintOf(*asset);
  buckets_(BucketOf(asset->y_m), BucketOf(asset->x_m)).push_back(static_cast<int>(built_.size()));
  built_.push_back({standing, map_.At(asset->position())});
  largest_radius_m_ = std::max(largest_radius_m_, standing.footprint.radius_m());
  return true;
}

}  // namespace latticeworld
