#include "latticeworld/scene/props/standing_props.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {
namespace {

Eigen::Quaterniond About(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX(), kZ = Eigen::Vector3d::UnitZ();

TEST(StandingPropsTest, ABoxHoldsEveryCornerOfItsPropAndNoMore) {
  Prop crate = UsualProp(PropKind::kCrate);
  crate.size_m = {1.0, 0.6, 0.4};
  for (int i = 0; i < 200; ++i) {
    const Eigen::Quaterniond turned =
        About(kZ, 0.7 * i) * About(kX, 0.31 * i) * About(Eigen::Vector3d::UnitY(), 0.17 * i);
    const Eigen::Vector3d place(3.0, -2.0, 0.5);
    const PropBlock box = BoxAround(crate, place, turned);
    double low_m = 1e9, high_m = -1e9, farthest_m = -1e9;
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.3, 0.3}) {
        for (const double z : {0.0, 0.4}) {
          const Eigen::Vector3d corner = place + turned * Eigen::Vector3d(x, y, z);
          low_m = std::min(low_m, corner.z());
          high_m = std::max(high_m, corner.z());
          farthest_m = std::max(farthest_m, GapTo(box.footprint, {corner.x(), corner.y()}));
        }
      }
    }
    EXPECT_NEAR(box.bottom_m, low_m, 1e-9) << i;
    EXPECT_NEAR(box.top_m, high_m, 1e-9) << i;
    EXPECT_NEAR(farthest_m, 0.0, 1e-9) << i;
  }
}

TEST(StandingPropsTest, ACrateOnItsSideIsAsWideAsItWasHigh) {
  Prop crate = UsualProp(PropKind::kCrate);
  crate.size_m = {1.0, 0.6, 2.0};
  const auto box = BlockOf(crate, {0.0, 0.0, 0.0}, About(kX, M_PI / 2.0));
  ASSERT_TRUE(box.has_value());
  EXPECT_NEAR(box->top_m - box->bottom_m, 0.6, 1e-9);
  EXPECT_NEAR(4.0 * box->footprint.half_length_m * box->footprint.half_width_m, 2.0, 1e-9);
}

TEST(StandingPropsTest, AGateBlocksWhereItsPanelIs) {
  const Prop gate = UsualProp(PropKind::kGate);
  const auto open = BlockOf(gate, {5.0, 1.0, 0.0}, About(kZ, M_PI / 2.0));
  ASSERT_TRUE(open.has_value());
  EXPECT_LT(GapTo(open->footprint, {5.0, 1.0 + 0.9 * gate.size_m.x()}), 0.0);
  EXPECT_GT(GapTo(open->footprint, {5.0 + 0.9 * gate.size_m.x(), 1.0}), 0.5);
}

TEST(StandingPropsTest, AStoneIsTheSameHoweverItRolls) {
  Prop stone = UsualProp(PropKind::kLooseStone);
  stone.size_m.setConstant(1.0);
  const Eigen::Vector3d middle(2.0, 3.0, 0.5);
  for (const double angle_rad : {0.0, 1.0, 3.0}) {
    const Eigen::Quaterniond rolled = About(kX, angle_rad);
    const auto box =
        BlockOf(stone, middle - rolled * Eigen::Vector3d(0.0, 0.0, 0.5 * kStoneLies), rolled);
    ASSERT_TRUE(box.has_value());
    EXPECT_NEAR(box->footprint.centre.x_m, 2.0, 1e-9);
    EXPECT_NEAR(box->footprint.centre.y_m, 3.0, 1e-9);
    EXPECT_NEAR(box->top_m, 1.0, 1e-9);
  }
}

TEST(StandingPropsTest, WhatIsLowIsInNobodysWayAndBridgesAreWays) {
  Prop stone = UsualProp(PropKind::kLooseStone);
  stone.size_m.setConstant(0.08);
  EXPECT_FALSE(BlockOf(stone, Eigen::Vector3d::Zero(), About(kZ, 0.0)).has_value());
  Prop bridge = UsualProp(PropKind::kBridge);
  bridge.z_m = 2.0;
  EXPECT_FALSE(BlockOf(bridge, Eigen::Vector3d::Zero(), About(kZ, 0.0)).has_value());
  const StandingProps standing = StandingAtBegin({stone, bridge});
  EXPECT_TRUE(standing.blocks.empty());
  ASSERT_EQ(standing.decks.size(), 1u);
  EXPECT_DOUBLE_EQ(standing.decks[0].top_m, 2.0 + bridge.size_m.z());
  EXPECT_EQ(standing.decks[0].carries_kg, bridge.strength);
}

TEST(StandingPropsTest, WithoutAListTheyAreWhereTheSceneHasThem) {
  Scene scene;
  scene.terrain = std::make_shared<const Terrain>();
  scene.props = {UsualProp(PropKind::kCrate), UsualProp(PropKind::kBridge)};
  SceneChanges changes;
  EXPECT_EQ(*PropsIn(scene, changes), StandingAtBegin(scene.props));
  changes.props = std::make_shared<const StandingProps>();
  EXPECT_TRUE(PropsIn(scene, changes)->blocks.empty());
  EXPECT_FALSE(changes == SceneChanges());
  SceneChanges other;
  other.props = std::make_shared<const StandingProps>();
  EXPECT_TRUE(changes == other);
  other.props = PropsIn(scene, SceneChanges());
  EXPECT_FALSE(changes == other);
}

TEST(StandingPropsTest, NamesEveryIllegalNumber) {
  StandingProps props =
      StandingAtBegin({UsualProp(PropKind::kCrate), UsualProp(PropKind::kBridge)});
  EXPECT_TRUE(Validate(props).empty());
  props.blocks[0].footprint.centre.x_m = NAN;
  props.blocks[0].footprint.half_width_m = 1e9;
  props.blocks[0].top_m = -1.0;
  props.decks[0].carries_kg = -1.0;
  props.decks[0].footprint.yaw_rad = INFINITY;
  EXPECT_EQ(Validate(props).size(), 5u);
  constexpr int kMostPartsOfBridges = 20000;
  props.blocks.assign(kMaxProps + kMostPartsOfBridges, PropBlock());
  props.decks.assign(1, PropDeck());
  EXPECT_EQ(Validate(props).size(), 1u);
}

}  // namespace
}  // namespace latticeworld
