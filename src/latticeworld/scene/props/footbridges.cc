#include "latticeworld/scene/props/footbridges.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/props/props.h"

namespace latticeworld {
namespace {

constexpr double kPerKm2 = 2.0;
constexpr int kTriesPerKm2 = 4000;
constexpr double kApart_m = 60.0;
constexpr double kNarrowest_m = 3.0, kWidest_m = 12.0;  // of the water
constexpr double kShallowest_m = 0.25;  // of the water in its middle: others are forded
constexpr double kStride_m = 0.25;
constexpr double kWidestBank_m = 5.0;  // from the water's edge to the deck's end
constexpr double kHighest_m = 1.5;     // of the deck above the water
constexpr double kLowest_m = 0.3;
constexpr double kSteepestBeyond_deg = 25.0;
constexpr double kWithoutRoad = 0.1;  // share of the places far from roads that count
constexpr double kNearRoad_m = 40.0;

WorldPoint Along(WorldPoint from, double heading_rad, double way_m) {
  return {from.x_m + way_m * std::cos(heading_rad), from.y_m + way_m * std::sin(heading_rad)};
}

class Finder {
 public:
  explicit Finder(const Terrain& terrain) : terrain_(terrain) {}

  // The bridge that crosses the water at a point, if one can.
  std::optional<Prop> At(WorldPoint point) const {
    const double depth_m = terrain_.WaterDepthAt(point);
    if (depth_m < kShallowest_m) return std::nullopt;
    const double level_m = terrain_.ground.HeightAt(point) + depth_m;
    double heading_rad = 0.0, narrowest_m = INFINITY;
    constexpr int kHeadings = 12;
    for (int i = 0; i < kHeadings; ++i) {
      const double angle_rad = M_PI * i / kHeadings;
      const double width_m = EdgeFrom(point, angle_rad) + EdgeFrom(point, angle_rad + M_PI);
      if (width_m >= narrowest_m) continue;
      narrowest_m = width_m;
      heading_rad = angle_rad;
    }
    if (narrowest_m < kNarrowest_m || narrowest_m > kWidest_m) return std::nullopt;
    return Span(point, heading_rad, level_m);
  }

 private:
  // Way to dry ground; more than kWidest_m where there is none so near.
  double EdgeFrom(WorldPoint point, double heading_rad) const {
    double way_m = 0.0;
    for (; way_m <= kWidest_m; way_m += kStride_m) {
      const WorldPoint at = Along(point, heading_rad, way_m);
      if (!terrain_.geometry().Contains(at)) return 2.0 * kWidest_m;
      if (terrain_.WaterDepthAt(at) <= 0.0) break;
    }
    return way_m;
  }

  // The greatest height above the water that the bank reaches near its edge [m].
  double BankAbove(WorldPoint point, double heading_rad, double edge_m, double level_m) const {
    double above_m = 0.0;
    for (double way_m = edge_m; way_m <= edge_m + kWidestBank_m; way_m += kStride_m) {
      const WorldPoint at = Along(point, heading_rad, way_m);
      if (!terrain_.geometry().Contains(at) || terrain_.WaterDepthAt(at) > 0.0) break;
      above_m = std::max(above_m, terrain_.ground.HeightAt(at) - level_m);
    }
    return above_m;
  }

  // Way to where the bank is that high; the bank is known to get there.
  double WayTo(WorldPoint point, double heading_rad, double edge_m, double height_m) const {
    double way_m = edge_m;
    while (way_m < edge_m + kWidestBank_m &&
           terrain_.ground.HeightAt(Along(point, heading_rad, way_m)) < height_m) {
      way_m += 0.1 * kStride_m;
    }
    return way_m;
  }

  std::optional<Prop> Span(WorldPoint point, double heading_rad, double level_m) const {
    const double back_rad = heading_rad + M_PI;
    const double ahead_m = EdgeFrom(point, heading_rad), behind_m = EdgeFrom(point, back_rad);
    const double above_m = std::min({BankAbove(point, heading_rad, ahead_m, level_m),
                                     BankAbove(point, back_rad, behind_m, level_m), kHighest_m});
    if (above_m < kLowest_m) return std::nullopt;
    const double deck_m = level_m + above_m - 1e-3;
    const double end_m = WayTo(point, heading_rad, ahead_m, deck_m);
    const double begin_m = WayTo(point, back_rad, behind_m, deck_m);
    for (const double beyond_m : {0.5, 1.5, 2.5}) {
      const WorldPoint before = Along(point, back_rad, begin_m + beyond_m);
      const WorldPoint after = Along(point, heading_rad, end_m + beyond_m);
      for (const WorldPoint& at : {before, after}) {
        if (!terrain_.geometry().Contains(at) || terrain_.WaterDepthAt(at) > 0.0 ||
            !IsSlopeAtMost(terrain_, at, kSteepestBeyond_deg)) {
          return std::nullopt;
        }
      }
    }
    Prop bridge = UsualProp(PropKind::kBridge);
    bridge.size_m.x() = begin_m + end_m;
    bridge.mass_kg = UsualMass(bridge.kind, bridge.size_m);
    bridge.strength = UsualStrength(bridge.kind, bridge.size_m);
    bridge.position = Along(point, heading_rad, 0.5 * (end_m - begin_m));
    bridge.yaw_rad = heading_rad;
    return bridge;
  }

  const Terrain& terrain_;
};

}  // namespace

std::optional<Prop> FootbridgeAt(const Terrain& terrain, WorldPoint point) {
  return Finder(terrain).At(point);
}

std::vector<Prop> FindFootbridges(const Terrain& terrain, const RoadFinder& roads,
                                  std::uint64_t seed) {
  RandomStream random(seed, "scene/elements/bridges");
  const GridGeometry& geometry = terrain.geometry();
  const double half_m = geometry.half_size_m();
  const double area_km2 = std::pow(geometry.size_m() / 1000.0, 2);
  const auto most = static_cast<std::size_t>(std::max(1.0, std::round(kPerKm2 * area_km2)));
  const int tries = static_cast<int>(kTriesPerKm2 * std::max(0.1, area_km2));
  const Finder finder(terrain);
  std::vector<Prop> bridges;
  for (int i = 0; i < tries && bridges.size() < most; ++i) {
    const WorldPoint point = {random.Uniform(-half_m, half_m), random.Uniform(-half_m, half_m)};
    const bool anywhere = random.Chance(kWithoutRoad);
    const bool apart = std::none_of(bridges.begin(), bridges.end(), [&](const Prop& other) {
      return std::hypot(other.position.x_m - point.x_m, other.position.y_m - point.y_m) < kApart_m;
    });
    if (!apart) continue;
    const std::optional<Prop> bridge = finder.At(point);
    if (!bridge) continue;
    const std::optional<RoadFinder::Road> road = roads.Nearest(point);
    if (!anywhere && (!road || road->distance_m > kNearRoad_m)) continue;
    bridges.push_back(*bridge);
  }
  return bridges;
}

}  // namespace latticeworld
