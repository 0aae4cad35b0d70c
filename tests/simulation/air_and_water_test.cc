// Flyers and swimmers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

TestScene Lake(double depth_m) {
  TestScene scene;
  scene.height_m = [depth_m](double, double) { return -depth_m; };
  scene.water_depth_m = [depth_m](double, double) { return depth_m; };
  return scene;
}

std::unique_ptr<Simulator> OneControlled(const TestScene& scene, const std::string& species) {
  auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor(species, "it", 0.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  return simulator;
}

VelocityCommand Upward(double speed_mps) {
  VelocityCommand command;
  command.linear_mps.z() = speed_mps;
  return command;
}

TEST(FlyerTest, FliesAsCommandedInThreeDirections) {
  const auto simulator = OneControlled({}, "aerial robot");
  const Eigen::Vector3d start = Now(*simulator, "it").position_m;
  VelocityCommand command;
  command.linear_mps = {2.0, 1.0, 0.5};
  RunWith(simulator.get(), 4.0, "it", command);
  const AgentSnapshot flyer = Now(*simulator, "it");
  EXPECT_NEAR(flyer.linear_velocity_mps.x(), 2.0, 0.15);
  EXPECT_NEAR(flyer.linear_velocity_mps.y(), 1.0, 0.15);
  EXPECT_GT(flyer.position_m.z(), start.z() + 1.0);
}

TEST(FlyerTest, HoversInStillAir) {
  const auto simulator = OneControlled({}, "aerial robot");
  const Eigen::Vector3d start = Now(*simulator, "it").position_m;
  RunWith(simulator.get(), 5.0, "it", VelocityCommand());
  EXPECT_LT((Now(*simulator, "it").position_m - start).norm(), 0.1);
}

TEST(SwimmerTest, KeepsItsDepthAndDivesAndRises) {
  const auto simulator = OneControlled(Lake(12.0), "whale");
  RunWith(simulator.get(), 2.0, "it", VelocityCommand());
  const double from_m = Now(*simulator, "it").position_m.z();
  RunWith(simulator.get(), 5.0, "it", VelocityCommand());
  EXPECT_NEAR(Now(*simulator, "it").position_m.z(), from_m, 0.1) << "as dense as water";
  RunWith(simulator.get(), 3.0, "it", Upward(-0.8));
  EXPECT_LT(Now(*simulator, "it").position_m.z(), from_m - 1.0);
  RunWith(simulator.get(), 3.0, "it", Forward(2.0));
  EXPECT_NEAR(Now(*simulator, "it").linear_velocity_mps.x(), 1.8, 0.3);
}

TEST(SwimmerTest, DoesNotLeaveTheWater) {
  const auto simulator = OneControlled(Lake(8.0), "whale");
  double highest_m = -1e9;
  for (int i = 0; i < 1500; ++i) {
    RunWith(simulator.get(), 0.01, "it", Upward(2.0));
    highest_m = std::max(highest_m, Now(*simulator, "it").position_m.z());
  }
  EXPECT_LT(highest_m, 0.8) << "it may breach";
  EXPECT_GT(highest_m, -1.6) << "its back comes to the surface";
}

}  // namespace
}  // namespace latticeworld
