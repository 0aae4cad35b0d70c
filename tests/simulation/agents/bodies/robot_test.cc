#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/ode/contacts/ground_contact.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr AgentCategory kRobot = AgentCategory::kWheeledRobot;

const BodySpec& RobotBody() {
  static const BodySpec body = BodyOf(SpeciesCatalogue::BuiltIn()->Of(kRobot));
  return body;
}

// From the middle to the front of its wheels [m].
double FrontOf(const BodySpec& body) {
  return body.wheels.front().center_m.x() + body.wheels.front().radius_m;
}

TestScene OneRobot() {
  TestScene scene;
  scene.AddAgent("robot", kRobot, 0.0, 0.0);
  return scene;
}

// How deep the deepest wheel is in the ground, from the pose alone.
double DeepestWheel(const Simulator& simulator) {
  const AgentSnapshot robot = Now(simulator, "robot");
  double deepest_m = 0.0;
  for (const WheelSpec& wheel : RobotBody().wheels) {
    const Eigen::Vector3d center = robot.position_m + robot.orientation * wheel.center_m;
    deepest_m = std::max(
        deepest_m, DepthBelowGround(simulator.scene().terrain->ground, center, wheel.radius_m));
  }
  return deepest_m;
}

TEST(RobotTest, StandsOnLevelGroundWithItsBaseAtTheGround) {
  const auto simulator = MakeSimulator(OneRobot());
  RunFor(simulator.get(), 2.0);
  const AgentSnapshot robot = Now(*simulator, "robot");
  EXPECT_NEAR(robot.position_m.z(), 0.0, 0.005);
  EXPECT_NEAR(robot.position_m.head<2>().norm(), 0.0, 0.005);
  EXPECT_LT(robot.linear_velocity_mps.norm(), 1e-3);
}

TEST(RobotTest, DrivesTheCommandedDistanceOnLevelGround) {
  for (const double speed_mps : {0.3, 1.0, 2.0, -1.0}) {
    const auto simulator = MakeSimulator(OneRobot());
    RunWith(simulator.get(), 8.0, "robot", Forward(speed_mps));
    const AgentSnapshot robot = Now(*simulator, "robot");
    // Speeding up at 2.5 m/s^2 loses v^2 / 2a.
    const double expected_m =
        8.0 * speed_mps - std::copysign(speed_mps * speed_mps / 5.0, speed_mps);
    EXPECT_NEAR(robot.position_m.x(), expected_m, 0.03 * std::abs(expected_m)) << speed_mps;
    EXPECT_NEAR(robot.position_m.y(), 0.0, 0.03 * std::abs(expected_m));
    EXPECT_NEAR(robot.linear_velocity_mps.x(), speed_mps, 0.05);
  }
}

TEST(RobotTest, TurnsAtTheCommandedRate) {
  for (const double speed_mps : {0.0, 0.5, 1.0}) {
    for (const double rate_radps : {-1.5, -0.4, 0.4, 1.0, 2.0}) {
      const auto simulator = MakeSimulator(OneRobot());
      RunWith(simulator.get(), 1.0, "robot", Forward(speed_mps, rate_radps));
      double turned_rad = 0.0;
      double last_rad = YawOf(Now(*simulator, "robot"));
      for (int i = 0; i < 300; ++i) {
        RunWith(simulator.get(), 0.01, "robot", Forward(speed_mps, rate_radps));
        const double yaw_rad = YawOf(Now(*simulator, "robot"));
        turned_rad += std::remainder(yaw_rad - last_rad, 2.0 * M_PI);
        last_rad = yaw_rad;
      }
      EXPECT_NEAR(turned_rad / 3.0, rate_radps, 0.15 * std::abs(rate_radps))
          << speed_mps << " m/s, " << rate_radps << " rad/s";
    }
  }
}

TEST(RobotTest, DrivesOverHillsWithoutSinking) {
  TestScene scene = OneRobot();
  scene.height_m = Hills(2.0, 30.0);
  const auto simulator = MakeSimulator(scene);
  double deepest_m = 0.0, distance_m = 0.0;
  Eigen::Vector3d last = Now(*simulator, "robot").position_m;
  for (int i = 0; i < 2000; ++i) {
    RunWith(simulator.get(), 0.01, "robot", Forward(1.2, 0.15));
    deepest_m = std::max(deepest_m, DeepestWheel(*simulator));
    const AgentSnapshot robot = Now(*simulator, "robot");
    distance_m += (robot.position_m - last).norm();
    last = robot.position_m;
    ASSERT_NEAR(robot.position_m.z(),
                simulator->scene().terrain->ground.HeightAt({last.x(), last.y()}), 0.08);
  }
  EXPECT_LT(deepest_m, 0.02);
  EXPECT_NEAR(distance_m, 1.2 * 20.0, 0.1 * 24.0);
}

TEST(RobotTest, HoldsOnASlopeWhenNothingIsCommanded) {
  TestScene scene = OneRobot();
  scene.height_m = [](double x, double) { return std::tan(20.0 * M_PI / 180.0) * x; };
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 1.0);
  const Eigen::Vector3d start = Now(*simulator, "robot").position_m;
  RunFor(simulator.get(), 10.0);
  EXPECT_LT((Now(*simulator, "robot").position_m - start).norm(), 0.05);
}

TEST(RobotTest, ClimbsASlopeOfTwentyDegrees) {
  TestScene scene = OneRobot();
  scene.height_m = [](double x, double) { return std::tan(20.0 * M_PI / 180.0) * x; };
  const auto simulator = MakeSimulator(scene);
  RunWith(simulator.get(), 6.0, "robot", Forward(1.0));
  EXPECT_GT(Now(*simulator, "robot").position_m.x(), 4.5);
}

TEST(RobotTest, StopsWhenTheCommandIsTooOld) {
  const auto simulator = MakeSimulator(OneRobot());
  ASSERT_TRUE(simulator->Command("robot", Forward(1.0)).ok());
  RunFor(simulator.get(), 0.5);
  EXPECT_GT(Now(*simulator, "robot").linear_velocity_mps.x(), 0.9);
  RunFor(simulator.get(), 1.0);
  EXPECT_LT(Now(*simulator, "robot").linear_velocity_mps.norm(), 0.01);
  const double x_m = Now(*simulator, "robot").position_m.x();
  RunFor(simulator.get(), 3.0);
  EXPECT_NEAR(Now(*simulator, "robot").position_m.x(), x_m, 0.01);
}

TEST(RobotTest, ClampsCommandsBeyondItsLimits) {
  const auto simulator = MakeSimulator(OneRobot());
  RunWith(simulator.get(), 3.0, "robot", Forward(1e300));
  EXPECT_NEAR(Now(*simulator, "robot").linear_velocity_mps.x(), 2.0, 0.1);
}

TEST(RobotTest, RefusesCommandsThatAreNotFinite) {
  const auto simulator = MakeSimulator(OneRobot());
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  const double kInfinite = std::numeric_limits<double>::infinity();
  for (const double bad : {kNan, kInfinite, -kInfinite}) {
    EXPECT_EQ(simulator->Command("robot", Forward(bad)).code(), StatusCode::kInvalidArgument);
    EXPECT_EQ(simulator->Command("robot", Forward(0.0, bad)).code(), StatusCode::kInvalidArgument);
    VelocityCommand sideways;
    sideways.linear_mps.z() = bad;
    EXPECT_EQ(simulator->Command("robot", sideways).code(), StatusCode::kInvalidArgument);
  }
  EXPECT_EQ(simulator->Command("nobody", Forward(1.0)).code(), StatusCode::kNotFound);
  RunFor(simulator.get(), 1.0);
  EXPECT_NEAR(Now(*simulator, "robot").position_m.x(), 0.0, 0.01);
}

TEST(RobotTest, IsStoppedByABuilding) {
  for (const double yaw_rad : {0.0, 0.6}) {
    TestScene scene = OneRobot();
    scene.AddBuilding(6.0, 0.0, 3.0, 2.0, yaw_rad);
    const auto simulator = MakeSimulator(scene);
    double nearest_m = -1e9;
    const double half_length_m = FrontOf(RobotBody());
    for (int i = 0; i < 1000; ++i) {
      RunWith(simulator.get(), 0.01, "robot", Forward(2.0));
      const AgentSnapshot robot = Now(*simulator, "robot");
      const Eigen::Vector3d front =
          robot.position_m + robot.orientation * Eigen::Vector3d(half_length_m, 0.0, 0.0);
      const Eigen::Rotation2Dd to_building(-yaw_rad);
      const Eigen::Vector2d local = to_building * (front.head<2>() - Eigen::Vector2d(6.0, 0.0));
      nearest_m =
          std::max(nearest_m, std::min(3.0 - std::abs(local.x()), 2.0 - std::abs(local.y())));
    }
    EXPECT_LT(nearest_m, 0.05) << "the front got inside";
    EXPECT_GT(nearest_m, -0.1) << "it never reached the wall";
    EXPECT_GE(Count(simulator->TakeEvents(), EventKind::kCollided, "robot"), 1);
  }
}

TEST(RobotTest, IsStoppedByATrunk) {
  TestScene scene = OneRobot();
  scene.AddTree(5.0, 0.0, 0.3);
  const auto simulator = MakeSimulator(scene);
  double farthest_m = 0.0;
  for (int i = 0; i < 600; ++i) {
    RunWith(simulator.get(), 0.01, "robot", Forward(2.0));
    farthest_m = std::max(farthest_m, Now(*simulator, "robot").position_m.x());
  }
  // Robot and trunk give by some centimetres, and so much more is between its front wheels.
  EXPECT_NEAR(farthest_m, 5.0 - 0.3 - FrontOf(RobotBody()), 0.12);
}

TEST(RobotTest, StaysInsideTheWorld) {
  const auto simulator = MakeSimulator(OneRobot());
  RunWith(simulator.get(), 25.0, "robot", Forward(2.0));
  const AgentSnapshot robot = Now(*simulator, "robot");
  EXPECT_GT(robot.position_m.x(), 30.0);
  EXPECT_LT(robot.position_m.x(), 32.0);
  EXPECT_NEAR(robot.position_m.z(), 0.0, 0.05);
}

}  // namespace
}  // namespace latticeworld
