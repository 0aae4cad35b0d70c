// What maps, lines of sight and paths know of props as a world runs.

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "simulation/props/thing_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

bool IsBlocked(const Simulator& simulator, double x_m, double y_m) {
  const Scene& scene = simulator.scene();
  const auto map = BuildOccupancy(scene, RobotLimits(), ChangesOf(*simulator.State()));
  return map[scene.geometry().CellAt({x_m, y_m})] == 100;
}

TEST(PropsOnMapsTest, AWorldBeginsWithItsPropsOnTheMapAndNothingChanged) {
  TestScene scene;
  scene.AddProp("crate", PropKind::kCrate, 5.0, 5.0);
  scene.AddProp("gate", PropKind::kGate, -5.0, 5.0);
  scene.AddProp("post", PropKind::kPost, 5.0, -5.0);
  scene.AddProp("stone", PropKind::kLooseStone, -5.0, -5.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 3.0);
  EXPECT_EQ(simulator->State()->map_version, 0u);
  EXPECT_TRUE(ChangesOf(*simulator->State()) == SceneChanges());
  for (const double x_m : {-5.0, 5.0}) {
    for (const double y_m : {-5.0, 5.0}) EXPECT_TRUE(IsBlocked(*simulator, x_m, y_m)) << x_m;
  }
}

TEST(PropsOnMapsTest, ACrateCountsWhereItStandsStill) {
  TestScene made;
  ThingWorld world(made.Build());
  Prop crate = UsualProp(PropKind::kCrate);
  crate.name = "crate";
  ASSERT_TRUE(world.props.Add(crate).ok());
  const BodyId body = world.props.state().at("crate").body;
  const auto before = world.props.standing();
  ASSERT_EQ(before->blocks.size(), 1u);
  for (int i = 0; i < 200; ++i) {
    const double speed_mps = world.physics->MotionOf(body).linear_velocity_mps.x();
    world.physics->AddForce(body, {400.0 * (1.0 - speed_mps), 0.0, 0.0});
    world.Step(0.01);
    EXPECT_FALSE(world.props.Follow() && speed_mps > 0.1) << "it moves";
  }
  const double x_m = world.physics->MotionOf(body).position_m.x();
  ASSERT_GT(x_m, 1.0);
  EXPECT_EQ(world.props.standing(), before);
  world.Run(2.0);
  EXPECT_TRUE(world.props.Follow());
  EXPECT_FALSE(world.props.Follow());
  EXPECT_FALSE(world.props.is_as_begun());
  ASSERT_EQ(world.props.standing()->blocks.size(), 1u);
  EXPECT_NEAR(world.props.standing()->blocks[0].footprint.centre.x_m, x_m, 0.3);
}

TEST(PropsOnMapsTest, ASmallMoveIsNoChange) {
  TestScene made;  // cells of half a metre
  ThingWorld world(made.Build());
  Prop crate = UsualProp(PropKind::kCrate);
  crate.name = "crate";
  ASSERT_TRUE(world.props.Add(crate).ok());
  const BodyId body = world.props.state().at("crate").body;
  for (const auto& [x_m, changes] : {std::pair<double, bool>{0.2, false}, {0.4, true}}) {
    BodyMotion motion;
    motion.position_m.x() = x_m;
    world.physics->Place(body, motion);
    world.Run(2.0);
    EXPECT_EQ(world.props.Follow(), changes) << x_m;
  }
}

TEST(PropsOnMapsTest, AnOpenedGateIsFreeAndAClosedOneIsNot) {
  TestScene scene;
  scene.AddProp("gate", PropKind::kGate, 0.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 1.0);
  const double middle_m = 0.8;  // of the panel, away from the hinge
  EXPECT_TRUE(IsBlocked(*simulator, middle_m, 0.0));
  ASSERT_TRUE(simulator->OpenGate("gate", 1.4).ok());
  RunFor(simulator.get(), 6.0);
  EXPECT_EQ(simulator->State()->map_version, 1u);
  EXPECT_FALSE(IsBlocked(*simulator, 0.9, -0.3));
  EXPECT_TRUE(IsBlocked(*simulator, 0.1, middle_m));
  ASSERT_TRUE(simulator->OpenGate("gate", 0.0).ok());
  RunFor(simulator.get(), 6.0);
  EXPECT_EQ(simulator->State()->map_version, 2u);
  EXPECT_TRUE(IsBlocked(*simulator, middle_m, 0.0));
}

TEST(PropsOnMapsTest, WhatComesAndGoesIsOnTheMapAtOnce) {
  const auto simulator = MakeSimulator(TestScene());
  Prop post = UsualProp(PropKind::kPost);
  post.name = "post";
  post.position = {3.0, 3.0};
  ASSERT_TRUE(simulator->SpawnProp(post).ok());
  EXPECT_EQ(simulator->State()->map_version, 1u);
  EXPECT_TRUE(IsBlocked(*simulator, 3.0, 3.0));
  ASSERT_TRUE(simulator->RemoveProp("post").ok());
  EXPECT_EQ(simulator->State()->map_version, 2u);
  EXPECT_FALSE(IsBlocked(*simulator, 3.0, 3.0));
  EXPECT_TRUE(ChangesOf(*simulator->State()) == SceneChanges());
}

TEST(PropsOnMapsTest, WhatBreaksIsOnNoMap) {
  TestScene made;
  made.height_m = [](double x_m, double) { return std::abs(x_m) < 2.5 ? -2.0 : 0.0; };
  ThingWorld world(made.Build());
  Prop bridge = UsualProp(PropKind::kBridge);
  bridge.name = "bridge";
  bridge.strength = 500.0;
  ASSERT_TRUE(world.props.Add(bridge).ok());
  Prop post = UsualProp(PropKind::kPost);
  post.name = "post";
  post.position = {10.0, 10.0};
  ASSERT_TRUE(world.props.Add(post).ok());
  EXPECT_EQ(world.props.standing()->decks.size(), 1u);
  EXPECT_EQ(world.props.standing()->blocks.size(), 1u);
  BodyMotion motion;
  motion.position_m = {0.0, 0.0, 0.05};
  BodySpec load = RammerOf(3000.0, {1.0, 1.0, 0.5}, 0.0);
  load.grip = 1.0;
  world.physics->Add(load, motion);
  motion.position_m = {7.0, 10.0, 0.0};
  motion.linear_velocity_mps.x() = 8.0;
  world.physics->Add(RammerOf(2500.0, {3.0, 1.6, 1.0}), motion);
  world.Run(3.0);
  ASSERT_EQ(world.Count(EventKind::kBroke), 2);
  EXPECT_TRUE(world.props.standing()->decks.empty());
  EXPECT_TRUE(world.props.standing()->blocks.empty());
}

TEST(PropsOnMapsTest, IsPartOfTheStateThatASnapshotKeeps) {
  TestScene scene;
  scene.AddProp("gate", PropKind::kGate, 0.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  const auto begin = simulator->Save();
  const std::string hash = simulator->StateHash();
  ASSERT_TRUE(simulator->OpenGate("gate", 1.4).ok());
  RunFor(simulator.get(), 4.0);
  const auto open = ChangesOf(*simulator->State());
  const auto snapshot = simulator->Save();
  ASSERT_TRUE(simulator->Restore(*begin).ok());
  EXPECT_TRUE(ChangesOf(*simulator->State()) == SceneChanges());
  EXPECT_EQ(simulator->StateHash(), hash);
  ASSERT_TRUE(simulator->Restore(*snapshot).ok());
  EXPECT_TRUE(ChangesOf(*simulator->State()) == open);
  simulator->Reset(1);
  EXPECT_EQ(simulator->StateHash(), hash);
}

}  // namespace
}  // namespace latticeworld
