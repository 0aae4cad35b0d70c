#include "latticeworld/simulation/props/felling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/asset_physics.h"
#include "latticeworld/simulation/props/blows.h"
#include "latticeworld/simulation/props/tree_body.h"
#include "simulation/props/thing_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kLight_kg = 24.0, kHeavy_kg = 2500.0;
const Eigen::Vector3d kSmall(0.6, 0.4, 0.3), kLarge(3.0, 1.6, 1.0);

// Trees of 12 m in a row along y, 12 m apart.
TestScene TreesOf(const std::vector<double>& radii_m) {
  TestScene scene;
  double y_m = -6.0 * static_cast<double>(radii_m.size() - 1);
  for (const double radius_m : radii_m) {
    scene.AddTree(0.0, y_m, radius_m);
    scene.assets.back().height_m = 12.0f;
    scene.assets.back().model = Catalogue::BuiltIn()->models_of(AssetKind::kTree).front();
    y_m += 12.0;
  }
  return scene;
}

// Sends a block from the west against the tree; its front begins half a metre before the trunk.
BodyId Ram(ThingWorld* world, std::uint32_t tree, double mass_kg, const Eigen::Vector3d& size_m,
           double speed_mps, double bottom_m = 0.1) {
  const Asset& asset = world->scene->assets[tree];
  BodyMotion motion;
  motion.position_m = {asset.x_m - asset.trunk_radius_m - 0.5 - 0.5 * size_m.x(), asset.y_m,
                       asset.z_m};
  motion.linear_velocity_mps = {speed_mps, 0.0, 0.0};
  return world->physics->Add(RammerOf(mass_kg, size_m, bottom_m), motion);
}

TEST(FellingTest, ABlowsMomentHoldsItsEnergy) {
  // At the moment M the elastic energy M^2 / (2 k) is that of the blow.
  const double moment_nm = ImpactMoment(100.0, 3.0, 2e5);
  EXPECT_NEAR(moment_nm * moment_nm / (2.0 * 2e5), 0.5 * 100.0 * 9.0, 1e-9);
  // And what is left after breaking at half of that is three quarters of it.
  const double after_mps = SpeedAfterBreaking(100.0, 3.0, 2e5, 0.5 * moment_nm);
  EXPECT_NEAR(after_mps * after_mps, 0.75 * 9.0, 1e-9);
  EXPECT_EQ(SpeedAfterBreaking(100.0, 3.0, 2e5, moment_nm), 0.0);
}

TEST(FellingTest, ALightRobotBouncesOffAThinTree) {
  ThingWorld world(TreesOf({0.1}).Build());
  const BodyId robot = Ram(&world, 0, kLight_kg, kSmall, 2.0);
  world.Run(2.0);
  EXPECT_EQ(world.Count(EventKind::kFelledTree), 0);
  EXPECT_TRUE(world.felling.changes().empty());
  EXPECT_LT(world.physics->MotionOf(robot).position_m.x(), -0.35);
}

TEST(FellingTest, AHeavyVehicleFellsAThinTreeAndNotAThickOne) {
  ThingWorld world(TreesOf({0.06, 0.4}).Build());
  const BodyId first = Ram(&world, 0, kHeavy_kg, kLarge, 8.0);
  const BodyId second = Ram(&world, 1, kHeavy_kg, kLarge, 8.0);
  world.Run(0.5);
  ASSERT_EQ(world.Count(EventKind::kFelledTree), 1);
  EXPECT_EQ(world.events.front().other, "tree_0");
  EXPECT_EQ(world.events.front().agent, "body_" + std::to_string(first));
  EXPECT_GT(world.physics->MotionOf(first).position_m.x(), 0.5);
  EXPECT_LT(world.physics->MotionOf(second).position_m.x(), -1.5);
}

TEST(FellingTest, WhatFellsATreeLosesTheEnergyOfBreakingIt) {
  const TestScene scene = TreesOf({0.06});
  ThingWorld world(scene.Build());
  const AssetPhysics tree = PhysicsOf(*world.scene->catalogue, world.scene->assets[0]);
  const BodyId body = Ram(&world, 0, kHeavy_kg, kLarge, 8.0);
  while (world.Count(EventKind::kFelledTree) == 0 && world.steps < 100) {
    const double before_mps = world.physics->MotionOf(body).linear_velocity_mps.x();
    world.Step(0.01);
    if (world.Count(EventKind::kFelledTree) == 0) continue;
    const double after_mps = world.physics->MotionOf(body).linear_velocity_mps.x();
    const double stiffness = StiffnessMet(kHeavy_kg, tree.base_stiffness_nmprad);
    const double energy_j = std::pow(tree.failing_moment_nm(), 2) / (2.0 * stiffness);
    EXPECT_NEAR(0.5 * kHeavy_kg * (before_mps * before_mps - after_mps * after_mps), energy_j,
                0.02 * energy_j + 0.5 * kHeavy_kg * 0.05);
  }
  EXPECT_EQ(world.Count(EventKind::kFelledTree), 1);
}

TEST(FellingTest, ThatATreeFallsDependsNeitherOnTheStepNorOnTheHeightOfTheBlow) {
  // The radius up to which the vehicle fells trees, for every step and height the same.
  const std::vector<double> radii_m = {0.1, 0.14, 0.18, 0.2, 0.22, 0.26, 0.3, 0.36};
  std::vector<bool> expected;
  for (const double step_s : {0.005, 0.01, 0.02}) {
    for (const double bottom_m : {0.05, 0.3, 0.8}) {
      std::vector<bool> fell;
      for (const double radius_m : radii_m) {
        ThingWorld world(TreesOf({radius_m}).Build());
        Ram(&world, 0, kHeavy_kg, {3.0, 1.6, 0.4}, 6.0, bottom_m);
        world.Run(0.3, step_s);
        fell.push_back(world.Count(EventKind::kFelledTree) == 1);
      }
      if (expected.empty()) expected = fell;
      EXPECT_EQ(fell, expected) << step_s << " " << bottom_m;
    }
  }
  EXPECT_TRUE(expected.front());
  EXPECT_FALSE(expected.back());
  // Once one holds, all thicker ones do.
  EXPECT_TRUE(std::is_sorted(expected.rbegin(), expected.rend()));
}

TEST(FellingTest, AStrongPushFellsWhatABlowOfItsSpeedWouldNot) {
  for (const double push : {0.7, 1.5}) {
    ThingWorld world(TreesOf({0.08}).Build());
    const double strength_nm =
        PhysicsOf(*world.scene->catalogue, world.scene->assets[0]).failing_moment_nm();
    const BodyId body = Ram(&world, 0, kHeavy_kg, {2.0, 1.0, 0.4}, 0.0, 0.8);
    const double height_m = 1.0;
    for (int i = 0; i < 800; ++i) {
      // Gently up to the tree, then with a force whose moment is that share of the strength.
      const double speed_mps = world.physics->MotionOf(body).linear_velocity_mps.x();
      const bool there = world.physics->MotionOf(body).position_m.x() > -1.09;
      const double force_n =
          there ? push * strength_nm / height_m : kHeavy_kg * 5.0 * (0.2 - speed_mps);
      world.physics->AddForce(body, {force_n, 0.0, 0.0});
      world.Step(0.01);
    }
    EXPECT_EQ(world.Count(EventKind::kFelledTree), push > 1.0 ? 1 : 0) << push;
  }
}

TEST(FellingTest, ALightBodyThatOverlapsATrunkIsPartedFromItAndFellsNothing) {
  for (const double inside_m : {0.05, 0.2, 0.5}) {
    ThingWorld world(TreesOf({0.3}).Build());
    BodyMotion motion;
    motion.position_m = {-0.6 + inside_m, 0.0, 0.0};
    BodySpec lying = RammerOf(45.0, {0.6, 0.5, 0.3}, 0.0);
    lying.upright = false;
    world.physics->Add(lying, motion);
    world.Run(3.0);
    EXPECT_EQ(world.Count(EventKind::kFelledTree), 0) << inside_m;
  }
}

TEST(FellingTest, AFelledTreeFallsAwayFromThePushAndComesToRest) {
  ThingWorld world(TreesOf({0.12}).Build());
  const Asset& tree = world.scene->assets[0];
  const BodyId body = Ram(&world, 0, kHeavy_kg, kLarge, 8.0);
  while (world.Count(EventKind::kFelledTree) == 0 && world.steps < 50) world.Step(0.01);
  ASSERT_EQ(world.Count(EventKind::kFelledTree), 1);
  // Where it stood, and nearly upright; maps show it no longer.
  FelledTree now = world.felling.Snapshots().front();
  EXPECT_FALSE(now.at_rest);
  EXPECT_NEAR(now.tree.foot_m.x(), tree.x_m, 0.1);
  EXPECT_GT(now.tree.tip_m.z(), 0.95 * tree.height_m);
  EXPECT_EQ(world.felling.changes().gone.size(), 1u);
  EXPECT_EQ(world.map_changes, 0);
  world.physics->Remove(body);
  world.Run(8.0);
  ASSERT_EQ(world.Count(EventKind::kTreeCameToRest), 1);
  now = world.felling.Snapshots().front();
  EXPECT_TRUE(now.at_rest);
  EXPECT_EQ(world.map_changes, 1);
  ASSERT_EQ(world.felling.changes().fallen.size(), 1u);
  EXPECT_TRUE(Validate(world.felling.changes(), *world.scene).ok());
  // To the east, on the ground, its foot near where it stood.
  const Eigen::Vector3d way = (now.tree.tip_m - now.tree.foot_m).normalized();
  EXPECT_GT(way.x(), 0.9);
  EXPECT_LT(std::abs(way.z()), 0.35);
  EXPECT_LT((now.tree.foot_m - Eigen::Vector3d(tree.x_m, tree.y_m, tree.z_m)).norm(), 2.0);
  EXPECT_GT(now.tree.foot_m.z(), -0.05);
  EXPECT_TRUE(world.physics->IsResting(world.felling.state().trees.at(0).body));
}

TEST(FellingTest, WhateverFellsATreeItLiesInTheEnd) {
  struct Blow {
    double radius_m, mass_kg, speed_mps;
  };
  for (const Blow& blow : {Blow{0.05, 2500.0, 5.0}, Blow{0.1, 2500.0, 8.0},
                           Blow{0.15, 10000.0, 8.0}, Blow{0.2, 10000.0, 8.0}}) {
    // Wide enough that what goes on pushing it does not push it out of the world.
    TestScene wide = TreesOf({blow.radius_m});
    wide.size_m = 192.0;
    ThingWorld world(wide.Build());
    Ram(&world, 0, blow.mass_kg, kLarge, blow.speed_mps);
    world.Run(14.0);
    ASSERT_EQ(world.Count(EventKind::kFelledTree), 1) << blow.radius_m;
    EXPECT_EQ(world.Count(EventKind::kTreeCameToRest), 1) << blow.radius_m;
    const FelledTree now = world.felling.Snapshots().front();
    EXPECT_TRUE(now.at_rest) << blow.radius_m;
    const Eigen::Vector3d way = now.tree.tip_m - now.tree.foot_m;
    EXPECT_LT(way.z(), 6.0) << blow.radius_m;
    EXPECT_GT(way.x(), 0.7 * way.head<2>().norm()) << blow.radius_m;
  }
}

TEST(FellingTest, ATreeThatLeftTheWorldIsGoneFromEveryList) {
  ThingWorld world(TreesOf({0.12}).Build());
  Ram(&world, 0, kHeavy_kg, kLarge, 8.0);
  while (world.Count(EventKind::kFelledTree) == 0 && world.steps < 50) world.Step(0.01);
  BodyMotion motion;
  motion.position_m = {0.0, 0.0, -50.0};
  world.physics->Place(world.felling.state().trees.at(0).body, motion);
  world.Step(0.01);
  EXPECT_EQ(world.Count(EventKind::kLeftWorld), 1);
  WorldState state;
  state.felled = world.felling.Snapshots();
  EXPECT_EQ(ChangesOf(state).gone, world.felling.changes().gone);
  EXPECT_EQ(ChangesOf(state).gone.size(), 1u);
}

TEST(FellingTest, AFallingTreeOfWeightFellsAThinOne) {
  TestScene scene = TreesOf({0.16});
  scene.assets[0].height_m = 18.0f;
  scene.AddTree(7.0, scene.assets[0].y_m, 0.05);
  scene.AddTree(11.0, scene.assets[0].y_m, 0.4);
  for (Asset& tree : scene.assets) tree.model = scene.assets[0].model;
  ThingWorld world(scene.Build());
  const BodyId body = Ram(&world, 0, 4.0 * kHeavy_kg, kLarge, 10.0);
  while (world.Count(EventKind::kFelledTree) == 0 && world.steps < 50) world.Step(0.01);
  ASSERT_EQ(world.Count(EventKind::kFelledTree), 1);
  world.physics->Remove(body);
  world.Run(8.0);
  EXPECT_EQ(world.felling.state().trees.count(1), 1u);
  EXPECT_EQ(world.felling.state().trees.count(2), 0u);
}

TEST(FellingTest, StonesAndBuildingsHold) {
  TestScene scene;
  scene.AddBuilding(0.0, 0.0, 2.0, 2.0);
  ThingWorld world(scene.Build());
  BodyMotion motion;
  motion.position_m = {-5.0, 0.0, 0.0};
  motion.linear_velocity_mps = {20.0, 0.0, 0.0};
  world.physics->Add(RammerOf(1e5, kLarge), motion);
  world.Run(1.0);
  EXPECT_TRUE(world.events.empty());
}

TEST(FellingTest, FallsOnTheSameWayFromASnapshotInMidFall) {
  ThingWorld world(TreesOf({0.12, 0.1}).Build());
  Ram(&world, 0, kHeavy_kg, kLarge, 8.0);
  Ram(&world, 1, kHeavy_kg, kLarge, 7.0);
  world.Run(0.8);
  ASSERT_EQ(world.Count(EventKind::kFelledTree), 2);
  ASSERT_EQ(world.Count(EventKind::kTreeCameToRest), 0);
  const auto snapshot = world.physics->Save();
  const Felling::State state = world.felling.state();
  const std::uint64_t steps = world.steps;
  world.Run(3.0);
  const std::string expected = world.Hash();
  world.physics->Restore(*snapshot);
  world.felling.Restore(state);
  world.steps = steps;
  EXPECT_NE(world.Hash(), expected);
  world.Run(3.0);
  EXPECT_EQ(world.Hash(), expected);
}

TEST(FellingTest, TheBodyOfATreeHasItsMassAndItsStemsEnds) {
  RandomStream random(5, "trees");
  for (int i = 0; i < 50; ++i) {
    TestScene scene = TreesOf({random.Uniform(0.02, 0.9)});
    Asset& tree = scene.assets[0];
    tree.height_m = static_cast<float>(random.Uniform(1.0, 35.0));
    const AssetPhysics physics = PhysicsOf(*Catalogue::BuiltIn(), tree);
    const BodySpec spec = TreeBodyOf(tree, physics);
    EXPECT_DOUBLE_EQ(spec.mass_kg, std::max(1.0, physics.mass_kg));
    EXPECT_GT(spec.center_height_m, 0.3 * tree.height_m);
    EXPECT_LT(spec.center_height_m, 0.5 * tree.height_m);
    EXPECT_GT(spec.inertia_kgm2.minCoeff(), 0.0);
    const BodyMotion motion = BeginningOfFall(tree, {0.6, 0.8}, 0.5);
    const FallenTree stem = StemOf(0, tree, motion);
    EXPECT_NEAR((stem.tip_m - stem.foot_m).norm(), tree.height_m, 1e-9);
    const Eigen::Vector3d way = stem.tip_m - stem.foot_m;
    EXPECT_NEAR(way.y() / way.x(), 0.8 / 0.6, 1e-9);
    EXPECT_GT(way.x(), 0.0);
    EXPECT_GT(motion.angular_velocity_radps.cross(way).x(), 0.0);  // and it falls on that way
  }
}

}  // namespace
}  // namespace latticeworld
