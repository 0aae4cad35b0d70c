#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kHalfWater_m = 3.0;

// A channel of deep water from north to south, and a footbridge over it along x.
TestScene Channel() {
  TestScene scene;
  scene.cells = 256;
  scene.height_m = [](double x, double) { return std::abs(x) < kHalfWater_m ? -2.5 : 0.0; };
  scene.water_depth_m = [](double x, double) { return std::abs(x) < kHalfWater_m ? 2.0 : 0.0; };
  Prop& bridge = scene.AddProp("bridge", PropKind::kBridge, 0.0, 0.0);
  bridge.size_m = {2.0 * kHalfWater_m + 2.0, 2.4, 0.2};
  bridge.strength = 2000.0;
  bridge.z_m = 0.01 - bridge.size_m.z();
  return scene;
}

double Up(const AgentSnapshot& agent) { return (agent.orientation * Eigen::Vector3d::UnitZ()).z(); }

TEST(FootbridgeTest, QuadrupedsBipedsAndWheelsCrossIt) {
  struct Crossing {
    const char* species;
    double speed_mps;
  };
  for (const Crossing& crossing :
       {Crossing{"robotic dog", 0.8}, Crossing{"goblin", 1.2}, Crossing{"humanoid robot", 1.0},
        Crossing{"sheep", 0.6}, Crossing{"wheeled robot", 0.8}}) {
    const auto simulator = MakeSimulator(Channel());
    SpawnRequest request = RequestFor(crossing.species, "walker", -6.0, 0.0);
    request.controllable = true;
    MustSpawn(simulator.get(), request);
    RunFor(simulator.get(), 0.5);
    double least_z_m = 1e9, most_z_m = -1e9, least_up = 1.0;
    const double seconds = 12.0 / crossing.speed_mps;
    for (int i = 0; i < static_cast<int>(seconds / 0.1); ++i) {
      // Held to the middle, as whoever steers it does.
      const AgentSnapshot now = Now(*simulator, "walker");
      const double turn_radps = -0.8 * now.position_m.y() - 1.5 * YawOf(now);
      RunWith(simulator.get(), 0.1, "walker",
              Forward(crossing.speed_mps, std::clamp(turn_radps, -0.5, 0.5)));
      const AgentSnapshot agent = Now(*simulator, "walker");
      least_z_m = std::min(least_z_m, agent.position_m.z());
      most_z_m = std::max(most_z_m, agent.position_m.z());
      least_up = std::min(least_up, Up(agent));
    }
    const AgentSnapshot walker = Now(*simulator, "walker");
    EXPECT_GT(walker.position_m.x(), 4.0) << crossing.species;
    EXPECT_GT(least_z_m, -0.1) << crossing.species << " kept to the deck";
    EXPECT_LT(most_z_m, 0.15) << crossing.species;
    EXPECT_GT(least_up, 0.95) << crossing.species;
    EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kKnockedOver, "walker"), 0)
        << crossing.species;
  }
}

TEST(FootbridgeTest, AQuadrupedStopsStandsAndTurnsOnIt) {
  const auto simulator = MakeSimulator(Channel());
  SpawnRequest request = RequestFor("robotic dog", "dog", -6.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  RunWith(simulator.get(), 7.5, "dog", Forward(0.8));
  RunFor(simulator.get(), 2.0);
  const AgentSnapshot stopped = Now(*simulator, "dog");
  ASSERT_LT(stopped.position_m.head<2>().norm(), 1.0) << "over the water";
  RunFor(simulator.get(), 3.0);
  AgentSnapshot dog = Now(*simulator, "dog");
  EXPECT_LT((dog.position_m - stopped.position_m).norm(), 0.1);
  EXPECT_NEAR(dog.position_m.z(), 0.01, 0.05);
  EXPECT_GT(Up(dog), 0.99);
  RunWith(simulator.get(), 2.0, "dog", Forward(0.0, 0.6));
  dog = Now(*simulator, "dog");
  EXPECT_NEAR(std::remainder(YawOf(dog) - YawOf(stopped) - 1.2, 2.0 * M_PI), 0.0, 0.4);
  EXPECT_GT(Up(dog), 0.97);
}

// A goblin on the west bank that hunts whoever stands on the east bank, far from the bridge.
std::unique_ptr<Simulator> Hunt(const TestScene& scene) {
  SimulatorOptions options;
  options.pursuit_distance_m = 60.0;
  auto simulator = MakeSimulator(scene, 1, options);
  SpawnRequest goblin = RequestFor("goblin", "goblin", -8.0, -12.0);
  goblin.policy = "pursuer";
  MustSpawn(simulator.get(), goblin);
  SpawnRequest prey = RequestFor("humanoid robot", "prey", 8.0, -12.0);
  prey.controllable = true;
  MustSpawn(simulator.get(), prey);
  return simulator;
}

TEST(FootbridgeTest, HuntersTakeItToTheOtherBank) {
  const auto simulator = Hunt(Channel());
  bool struck = false;
  double least_z_m = 1e9;
  for (int i = 0; i < 400 && !struck; ++i) {
    RunFor(simulator.get(), 0.1);
    struck = Count(simulator->TakeEvents(), EventKind::kAttacked, "goblin") > 0;
    least_z_m = std::min(least_z_m, Now(*simulator, "goblin").position_m.z());
  }
  EXPECT_TRUE(struck);
  EXPECT_GT(least_z_m, -0.1) << "it kept dry";
}

TEST(FootbridgeTest, WithoutItOrWhereItDoesNotCarryThemTheyStayOnTheirBank) {
  TestScene none = Channel();
  none.props.clear();
  TestScene weak = Channel();
  weak.props[0].strength = 20.0;
  for (const TestScene& scene : {none, weak}) {
    const auto simulator = Hunt(scene);
    double farthest_m = -1e9, least_z_m = 1e9;
    for (int i = 0; i < 200; ++i) {
      RunFor(simulator.get(), 0.1);
      farthest_m = std::max(farthest_m, Now(*simulator, "goblin").position_m.x());
      least_z_m = std::min(least_z_m, Now(*simulator, "goblin").position_m.z());
    }
    EXPECT_LT(farthest_m, 0.0);
    EXPECT_GT(least_z_m, -0.6) << "no deeper than it wades";
  }
}

TEST(FootbridgeTest, OneThatIsTakenAwayWhileTheyAreOnTheirWayIsNoWayAnyMore) {
  const auto simulator = Hunt(Channel());
  RunFor(simulator.get(), 2.0);
  ASSERT_GT(Now(*simulator, "goblin").position_m.y(), -11.0) << "on its way to the bridge";
  ASSERT_TRUE(simulator->RemoveProp("bridge").ok());
  RunFor(simulator.get(), 15.0);
  const AgentSnapshot goblin = Now(*simulator, "goblin");
  EXPECT_LT(goblin.position_m.x(), 0.0);
  EXPECT_GT(goblin.position_m.z(), -0.6);
}

}  // namespace
}  // namespace latticeworld
