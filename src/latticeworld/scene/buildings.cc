#include <algorithm>
#include <cmath>
#include <optional>

#include "latticeworld/scene/blue_noise.h"
#include "latticeworld/scene/class_areas.h"
#include "latticeworld/scene/densities.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/road_finder.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kLeastWeight = 0.5;         // of the built-up class under a building
constexpr double kRoadsideShare = 0.7;       // of the buildings, at most, is put along roads first
constexpr double kFrontsPerHectare = 200.0;  // places that are tried
constexpr double kVariation_deg = 10.0;      // of the orientation of buildings away from roads
constexpr double kStorey_m = 3.0;

struct Size {
  double half_length_m;  // from the middle to the front wall: along yaw, which faces the road
  double half_width_m;   // half the frontage
  double height_m;
};

Size DrawSize(const EnvironmentConfig& environment, RandomStream* random) {
  const double scale = environment.fine_of(AssetType::kArchitecture).scale;
  Size size;
  size.half_length_m = 0.5 * scale * random->Uniform(7.0, 11.0);
  size.half_width_m = 0.5 * scale * random->Uniform(8.0, 15.0);
  const bool towers = environment.coarse.artistic_style == ArtisticStyle::kCyberpunk;
  const int storeys = towers ? random->UniformInt(4, 14) : random->UniformInt(1, 3);
  constexpr double kRoof_m = 1.5;
  size.height_m = scale * (storeys * kStorey_m + kRoof_m);
  return size;
}

// Places buildings one by one, refusing what the rules forbid.
class Builder {
 public:
  Builder(Placement* placement, const WeightGrid& weight)
      : placement_(placement),
        weight_(weight),
        proto_(MakeAsset(placement->environment, AssetKind::kBuilding)) {}

  bool Build(WorldPoint point, double yaw_rad, const Size& size) {
    const Terrain& terrain = placement_->terrain;
    const GridGeometry& geometry = terrain.geometry();
    if (!geometry.Contains(point) || weight_[geometry.CellAt(point)] < kLeastWeight) return false;
    Asset asset = proto_;
    asset.x_m = static_cast<float>(point.x_m);
    asset.y_m = static_cast<float>(point.y_m);
    asset.yaw_rad = static_cast<float>(std::remainder(yaw_rad, 2.0 * M_PI));
    asset.half_length_m = static_cast<float>(size.half_length_m);
    asset.half_width_m = static_cast<float>(size.half_width_m);
    asset.height_m = static_cast<float>(size.height_m);
    asset.scale =
        static_cast<float>(placement_->environment.fine_of(AssetType::kArchitecture).scale);
    const double radius_m = SolidRadius(asset);
    if (!IsInside(asset, radius_m) ||
        placement_->solids.Overlaps(asset.position(), radius_m + kBuildingGap_m) ||
        !StandsWell(&asset)) {
      return false;
    }
    AddAsset(placement_, asset);
    return true;
  }

 private:
  bool IsInside(const Asset& asset, double radius_m) const {
    const double limit_m = placement_->terrain.geometry().half_size_m() - radius_m;
    return std::abs(asset.x_m) <= limit_m && std::abs(asset.y_m) <= limit_m;
  }

  // Dry, off the road and level enough everywhere below it; sets the base to the lowest ground, so
  // that no corner floats.
  bool StandsWell(Asset* asset) const {
    const Terrain& terrain = placement_->terrain;
    const double step_m = std::clamp(terrain.geometry().resolution_m(), 0.5, 2.0);
    const double reach_x_m = asset->half_length_m + kRoadMargin_m;
    const double reach_y_m = asset->half_width_m + kRoadMargin_m;
    const int steps_x = static_cast<int>(std::ceil(2.0 * reach_x_m / step_m));
    const int steps_y = static_cast<int>(std::ceil(2.0 * reach_y_m / step_m));
    const double cosine = std::cos(asset->yaw_rad), sine = std::sin(asset->yaw_rad);
    double lowest_m = INFINITY;
    for (int i = 0; i <= steps_x; ++i) {
      for (int j = 0; j <= steps_y; ++j) {
        const double along = (2.0 * i / steps_x - 1.0) * reach_x_m;
        const double across = (2.0 * j / steps_y - 1.0) * reach_y_m;
        const WorldPoint point = {asset->x_m + cosine * along - sine * across,
                                  asset->y_m + sine * along + cosine * across};
        if (!IsBuildable(terrain, point, 0.0) ||
            terrain.ground.SlopeAt(point) > kSteepestForBuildings_deg * kDegree) {
          return false;
        }
        lowest_m = std::min(lowest_m, terrain.ground.HeightAt(point));
      }
    }
    asset->z_m = static_cast<float>(lowest_m);
    return true;
  }

  Placement* placement_;
  const WeightGrid& weight_;
  Asset proto_;
};

}  // namespace

void PlaceBuildings(Placement* placement) {
  const Terrain& terrain = placement->terrain;
  const GridGeometry& geometry = terrain.geometry();
  const DensityField density(terrain.weights, placement->environment, AssetKind::kBuilding,
                             placement->thinning);
  const WeightGrid* weight =
      terrain.weights.vocabulary == Vocabulary::kSuburb ? terrain.weights.Find('B') : nullptr;
  if (weight == nullptr || density.largest_per_m2() <= 0.0) return;

  // Larger buildings leave room for fewer.
  const FineAttribute& fine = placement->environment.fine_of(AssetType::kArchitecture);
  const double crowding = std::max(1.0, fine.scale * fine.scale);
  const int wanted = static_cast<int>(std::lround(density.Expected(geometry) / crowding));
  int built = 0;
  Builder builder(placement, *weight);
  const RoadFinder roads(terrain);

  // First along the roads: each place is moved until its front wall keeps a set-back to the road.
  RandomStream roadside(placement->seed, "scene/buildings/roadside");
  constexpr double kHectare_m2 = 10000.0;
  std::vector<WorldPoint> points =
      BlueNoise(geometry.size_m(), kFrontsPerHectare / kHectare_m2, &roadside);
  roadside.Shuffle(&points);
  for (const WorldPoint& point : points) {
    if (built >= kRoadsideShare * wanted) break;
    const Size size = DrawSize(placement->environment, &roadside);
    const double setback_m = roadside.Uniform(3.0, 7.0);
    // Only places in built-up areas are worth the search for a road.
    if ((*weight)[geometry.CellAt(point)] < kLeastWeight) continue;
    const std::optional<RoadFinder::Road> road = roads.Nearest(point);
    if (!road) continue;
    const double move_m = road->distance_m - (size.half_length_m + setback_m);
    const WorldPoint moved = {point.x_m + move_m * std::cos(road->heading_rad),
                              point.y_m + move_m * std::sin(road->heading_rad)};
    if (!geometry.Contains(moved)) continue;
    const std::optional<RoadFinder::Road> front = roads.Nearest(moved);
    if (front && builder.Build(moved, front->heading_rad, size)) ++built;
  }

  // Then the rest over the built-up areas: facing a road within reach, else along their area.
  RandomStream inner(placement->seed, "scene/buildings/inner");
  const ClassAreas areas(geometry, *weight);
  points = BlueNoise(geometry.size_m(), kFrontsPerHectare / kHectare_m2, &inner);
  inner.Shuffle(&points);
  for (const WorldPoint& point : points) {
    if (built >= wanted) break;
    const Size size = DrawSize(placement->environment, &inner);
    const double variation_rad = inner.Uniform(-kVariation_deg, kVariation_deg) * kDegree;
    const int quarter_turns = inner.UniformInt(0, 3);
    const int area = areas.AreaAt(point);
    if (area < 0 || (*weight)[geometry.CellAt(point)] < kLeastWeight) continue;
    double yaw_rad = areas.areas()[area].direction_rad + fine.rotation_deg[2] * kDegree +
                     quarter_turns * 0.5 * M_PI + variation_rad;
    if (const std::optional<RoadFinder::Road> road = roads.Nearest(point)) {
      yaw_rad = road->heading_rad;
    }
    if (builder.Build(point, yaw_rad, size)) ++built;
  }
}

}  // namespace latticeworld
