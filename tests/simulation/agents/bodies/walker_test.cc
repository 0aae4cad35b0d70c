#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/agents/spawn_rules.h"
#include "latticeworld/simulation/agents/bodies/forces_on.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/agents/minds/mind_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// Bipeds and grazers; quadruped_test has the robotic dog.
constexpr AgentCategory kWalkers[] = {AgentCategory::kGoblin, AgentCategory::kHumanoidRobot,
                                      AgentCategory::kAncientWarrior, AgentCategory::kSheep,
                                      AgentCategory::kHorse};

TestScene OneControlled(AgentCategory category) {
  TestScene scene;
  AgentStart& start = scene.AddAgent("walker", category, 0.0, 0.0);
  start.controllable = true;
  start.team = 1;
  return scene;
}

TEST(WalkerTest, WalksAtTheCommandedSpeedAndTurns) {
  for (const AgentCategory category : kWalkers) {
    const auto simulator = MakeSimulator(OneControlled(category));
    RunWith(simulator.get(), 5.0, "walker", Forward(1.0));
    AgentSnapshot walker = Now(*simulator, "walker");
    EXPECT_NEAR(walker.linear_velocity_mps.x(), 1.0, 0.05) << NameOf(category);
    EXPECT_NEAR(walker.position_m.x(), 5.0, 0.4) << NameOf(category);
    EXPECT_NEAR(walker.position_m.z(), 0.0, 0.01) << NameOf(category);
    RunWith(simulator.get(), 2.0, "walker", Forward(0.0, 0.8));
    walker = Now(*simulator, "walker");
    EXPECT_NEAR(YawOf(walker), 1.6, 0.25) << NameOf(category);
  }
}

TEST(WalkerTest, StandsOnASlopeWithoutSliding) {
  for (const AgentCategory category : kWalkers) {
    TestScene scene = OneControlled(category);
    scene.height_m = [](double x, double) { return std::tan(25.0 * M_PI / 180.0) * x; };
    const auto simulator = MakeSimulator(scene);
    RunFor(simulator.get(), 1.0);
    const Eigen::Vector3d start = Now(*simulator, "walker").position_m;
    RunFor(simulator.get(), 10.0);
    EXPECT_LT((Now(*simulator, "walker").position_m - start).norm(), 0.02) << NameOf(category);
  }
}

TEST(WalkerTest, WalksOverHillsOnTheGroundAndUpright) {
  TestScene scene = OneControlled(AgentCategory::kSheep);
  scene.height_m = Hills(2.0, 25.0);
  const auto simulator = MakeSimulator(scene);
  for (int i = 0; i < 2000; ++i) {
    RunWith(simulator.get(), 0.01, "walker", Forward(1.2, 0.1));
    const AgentSnapshot walker = Now(*simulator, "walker");
    const double ground_m =
        simulator->scene().terrain->ground.HeightAt({walker.position_m.x(), walker.position_m.y()});
    ASSERT_NEAR(walker.position_m.z(), ground_m, 0.06);
    ASSERT_GT((walker.orientation * Eigen::Vector3d::UnitZ()).z(), 1.0 - 1e-9);
  }
  EXPECT_GT(Now(*simulator, "walker").position_m.norm(), 1.0);
}

TEST(WalkerTest, IceGivesLessTractionThanGrass) {
  const auto climbed = [](SurfaceClass surface) {
    TestScene scene = OneControlled(AgentCategory::kHumanoidRobot);
    scene.height_m = [](double x, double) { return std::tan(28.0 * M_PI / 180.0) * x; };
    scene.surface = [surface](double, double) { return surface; };
    const auto simulator = MakeSimulator(scene);
    RunWith(simulator.get(), 4.0, "walker", Forward(1.0));
    return Now(*simulator, "walker").position_m.x();
  };
  EXPECT_LT(climbed(SurfaceClass::kSnow), climbed(SurfaceClass::kRoad) - 1.0);
}

TEST(WalkerTest, ClimbsUpToItsLimitAndNoFurther) {
  const double limit_rad = SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kGoblin).max_slope_rad;
  const auto climbed = [](double slope_rad) {
    TestScene scene = OneControlled(AgentCategory::kGoblin);
    scene.height_m = [slope_rad](double x, double) { return std::tan(slope_rad) * x; };
    scene.surface = [](double, double) { return SurfaceClass::kRoad; };
    const auto simulator = MakeSimulator(scene);
    RunWith(simulator.get(), 3.0, "walker", Forward(1.0));
    return Now(*simulator, "walker").position_m.x();
  };
  EXPECT_GT(climbed(limit_rad - 0.05), 1.5);
  EXPECT_LT(climbed(limit_rad + 0.05), 0.05);
}

TEST(WalkerTest, FollowsASteepSlopeSidewaysAndDown) {
  TestScene scene = OneControlled(AgentCategory::kGoblin);
  scene.height_m = [](double x, double) { return -std::tan(0.75) * x; };
  scene.surface = [](double, double) { return SurfaceClass::kRoad; };
  const auto simulator = MakeSimulator(scene);
  RunWith(simulator.get(), 3.0, "walker", Forward(1.0));
  EXPECT_GT(Now(*simulator, "walker").position_m.x(), 1.5);
}

TEST(WalkerTest, IsSlowedBySnow) {
  TestScene scene = OneControlled(AgentCategory::kSheep);
  scene.atmosphere.snow_depth_m = 0.25;
  const auto simulator = MakeSimulator(scene);
  RunWith(simulator.get(), 4.0, "walker", Forward(3.0));
  // Pandolf's factor is 3.3 at that depth.
  EXPECT_NEAR(Now(*simulator, "walker").linear_velocity_mps.x(), 3.0 / std::sqrt(3.3), 0.1);
}

TEST(WalkerTest, IsStoppedByATrunk) {
  for (const AgentCategory category : kWalkers) {
    TestScene scene = OneControlled(category);
    scene.AddTree(6.0, 0.0, 0.4);
    const auto simulator = MakeSimulator(scene);
    double nearest_m = 1e9;
    for (int i = 0; i < 400; ++i) {
      RunWith(simulator.get(), 0.01, "walker", Forward(2.0));
      const Eigen::Vector2d at = Now(*simulator, "walker").position_m.head<2>();
      nearest_m = std::min(nearest_m, (at - Eigen::Vector2d(6.0, 0.0)).norm());
    }
    EXPECT_LT(nearest_m, 0.4 + BodyRadius(category) + 0.06) << NameOf(category);
    // Bodies and trunks give by some centimetres; long bodies may slide by with their sides.
    const bool is_round = SpeciesCatalogue::BuiltIn()->Of(category).plan == BodyPlan::kBiped;
    const double beside_m = (is_round ? 1.0 : 0.36) * BodyRadius(category);
    EXPECT_GT(nearest_m, 0.4 + beside_m - 0.12) << NameOf(category);
  }
}

TEST(WalkerTest, TheGroundUnderADeckDoesNotHoldItBack) {
  TestScene scene;
  scene.height_m = [](double x, double) { return 2.0 * x; };
  MindWorld world(scene);
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  const Eigen::Vector3d forward(1.0, 0.0, 0.0);
  EXPECT_NEAR(WithinSlope(goblin, world.Now(), forward).norm(), 0.0, 1e-9);
  goblin.motion.position_m.z() += 1.0;
  EXPECT_EQ(WithinSlope(goblin, world.Now(), forward), forward);
}

}  // namespace
}  // namespace latticeworld
