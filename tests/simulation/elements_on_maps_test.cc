// What maps, lines of sight and paths know of elements as a world runs.

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/elements.h"
#include "latticeworld/scene/standing_elements.h"
#include "latticeworld/simulation/agents/path_finder.h"
#include "test_scene.h"
#include "thing_world.h"

namespace latticeworld {
namespace {

bool IsBlocked(const Simulator& simulator, double x_m, double y_m) {
  const Scene& scene = simulator.scene();
  const auto map = BuildOccupancy(scene, RobotLimits(), ChangesOf(*simulator.State()));
  return map[scene.geometry().CellAt({x_m, y_m})] == 100;
}

TEST(ElementsOnMapsTest, AWorldBeginsWithItsElementsOnTheMapAndNothingChanged) {
  TestScene scene;
  scene.AddElement("crate", ElementKind::kCrate, 5.0, 5.0);
  scene.AddElement("gate", ElementKind::kGate, -5.0, 5.0);
  scene.AddElement("post", ElementKind::kPost, 5.0, -5.0);
  scene.AddElement("stone", ElementKind::kLooseStone, -5.0, -5.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 3.0);
  EXPECT_EQ(simulator->State()->map_version, 0u);
  EXPECT_TRUE(ChangesOf(*simulator->State()) == SceneChanges());
  for (const double x_m : {-5.0, 5.0}) {
    for (const double y_m : {-5.0, 5.0}) EXPECT_TRUE(IsBlocked(*simulator, x_m, y_m)) << x_m;
  }
}

TEST(ElementsOnMapsTest, ACrateCountsWhereItStandsStill) {
  TestScene made;
  ThingWorld world(made.Build());
  Element crate = UsualElement(ElementKind::kCrate);
  crate.name = "crate";
  ASSERT_TRUE(world.elements.Add(crate).ok());
  const BodyId body = world.elements.state().at("crate").body;
  const auto before = world.elements.standing();
  ASSERT_EQ(before->blocks.size(), 1u);
  for (int i = 0; i < 200; ++i) {
    const double speed_mps = world.physics->MotionOf(body).linear_velocity_mps.x();
    world.physics->AddForce(body, {400.0 * (1.0 - speed_mps), 0.0, 0.0});
    world.Step(0.01);
    EXPECT_FALSE(world.elements.Follow() && speed_mps > 0.1) << "it moves";
  }
  const double x_m = world.physics->MotionOf(body).position_m.x();
  ASSERT_GT(x_m, 1.0);
  EXPECT_EQ(world.elements.standing(), before);
  world.Run(2.0);
  EXPECT_TRUE(world.elements.Follow());
  EXPECT_FALSE(world.elements.Follow());
  EXPECT_FALSE(world.elements.is_as_begun());
  ASSERT_EQ(world.elements.standing()->blocks.size(), 1u);
  EXPECT_NEAR(world.elements.standing()->blocks[0].footprint.centre.x_m, x_m, 0.3);
}

TEST(ElementsOnMapsTest, ASmallMoveIsNoChange) {
  TestScene made;  // cells of half a metre
  ThingWorld world(made.Build());
  Element crate = UsualElement(ElementKind::kCrate);
  crate.name = "crate";
  ASSERT_TRUE(world.elements.Add(crate).ok());
  const BodyId body = world.elements.state().at("crate").body;
  for (const auto& [x_m, changes] : {std::pair<double, bool>{0.2, false}, {0.4, true}}) {
    BodyMotion motion;
    motion.position_m.x() = x_m;
    world.physics->Place(body, motion);
    world.Run(2.0);
    EXPECT_EQ(world.elements.Follow(), changes) << x_m;
  }
}

TEST(ElementsOnMapsTest, AnOpenedGateIsFreeAndAClosedOneIsNot) {
  TestScene scene;
  scene.AddElement("gate", ElementKind::kGate, 0.0, 0.0);
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

TEST(ElementsOnMapsTest, WhatComesAndGoesIsOnTheMapAtOnce) {
  const auto simulator = MakeSimulator(TestScene());
  Element post = UsualElement(ElementKind::kPost);
  post.name = "post";
  post.position = {3.0, 3.0};
  ASSERT_TRUE(simulator->SpawnElement(post).ok());
  EXPECT_EQ(simulator->State()->map_version, 1u);
  EXPECT_TRUE(IsBlocked(*simulator, 3.0, 3.0));
  ASSERT_TRUE(simulator->RemoveElement("post").ok());
  EXPECT_EQ(simulator->State()->map_version, 2u);
  EXPECT_FALSE(IsBlocked(*simulator, 3.0, 3.0));
  EXPECT_TRUE(ChangesOf(*simulator->State()) == SceneChanges());
}

TEST(ElementsOnMapsTest, WhatBreaksIsOnNoMap) {
  TestScene made;
  made.height_m = [](double x_m, double) { return std::abs(x_m) < 2.5 ? -2.0 : 0.0; };
  ThingWorld world(made.Build());
  Element bridge = UsualElement(ElementKind::kBridge);
  bridge.name = "bridge";
  bridge.strength = 500.0;
  ASSERT_TRUE(world.elements.Add(bridge).ok());
  Element post = UsualElement(ElementKind::kPost);
  post.name = "post";
  post.position = {10.0, 10.0};
  ASSERT_TRUE(world.elements.Add(post).ok());
  EXPECT_EQ(world.elements.standing()->decks.size(), 1u);
  EXPECT_EQ(world.elements.standing()->blocks.size(), 1u);
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
  EXPECT_TRUE(world.elements.standing()->decks.empty());
  EXPECT_TRUE(world.elements.standing()->blocks.empty());
}

TEST(ElementsOnMapsTest, IsPartOfTheStateThatASnapshotKeeps) {
  TestScene scene;
  scene.AddElement("gate", ElementKind::kGate, 0.0, 0.0);
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
