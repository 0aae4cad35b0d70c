#include "latticeworld/simulation/sensed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_scene.h"

namespace latticeworld {
namespace {

SensedWorld Sense(const Simulator& simulator) {
  return Sensed(*simulator.State(), *simulator.options().species);
}
const SensedAgent& Find(const SensedWorld& world, const std::string& name) {
  for (const SensedAgent& agent : world.agents) {
    if (agent.name == name) return agent;
  }
  throw std::out_of_range(name);
}

TEST(SensedTest, ItIsTheStateOfTheEpisode) {
  TestScene scene;
  scene.AddAgent("sheep", AgentCategory::kSheep, 5.0, 3.0);
  scene.AddElement("box", ElementKind::kCrate, -4.0, 2.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 0.2);
  simulator->Reset(simulator->seed());
  RunFor(simulator.get(), 0.1);
  const SensedWorld world = Sense(*simulator);
  EXPECT_EQ(world.step, 10u);
  EXPECT_NEAR(world.time_s, 0.1, 1e-9);
  ASSERT_EQ(world.elements.size(), 1u);
  EXPECT_EQ(world.elements[0].name, "box");
  EXPECT_NEAR(world.elements[0].map_from_element.translation().x(), -4.0, 0.01);
  const SensedAgent& sheep = Find(world, "sheep");
  EXPECT_EQ(sheep.category, AgentCategory::kSheep);
  EXPECT_FALSE(sheep.has_sensors);
  EXPECT_EQ(sheep.height_m, simulator->options().species->Find("sheep")->height_m);
  EXPECT_FALSE(sheep.wheels.has_value());
}

TEST(SensedTest, VelocitiesAreInTheMapAndTurnsInTheBody) {
  TestScene scene;
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("wheeled robot", "robot", 0.0, 0.0);
  request.heading_rad = M_PI / 2.0;
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  RunWith(simulator.get(), 2.0, "robot", Forward(1.0));
  const SensedAgent robot = Find(Sense(*simulator), "robot");
  EXPECT_TRUE(robot.has_sensors);
  EXPECT_NEAR(robot.linear_velocity_mps.y(), 1.0, 0.1);
  EXPECT_NEAR(robot.linear_velocity_mps.x(), 0.0, 0.1);
  EXPECT_NEAR(robot.map_from_base.linear()(1, 0), 1.0, 0.02);
}

TEST(SensedTest, EncodersTellTheWay) {
  TestScene scene;
  for (const char* species : {"wheeled robot", "ackermann car"}) {
    const auto simulator = MakeSimulator(scene);
    SpawnRequest request = RequestFor(species, "robot", -20.0, 0.0);
    request.controllable = true;
    MustSpawn(simulator.get(), request);
    RunWith(simulator.get(), 3.0, "robot", Forward(1.0));
    const SensedAgent before = Find(Sense(*simulator), "robot");
    simulator->Step();
    const SensedAgent after = Find(Sense(*simulator), "robot");
    ASSERT_TRUE(after.wheels.has_value()) << species;
    const double way_m =
        (after.map_from_base.translation() - before.map_from_base.translation()).head<2>().norm();
    const double rolled_m =
        std::remainder(after.wheels->left_rad - before.wheels->left_rad, 2.0 * M_PI) *
        after.wheels->wheel_radius_m;
    EXPECT_NEAR(rolled_m, way_m, 0.1 * way_m) << species;
    EXPECT_NEAR(after.wheels->right_radps * after.wheels->wheel_radius_m, 1.0, 0.1) << species;
    EXPECT_EQ(after.wheels->steering_rad.has_value(), std::string(species) == "ackermann car");
  }
}

TEST(SensedTest, AnAckermannCarsMiddleWheelFollowsItsCurve) {
  TestScene scene;
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("ackermann car", "car", 0.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  RunWith(simulator.get(), 4.0, "car", Forward(2.0, 0.4));
  const SensedAgent car = Find(Sense(*simulator), "car");
  ASSERT_TRUE(car.wheels && car.wheels->steering_rad);
  EXPECT_NEAR(std::tan(*car.wheels->steering_rad) / car.wheels->wheelbase_m, 0.4 / 2.0, 0.02);
}

TEST(SensedTest, ARobotFeelsTheHouseThatItPushesAgainst) {
  TestScene scene;
  scene.AddBuilding(6.0, 0.0, 2.0, 4.0);
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("wheeled robot", "robot", 2.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  EXPECT_EQ(Find(Sense(*simulator), "robot").contact_force_n, 0.0);
  double hardest_n = 0.0;
  for (int i = 0; i < 400; ++i) {
    RunWith(simulator.get(), 0.01, "robot", Forward(1.0));
    const SensedAgent robot = Find(Sense(*simulator), "robot");
    if (robot.contact_force_n == 0.0) {
      EXPECT_TRUE(robot.contact_direction.isZero());
      continue;
    }
    hardest_n = std::max(hardest_n, robot.contact_force_n);
    EXPECT_GT(robot.contact_direction.x(), 0.5);
    EXPECT_NEAR(robot.contact_direction.norm(), 1.0, 1e-9);
  }
  EXPECT_GT(hardest_n, 5.0);
}

TEST(SensedTest, AFallingTreeIsWhereItFalls) {
  WorldState state;
  state.felled.push_back({{3, {0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}}, false});
  const SensedWorld world = Sensed(state, *SpeciesCatalogue::BuiltIn());
  ASSERT_EQ(world.felled.size(), 1u);
  EXPECT_EQ(world.felled[0].asset, 3u);
  EXPECT_EQ(world.felled[0].tip_m, Eigen::Vector3d(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace latticeworld
