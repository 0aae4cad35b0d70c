// Ways over the bridges of roads.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "latticeworld/navigation/distance_field.h"
#include "latticeworld/navigation/navigable_map.h"
#include "latticeworld/navigation/surface_path.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kBed_m = -5.0;
constexpr double kDeck_m = 0.01;

// A gorge 20 m wide from north to south with walls that nobody climbs, and the bridge of a road
// over it along x.
std::shared_ptr<const Scene> Gorge() {
  TestScene made;
  made.cells = 256;
  made.height_m = [](double x, double) { return std::abs(x) < 10.0 ? kBed_m : 0.0; };
  auto scene = std::make_shared<Scene>(*made.Build());
  auto terrain = std::make_shared<Terrain>(*scene->terrain);
  Bridge bridge;
  bridge.line = {{-13.0, 0.0}, {13.0, 0.0}};
  bridge.width_m = 5.0;
  bridge.deck_z_m = kDeck_m;
  bridge.thickness_m = 0.4;
  bridge.water_level_m = kBed_m;
  bridge.railing_m = 1.0;
  bridge.load_kg = 3500.0;
  bridge.supports_m = {3.0, 13.0, 23.0};
  terrain->bridges = {bridge};
  scene->terrain = std::move(terrain);
  return scene;
}

RobotLimits OfMass(double mass_kg) {
  RobotLimits limits;
  limits.mass_kg = mass_kg;
  return limits;
}

TEST(BridgeWayTest, TheShortestPathLeadsOverTheDeck) {
  const NavigableMap map = BuildNavigableMap(*Gorge(), OfMass(50.0));
  const WorldPoint start{-20.0, 12.0}, goal{20.0, -12.0};
  const DistanceField field = DistancesTo(map, goal).value();
  const SurfacePath path = PathDown(map, field, start).value();
  // By the railings' ends at best.
  const double straight_m = std::hypot(40.0, 24.0);
  EXPECT_GE(path.length_m, straight_m - 0.1);
  EXPECT_LT(path.length_m, straight_m + 4.0);
  EXPECT_LT(path.climb_m, 0.1) << "the deck is level: nothing leads through the gorge";
  for (const Eigen::Vector3d& point : path.points_m) {
    if (std::abs(point.x()) > 10.0) continue;
    EXPECT_LT(std::abs(point.y()), 2.5);
    EXPECT_NEAR(point.z(), kDeck_m, 0.02);
  }
  EXPECT_NEAR(field.At(start), path.length_m, 0.02 * path.length_m);
}

TEST(BridgeWayTest, WhoIsTooHeavyHasNoWayOver) {
  const NavigableMap map = BuildNavigableMap(*Gorge(), OfMass(5000.0));
  const DistanceField field = DistancesTo(map, {20.0, -12.0}).value();
  EXPECT_TRUE(std::isinf(field.At({-20.0, 12.0})));
  // Its way leads along the gorge, below the bridge.
  const DistanceField below = DistancesTo(map, {5.0, -12.0}).value();
  EXPECT_NEAR(below.At({5.0, 12.0}), 24.0, 0.5);
}

}  // namespace
}  // namespace latticeworld
