// Props on occupancy grids, traversability and octomaps.

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/prop_boxes.h"
#include "latticeworld/scene/props/props.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

constexpr double kHalfWater_m = 3.0;

// A channel of deep water from north to south in the middle of a plain, in cells of that size.
Scene Channel(double cell_m) {
  const Scene dry = MakeScene(static_cast<int>(32.0 / cell_m), 32.0, [](double x_m, double) {
    return std::abs(x_m) < kHalfWater_m ? -2.5 : 0.0;
  });
  return WithWater(dry, -0.5f);
}

Prop Footbridge(double yaw_rad, double y_m) {
  Prop bridge = UsualProp(PropKind::kBridge);
  bridge.size_m.x() = (2.0 * kHalfWater_m + 1.5) / std::cos(yaw_rad);
  bridge.position = {0.0, y_m};
  bridge.yaw_rad = yaw_rad;
  bridge.z_m = 0.01 - bridge.size_m.z();
  bridge.strength = 500.0;
  return bridge;
}

Prop CrateAt(double x_m, double y_m, double z_m = 0.0) {
  Prop crate = UsualProp(PropKind::kCrate);
  crate.size_m = {0.9, 0.5, 0.7};
  crate.position = {x_m, y_m};
  crate.z_m = z_m;
  crate.yaw_rad = 0.4;
  return crate;
}

RobotLimits Small(double mass_kg = 50.0) {
  RobotLimits limits;
  limits.mass_kg = mass_kg;
  return limits;
}

bool IsFree(const Scene& scene, const Grid<std::int8_t>& map, WorldPoint at) {
  return map[scene.geometry().CellAt(at)] < 50;
}

TEST(PropMapsTest, BlocksCloseExactlyTheCellsThatTheRobotWouldTouchThemIn) {
  Scene scene = MakeScene(160, 32.0, [](double, double) { return 0.0; });
  scene.props = {CrateAt(3.0, -4.0)};
  const Footprint crate = FootprintOf(scene.props[0]);
  for (const double radius_m : {0.1, 0.3, 1.0}) {
    RobotLimits limits = Small();
    limits.radius_m = radius_m;
    const Grid<std::int8_t> map = BuildOccupancy(scene, limits);
    const Grid<float> ease = BuildTraversability(scene, limits);
    int blocked = 0;
    for (int row = 0; row < map.rows(); ++row) {
      for (int col = 0; col < map.cols(); ++col) {
        const double gap_m = GapTo(crate, scene.geometry().CenterOf({row, col}));
        if (std::abs(gap_m - radius_m) < 1e-4) continue;
        EXPECT_EQ(map(row, col), gap_m < radius_m ? 100 : 0) << row << " " << col;
        EXPECT_EQ(ease(row, col) == 0.0f, gap_m < radius_m) << row << " " << col;
        blocked += gap_m < radius_m;
      }
    }
    EXPECT_GT(blocked, 10);
  }
}

TEST(PropMapsTest, AThinGateHasNoHoleOnACoarseGrid) {
  Scene scene = MakeScene(32, 32.0, [](double, double) { return 0.0; });
  for (const double yaw_rad : {0.0, 0.4, 0.8, 1.3}) {
    Prop gate = UsualProp(PropKind::kGate);
    gate.size_m.x() = 5.0;
    gate.position = {-2.3, 0.2};
    gate.yaw_rad = yaw_rad;
    scene.props = {gate};
    RobotLimits limits = Small();
    limits.radius_m = 0.0;
    const Grid<std::int8_t> map = BuildOccupancy(scene, limits);
    const Footprint panel = FootprintOf(gate);
    for (double along_m = -2.0; along_m <= 2.0; along_m += 0.5) {
      // On the panel's line, or in the cell beside it that the line crosses, too.
      const WorldPoint left = panel.At(along_m, 0.45), right = panel.At(along_m, -0.45);
      EXPECT_FALSE(IsFree(scene, map, panel.At(along_m, 0.0)) && IsFree(scene, map, left) &&
                   IsFree(scene, map, right))
          << yaw_rad << " " << along_m;
    }
  }
}

TEST(PropMapsTest, ABridgeIsAWayOverWaterForWhatItCarries) {
  for (const double cell_m : {0.25, 0.5, 1.0}) {
    for (const double yaw_rad : {0.0, 0.3, -0.6}) {
      Scene scene = Channel(cell_m);
      scene.props = {Footbridge(yaw_rad, 1.3)};
      const Footprint deck = FootprintOf(scene.props[0]);
      const auto light = BuildOccupancy(scene, Small(400.0));
      const auto heavy = BuildOccupancy(scene, Small(600.0));
      SceneChanges broken;
      broken.props = std::make_shared<const StandingProps>();
      const auto without = BuildOccupancy(scene, Small(400.0), broken);
      const double half_m = deck.half_length_m;
      for (double along_m = -half_m; along_m <= half_m; along_m += 0.1) {
        EXPECT_TRUE(IsFree(scene, light, deck.At(along_m, 0.0))) << cell_m << " " << along_m;
        EXPECT_FALSE(IsFree(scene, heavy, deck.At(along_m, 0.0))) << cell_m << " " << along_m;
      }
      EXPECT_FALSE(IsFree(scene, without, deck.centre));
      // Not beside it.
      EXPECT_FALSE(IsFree(scene, light, deck.At(0.0, deck.half_width_m + 0.3 + cell_m)));
      EXPECT_FALSE(IsFree(scene, light, deck.At(0.0, -deck.half_width_m - 0.3 - cell_m)));
    }
  }
}

TEST(PropMapsTest, NobodyClimbsADeckFromBelow) {
  // A dry ditch that can be walked in, and a deck over it a metre and a half above its bed.
  Scene scene = MakeScene(128, 32.0, [](double x_m, double) {
    return std::clamp(0.4 * (std::abs(x_m) - 4.0), -1.5, 0.0);
  });
  const auto bare = BuildOccupancy(scene, Small());
  scene.props = {Footbridge(0.0, 0.0)};
  const Footprint deck = FootprintOf(scene.props[0]);
  const auto map = BuildOccupancy(scene, Small());
  ASSERT_TRUE(IsFree(scene, bare, {0.0, 0.9}));
  EXPECT_TRUE(IsFree(scene, map, {0.0, 0.0}));
  for (double y_m = deck.half_width_m - 0.1; y_m < deck.half_width_m + 0.2; y_m += 0.1) {
    EXPECT_FALSE(IsFree(scene, map, {0.0, y_m})) << y_m;
  }
  EXPECT_TRUE(IsFree(scene, map, {0.0, 2.0}));
}

TEST(PropMapsTest, ACrateOnABridgeIsInTheWay) {
  Scene scene = Channel(0.25);
  scene.props = {Footbridge(0.0, 0.0), CrateAt(0.0, 0.0, 0.01)};
  const auto map = BuildOccupancy(scene, Small());
  EXPECT_FALSE(IsFree(scene, map, {0.0, 0.0}));
  EXPECT_TRUE(IsFree(scene, map, {2.0, 0.0}));
}

TEST(PropMapsTest, OctomapsHoldBoxesAndDecksThatHang) {
  Scene scene = Channel(0.5);
  scene.props = {Footbridge(0.0, 0.0), CrateAt(8.0, 8.0)};
  const auto tree = BuildOctree(scene, {0.1, 0.5}, Progress()).value();
  EXPECT_NE(tree->search(8.0, 8.0, 0.35), nullptr);
  EXPECT_EQ(tree->search(8.0, 8.0, 0.85), nullptr);
  EXPECT_NE(tree->search(0.0, 0.0, -0.05), nullptr);  // the deck
  EXPECT_NE(tree->search(0.05, 0.85, -0.05), nullptr);
  EXPECT_EQ(tree->search(0.0, 0.0, -1.0), nullptr);   // below it
  EXPECT_EQ(tree->search(0.0, 1.5, -0.05), nullptr);  // beside it
}

}  // namespace
}  // namespace latticeworld
