#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

WorldPoint PlaceOf(const AgentSnapshot& agent) {
  return {agent.position_m.x(), agent.position_m.y()};
}

TEST(BehaviourTest, SheepGrazeOnGrassAndKeepOutOfWaterAndThings) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    TestScene scene;
    // Grass with a lake in the east and a field in the north.
    scene.water_depth_m = [](double x, double) { return x > 12.0 ? 1.0 : 0.0; };
    scene.surface = [](double x, double y) {
      if (x > 12.0) return SurfaceClass::kWaterBed;
      return y > 14.0 ? SurfaceClass::kFarmland : SurfaceClass::kGrass;
    };
    for (int i = 0; i < 8; ++i) scene.AddTree(-12.0 + 3.0 * i, 4.0 * ((i * 5) % 4) - 6.0);
    for (int i = 0; i < 6; ++i) {
      scene.AddAgent("sheep_" + std::to_string(i), AgentCategory::kSheep, -10.0 + 3.0 * i, -10.0);
    }
    const auto simulator = MakeSimulator(scene, seed);
    const auto start = simulator->State();
    double wandered_m = 0.0;
    for (int second = 0; second < 120; ++second) {
      RunFor(simulator.get(), 1.0);
      for (const AgentSnapshot& sheep : simulator->State()->agents) {
        const WorldPoint at = PlaceOf(sheep);
        ASSERT_EQ(sheep.behaviour, Behaviour::kGraze);
        ASSERT_EQ(simulator->scene().terrain->SurfaceAt(at), SurfaceClass::kGrass)
            << sheep.name << " at " << at.x_m << ", " << at.y_m;
        for (const Asset& tree : simulator->scene().assets) {
          ASSERT_FALSE(SolidContains(tree, at, 0.5));
        }
        wandered_m =
            std::max(wandered_m, (sheep.position_m - Find(*start, sheep.name).position_m).norm());
      }
    }
    EXPECT_GT(wandered_m, 3.0);
  }
}

TEST(BehaviourTest, EveryAgentBeginsInTheBehaviourOfItsState) {
  TestScene scene;
  scene.AddAgent("guard", AgentCategory::kHumanoidRobot, 0.0, 0.0).state = AgentState::kPatrolling;
  scene.AddAgent("sheep", AgentCategory::kSheep, 5.0, 0.0).state = AgentState::kGrazing;
  scene.AddAgent("eagle", AgentCategory::kEagle, -5.0, 0.0).state = AgentState::kFlying;
  scene.AddAgent("idler", AgentCategory::kHorse, 0.0, 5.0).state = AgentState::kIdle;
  const auto simulator = MakeSimulator(scene, 1);
  EXPECT_EQ(Now(*simulator, "guard").behaviour, Behaviour::kPatrol);
  EXPECT_EQ(Now(*simulator, "sheep").behaviour, Behaviour::kGraze);
  EXPECT_EQ(Now(*simulator, "eagle").behaviour, Behaviour::kSoar);
  EXPECT_EQ(Now(*simulator, "idler").behaviour, Behaviour::kIdle);
}

TEST(BehaviourTest, PatrolsGoRoundAndComeBack) {
  TestScene scene;
  scene.AddBuilding(6.0, 6.0, 3.0, 3.0);
  scene.AddAgent("guard", AgentCategory::kHumanoidRobot, 0.0, 0.0).state = AgentState::kPatrolling;
  const auto simulator = MakeSimulator(scene, 5);
  double far_m = 0.0;
  int turns_home = 0;
  bool away = false;
  double travelled_m = 0.0;
  Eigen::Vector3d last = Now(*simulator, "guard").position_m;
  for (int i = 0; i < 600; ++i) {
    RunFor(simulator.get(), 1.0);
    const AgentSnapshot guard = Now(*simulator, "guard");
    travelled_m += (guard.position_m - last).norm();
    last = guard.position_m;
    const double distance_m = guard.position_m.head<2>().norm();
    far_m = std::max(far_m, distance_m);
    if (distance_m > 12.0) away = true;
    if (away && distance_m < 12.0) {
      away = false;
      ++turns_home;
    }
    ASSERT_FALSE(SolidContains(scene.assets[0], PlaceOf(guard), 0.0));
  }
  EXPECT_GT(travelled_m, 300.0);
  EXPECT_GT(far_m, 8.0);
  EXPECT_LT(far_m, 45.0);
  EXPECT_GE(turns_home, 2);
}

TEST(BehaviourTest, FlyersKeepAboveGroundAndTrees) {
  TestScene scene;
  scene.height_m = Hills(6.0, 40.0);
  for (int i = 0; i < 20; ++i) scene.AddTree(-28.0 + 3.0 * i, 5.0 * ((i * 7) % 9) - 20.0);
  scene.atmosphere.wind_mps = {6.0, -3.0, 0.0};
  scene.AddAgent("eagle", AgentCategory::kEagle, 5.0, 5.0);
  scene.AddAgent("drone", AgentCategory::kAerialRobot, -8.0, 3.0).state = AgentState::kPatrolling;
  scene.AddAgent("hover", AgentCategory::kAerialRobot, -18.0, 3.0).state = AgentState::kIdle;
  const auto simulator = MakeSimulator(scene);
  const Eigen::Vector3d hover_start = Now(*simulator, "hover").position_m;
  double travelled_m = 0.0;
  for (int i = 0; i < 600; ++i) {
    RunFor(simulator.get(), 0.1);
    for (const AgentSnapshot& flyer : simulator->State()->agents) {
      ASSERT_GT(flyer.position_m.z(),
                simulator->scene().terrain->ground.HeightAt(PlaceOf(flyer)) + 2.0)
          << flyer.name;
    }
    travelled_m += 0.1 * Now(*simulator, "eagle").linear_velocity_mps.norm();
  }
  EXPECT_GT(travelled_m, 200.0);
  EXPECT_EQ(Now(*simulator, "eagle").behaviour, Behaviour::kSoar);
  EXPECT_LT((Now(*simulator, "hover").position_m - hover_start).norm(), 1.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kLeftWorld, "eagle"), 0);
}

TEST(BehaviourTest, ControlledFlyerObeysInThreeDimensionsAndHoversAfterwards) {
  TestScene scene;
  AgentStart& drone = scene.AddAgent("drone", AgentCategory::kAerialRobot, 0.0, 0.0);
  drone.controllable = true;
  const auto simulator = MakeSimulator(scene);
  VelocityCommand command;
  command.linear_mps = {1.0, -0.5, 0.5};
  RunWith(simulator.get(), 4.0, "drone", command);
  EXPECT_LT((Now(*simulator, "drone").linear_velocity_mps - command.linear_mps).norm(), 0.2);
  EXPECT_NEAR(Now(*simulator, "drone").position_m.z(), 12.0, 0.4);
  RunFor(simulator.get(), 3.0);
  const Eigen::Vector3d held = Now(*simulator, "drone").position_m;
  RunFor(simulator.get(), 3.0);
  EXPECT_LT((Now(*simulator, "drone").position_m - held).norm(), 0.1);
}

TEST(BehaviourTest, WhalesStayInDeepWaterBelowItsSurface) {
  TestScene scene;
  const auto bed = [](double x, double y) { return -std::max(0.0, 8.0 - 0.012 * (x * x + y * y)); };
  scene.height_m = bed;
  scene.water_depth_m = [bed](double x, double y) { return -bed(x, y); };
  scene.AddAgent("whale", AgentCategory::kWhale, 0.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  double travelled_m = 0.0;
  for (int i = 0; i < 300; ++i) {
    RunFor(simulator.get(), 1.0);
    const AgentSnapshot whale = Now(*simulator, "whale");
    ASSERT_GT(simulator->scene().terrain->WaterDepthAt(PlaceOf(whale)), 1.5);
    ASSERT_LT(whale.position_m.z(), -1.0);
    ASSERT_GT(whale.position_m.z(),
              simulator->scene().terrain->ground.HeightAt(PlaceOf(whale)) - 0.05);
    travelled_m += whale.linear_velocity_mps.norm();
  }
  EXPECT_GT(travelled_m, 100.0);
}

TEST(BehaviourTest, OneThatBeganTooCloseToATrunkFindsItsWayOut) {
  TestScene scene;
  scene.AddTree(8.0, 8.0);
  scene.AddAgent("dog", AgentCategory::kRoboticDog, 8.0, 7.2).state = AgentState::kPatrolling;
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 20.0);
  EXPECT_GT((Now(*simulator, "dog").position_m.head<2>() - Eigen::Vector2d(8.0, 7.2)).norm(), 3.0);
}

TEST(BehaviourTest, IdleOnesStayWhereTheyAre) {
  TestScene scene;
  scene.height_m = Hills(1.5, 30.0);
  scene.AddAgent("horse", AgentCategory::kHorse, 3.0, -4.0).state = AgentState::kIdle;
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 20.0);
  EXPECT_LT((Now(*simulator, "horse").position_m.head<2>() - Eigen::Vector2d(3.0, -4.0)).norm(),
            0.05);
  EXPECT_EQ(Now(*simulator, "horse").behaviour, Behaviour::kIdle);
}

TEST(BehaviourTest, NothingLeavesASmallSteepWorld) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    TestScene scene;
    scene.size_m = 32.0;
    scene.cells = 64;
    scene.height_m = Hills(5.0, 16.0);
    int n = 0;
    for (const auto& entry : EnumNames(AgentCategory{})) {
      if (entry.value == AgentCategory::kWhale) continue;
      AgentStart& start = scene.AddAgent("agent_" + std::to_string(n), entry.value,
                                         -10.0 + 5.0 * (n % 5), -10.0 + 5.0 * (n / 5));
      start.heading_rad = 0.7 * n++;
    }
    const auto simulator = MakeSimulator(scene, seed);
    for (int second = 0; second < 30; ++second) {
      RunFor(simulator.get(), 1.0);
      for (const AgentSnapshot& agent : simulator->State()->agents) {
        const WorldPoint at = PlaceOf(agent);
        ASSERT_TRUE(simulator->scene().geometry().Contains(at)) << agent.name;
        // The base of a quadruped is where its feet are when it stands: below one that lies.
        const double below_m = agent.category == AgentCategory::kRoboticDog ? 0.5 : 0.1;
        ASSERT_GT(agent.position_m.z(), simulator->scene().terrain->ground.HeightAt(at) - below_m)
            << agent.name << ", " << agent.species;
      }
    }
    for (const Event& event : simulator->TakeEvents()) {
      EXPECT_NE(event.kind, EventKind::kLeftWorld) << event.agent;
    }
  }
}

}  // namespace
}  // namespace latticeworld
