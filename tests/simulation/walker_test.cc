#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/spawn_rules.h"
#include "latticeworld/simulation/agents/species.h"
#include "test_scene.h"

namespace latticeworld {
namespace {

constexpr AgentCategory kWalkers[] = {AgentCategory::kGoblin,         AgentCategory::kHumanoidRobot,
                                      AgentCategory::kRoboticDog,     AgentCategory::kSheep,
                                      AgentCategory::kAncientWarrior, AgentCategory::kHorse};

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

TEST(WalkerTest, IsStoppedByATrunk) {
  TestScene scene = OneControlled(AgentCategory::kHorse);
  scene.AddTree(6.0, 0.0, 0.4);
  const auto simulator = MakeSimulator(scene);
  double nearest_m = 1e9;
  for (int i = 0; i < 400; ++i) {
    RunWith(simulator.get(), 0.01, "walker", Forward(8.0));
    const Eigen::Vector2d at = Now(*simulator, "walker").position_m.head<2>();
    nearest_m = std::min(nearest_m, (at - Eigen::Vector2d(6.0, 0.0)).norm());
  }
  EXPECT_NEAR(nearest_m, 0.4 + BodyRadius(AgentCategory::kHorse), 0.06);
}

TEST(SpeciesTest, EveryCategoryHasItsRow) {
  for (const auto& entry : EnumNames(AgentCategory{})) {
    const Species& species = SpeciesOf(entry.value);
    EXPECT_EQ(species.category, entry.value);
    EXPECT_GT(species.mass_kg, 0.0);
    EXPECT_GT(species.hit_points, 0.0);
    EXPECT_LE(species.cruise_mps, species.top_speed_mps);
    EXPECT_TRUE(CanBe(entry.value, UsualState(entry.value))) << entry.name;
    EXPECT_EQ(species.attack_reach_m > 0.0, TeamOf(entry.value, false) == 2) << entry.name;
  }
}

}  // namespace
}  // namespace latticeworld
