// Trees that fall or lie are in the way of what is put into the world, and lie in peace wherever
// they fall.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "latticeworld/scene/props/props.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/props/thing_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// A tree of 12 m that a car fells.
TestScene ThinTree(double x_m, double y_m) {
  TestScene scene;
  scene.AddTree(x_m, y_m, 0.06);
  scene.assets.back().height_m = 12.0f;
  scene.assets.back().model = Catalogue::BuiltIn()->models_of(AssetKind::kTree).front();
  return scene;
}

// A tractor has just felled the tree at (0, 0) towards the east, and is gone.
std::unique_ptr<Simulator> AfterTheBlow() {
  auto simulator = MakeSimulator(ThinTree(0.0, 0.0));
  SpawnRequest request = RequestFor("tractor", "tractor", -25.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  for (int i = 0; i < 1500 && simulator->State()->felled.empty(); ++i) {
    EXPECT_TRUE(simulator->Command("tractor", Forward(20.0)).ok());
    simulator->Step();
  }
  EXPECT_EQ(simulator->State()->felled.size(), 1u);
  EXPECT_TRUE(simulator->Remove("tractor").ok());
  return simulator;
}

StatusCode SpawnAt(Simulator* simulator, double x_m, double y_m) {
  SpawnRequest request;
  request.category = AgentCategory::kRoboticDog;
  request.position = WorldPoint{x_m, y_m};
  const auto name = simulator->Spawn(request);
  if (name.ok()) {
    EXPECT_TRUE(simulator->Remove(*name).ok());
  }
  return name.status().code();
}

StatusCode PutCrateAt(Simulator* simulator, double x_m, double y_m) {
  Prop crate = UsualProp(PropKind::kCrate);
  crate.position = {x_m, y_m};
  const auto name = simulator->SpawnProp(crate);
  if (name.ok()) {
    EXPECT_TRUE(simulator->RemoveProp(*name).ok());
  }
  return name.status().code();
}

TEST(LyingTreesTest, NothingIsPutIntoTheWayOfAFallingTree) {
  const auto simulator = AfterTheBlow();
  const std::string before = simulator->StateHash();
  ASSERT_FALSE(simulator->State()->felled[0].at_rest);
  for (const double x_m : {1.0, 6.0, 11.0}) {
    EXPECT_EQ(SpawnAt(simulator.get(), x_m, 0.5), StatusCode::kFailedPrecondition) << x_m;
    EXPECT_EQ(PutCrateAt(simulator.get(), x_m, 0.5), StatusCode::kFailedPrecondition) << x_m;
  }
  EXPECT_EQ(simulator->StateHash(), before);
  EXPECT_EQ(SpawnAt(simulator.get(), 6.0, 4.0), StatusCode::kOk);
  EXPECT_EQ(PutCrateAt(simulator.get(), -5.0, 0.5), StatusCode::kOk);
}

TEST(LyingTreesTest, NothingIsPutIntoALyingTreeAndAnythingWhereItStood) {
  const auto simulator = AfterTheBlow();
  RunFor(simulator.get(), 12.0);
  ASSERT_TRUE(simulator->State()->felled[0].at_rest);
  const FallenTree tree = simulator->State()->felled[0].tree;
  const Eigen::Vector3d way = tree.tip_m - tree.foot_m;
  for (const double share : {0.02, 0.4, 0.98}) {
    const Eigen::Vector3d at = tree.foot_m + share * way;
    EXPECT_EQ(SpawnAt(simulator.get(), at.x(), at.y()), StatusCode::kFailedPrecondition);
    EXPECT_EQ(PutCrateAt(simulator.get(), at.x(), at.y()), StatusCode::kFailedPrecondition);
  }
  const Eigen::Vector3d side = Eigen::Vector3d(-way.y(), way.x(), 0.0).normalized();
  const Eigen::Vector3d beside = tree.foot_m + 0.4 * way + 1.5 * side;
  EXPECT_EQ(SpawnAt(simulator.get(), beside.x(), beside.y()), StatusCode::kOk);
  EXPECT_EQ(PutCrateAt(simulator.get(), beside.x(), beside.y()), StatusCode::kOk);
  // Behind its foot there was no room while it stood.
  const double radius_m = SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kRoboticDog).radius_m;
  const double trunk_m = 0.06;
  const Eigen::Vector3d along = Eigen::Vector3d(way.x(), way.y(), 0.0).normalized();
  const Eigen::Vector3d behind = tree.foot_m - (radius_m + trunk_m + 0.005) * along;
  ASSERT_LT(behind.head<2>().norm(), radius_m + trunk_m);
  EXPECT_EQ(SpawnAt(simulator.get(), behind.x(), behind.y()), StatusCode::kOk);
}

TEST(LyingTreesTest, PlacesThatTheWorldFindsAreClearOfThem) {
  const auto simulator = AfterTheBlow();
  for (int i = 0; i < 60; ++i) {
    SpawnRequest request;
    request.category = AgentCategory::kRoboticDog;
    request.region = Region::kCenter;
    const auto name = simulator->Spawn(request);
    ASSERT_TRUE(name.ok()) << name.status().ToString();
    const Eigen::Vector3d at = Now(*simulator, *name).position_m;
    EXPECT_FALSE(at.x() > 0.0 && at.x() < 12.0 && std::abs(at.y()) < 1.0) << at.transpose();
  }
}

TEST(LyingTreesTest, ATreeLiesInPeaceAcrossTheEdgeOfTheWorld) {
  for (const double from_edge_m : {2.0, 6.0}) {
    TestScene made = ThinTree(32.0 - from_edge_m, 3.0);
    ThingWorld world(made.Build());
    BodyMotion motion;
    motion.position_m = {32.0 - from_edge_m - 2.5, 3.0, 0.0};
    motion.linear_velocity_mps.x() = 8.0;
    const BodyId ram = world.physics->Add(RammerOf(2500.0, {3.0, 1.6, 1.0}), motion);
    while (world.Count(EventKind::kFelledTree) == 0 && world.steps < 100) world.Step(0.01);
    ASSERT_EQ(world.Count(EventKind::kFelledTree), 1);
    world.physics->Remove(ram);
    world.Run(12.0);
    EXPECT_EQ(world.Count(EventKind::kTreeCameToRest), 1) << from_edge_m;
    EXPECT_EQ(world.Count(EventKind::kLeftWorld), 0) << from_edge_m;
    const FelledTree now = world.felling.Snapshots().front();
    ASSERT_TRUE(now.at_rest);
    // Its foot is near where it stood, its tip beyond the edge and on the ground.
    EXPECT_LT((now.tree.foot_m.head<2>() - Eigen::Vector2d(32.0 - from_edge_m, 3.0)).norm(), 2.0);
    EXPECT_GT(now.tree.tip_m.x(), 32.0 + 11.0 - from_edge_m - 2.0);
    EXPECT_LT(now.tree.tip_m.z(), 2.0);
    EXPECT_TRUE(world.physics->IsResting(world.felling.state().trees.at(0).body));
    const Eigen::Vector3d tip = now.tree.tip_m;
    world.Run(5.0);
    EXPECT_LT((world.felling.Snapshots().front().tree.tip_m - tip).norm(), 0.01);
  }
}

}  // namespace
}  // namespace latticeworld
