#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/agents/minds/mind_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::unique_ptr<Simulator> OneDog(TestScene scene = {}, double step_s = 0.01,
                                  std::uint64_t seed = 1) {
  SimulatorOptions options;
  options.step_s = step_s;
  auto simulator = MakeSimulator(scene, seed, options);
  SpawnRequest request = RequestFor("robotic dog", "dog", 0.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  return simulator;
}

double Up(const AgentSnapshot& agent) { return (agent.orientation * Eigen::Vector3d::UnitZ()).z(); }

TestScene Bumps() {
  TestScene scene;
  scene.size_m = 32.0;
  scene.cells = 256;
  scene.height_m = [](double x, double y) { return 0.05 * std::sin(7.0 * x) * std::cos(6.0 * y); };
  return scene;
}

TestScene Slope(double degrees) {
  TestScene scene;
  scene.height_m = [degrees](double x, double) { return std::tan(degrees * M_PI / 180.0) * x; };
  return scene;
}

TEST(QuadrupedTest, StandsForTenSeconds) {
  for (const double step_s : {0.005, 0.01}) {
    const auto simulator = OneDog({}, step_s);
    RunFor(simulator.get(), 1.0);
    const AgentSnapshot start = Now(*simulator, "dog");
    RunFor(simulator.get(), 10.0);
    const AgentSnapshot dog = Now(*simulator, "dog");
    EXPECT_NEAR(dog.position_m.z(), 0.0, 0.03);
    EXPECT_GT(Up(dog), 0.995);
    EXPECT_LT((dog.position_m - start.position_m).norm(), 0.1);
  }
}

TEST(QuadrupedTest, WalksAtTheCommandedSpeedEitherWay) {
  for (const double step_s : {0.005, 0.01}) {
    for (const double speed_mps : {0.8, 0.3, -0.5}) {
      const auto simulator = OneDog({}, step_s);
      RunWith(simulator.get(), 2.0, "dog", Forward(speed_mps));
      const double from_m = Now(*simulator, "dog").position_m.x();
      RunWith(simulator.get(), 4.0, "dog", Forward(speed_mps));
      const AgentSnapshot dog = Now(*simulator, "dog");
      EXPECT_NEAR((dog.position_m.x() - from_m) / 4.0, speed_mps, 0.2 * std::abs(speed_mps))
          << step_s;
      EXPECT_NEAR(dog.position_m.y(), 0.0, 0.5);
      EXPECT_GT(Up(dog), 0.98);
      EXPECT_NEAR(dog.position_m.z(), 0.0, 0.06);
    }
  }
}

TEST(QuadrupedTest, WalksSideways) {
  const auto simulator = OneDog();
  VelocityCommand command;
  command.linear_mps.y() = 0.4;
  RunWith(simulator.get(), 5.0, "dog", command);
  const AgentSnapshot dog = Now(*simulator, "dog");
  EXPECT_NEAR(dog.position_m.y(), 2.0, 0.4);
  EXPECT_NEAR(dog.position_m.x(), 0.0, 0.3);
}

TEST(QuadrupedTest, TurnsAtTheCommandedRate) {
  for (const double rate_radps : {0.8, -0.8}) {
    const auto simulator = OneDog();
    RunWith(simulator.get(), 1.0, "dog", Forward(0.0, rate_radps));
    const double from_rad = YawOf(Now(*simulator, "dog"));
    RunWith(simulator.get(), 3.0, "dog", Forward(0.0, rate_radps));
    const AgentSnapshot dog = Now(*simulator, "dog");
    EXPECT_NEAR(std::remainder(YawOf(dog) - from_rad - 3.0 * rate_radps, 2.0 * M_PI), 0.0, 0.36);
    EXPECT_LT(dog.position_m.head<2>().norm(), 0.4);
  }
}

TEST(QuadrupedTest, CrossesRoughGround) {
  const auto simulator = OneDog(Bumps());
  double least_up = 1.0;
  for (int i = 0; i < 80; ++i) {
    RunWith(simulator.get(), 0.1, "dog", Forward(0.8));
    least_up = std::min(least_up, Up(Now(*simulator, "dog")));
  }
  EXPECT_GT(Now(*simulator, "dog").position_m.x(), 0.8 * 0.8 * 8.0);
  EXPECT_GT(least_up, 0.9);
}

TEST(QuadrupedTest, ClimbsASlopeAndHoldsOnIt) {
  // The order in which constraints are solved, which the seed makes, shall not let it creep.
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto simulator = OneDog(Slope(15.0), 0.01, seed);
    RunWith(simulator.get(), 6.0, "dog", Forward(0.6));
    EXPECT_GT(Now(*simulator, "dog").position_m.x(), 0.8 * 0.6 * 6.0) << seed;
    RunFor(simulator.get(), 4.0);  // stops
    const Eigen::Vector3d start = Now(*simulator, "dog").position_m;
    RunFor(simulator.get(), 6.0);
    const AgentSnapshot dog = Now(*simulator, "dog");
    EXPECT_LT((dog.position_m - start).norm(), 0.15) << seed;
    EXPECT_GT(Up(dog), 0.9) << seed;
  }
}

constexpr const char* kLegNames[] = {"front_left", "front_right", "rear_left", "rear_right"};

// The same for that joint of every leg.
std::vector<JointCommand> OfEveryLeg(const std::string& joint, double position_rad,
                                     double velocity_radps, double effort_nm) {
  std::vector<JointCommand> commands;
  for (const std::string leg : kLegNames) {
    commands.push_back({leg + joint, position_rad, velocity_radps, effort_nm});
  }
  return commands;
}

void RunJoints(Simulator* simulator, double seconds, const std::vector<JointCommand>& commands) {
  for (int i = 0; i < seconds / 0.01 - 0.5; ++i) {
    ASSERT_TRUE(simulator->CommandJoints("dog", commands).ok());
    simulator->Step();
  }
}

JointSnapshot Joint(const Simulator& simulator, const std::string& name) {
  for (const JointSnapshot& joint : Now(simulator, "dog").joints) {
    if (joint.name == name) return joint;
  }
  ADD_FAILURE() << name;
  return {};
}

TEST(QuadrupedTest, JointsFollowPositionsVelocitiesAndEfforts) {
  const auto simulator = OneDog();
  RunFor(simulator.get(), 1.0);
  // It crouches on its four legs.
  std::vector<JointCommand> crouch = OfEveryLeg("_hip_pitch", 0.25, kNan, kNan);
  for (const JointCommand& knee : OfEveryLeg("_knee", -0.5, kNan, kNan)) crouch.push_back(knee);
  RunJoints(simulator.get(), 1.0, crouch);
  for (const std::string leg : kLegNames) {
    EXPECT_NEAR(Joint(*simulator, leg + "_hip_pitch").angle_rad, 0.25, 0.06) << leg;
    EXPECT_NEAR(Joint(*simulator, leg + "_knee").angle_rad, -0.5, 0.06) << leg;
  }
  EXPECT_LT(Now(*simulator, "dog").position_m.z(), -0.05);
  // Lower still, it swings a leg out at a rate.
  crouch = OfEveryLeg("_hip_pitch", 0.6, kNan, kNan);
  for (const JointCommand& knee : OfEveryLeg("_knee", -1.1, kNan, kNan)) crouch.push_back(knee);
  RunJoints(simulator.get(), 1.0, crouch);
  const double from_rad = Joint(*simulator, "front_left_hip_roll").angle_rad;
  crouch.push_back({"front_left_hip_roll", kNan, 0.5, kNan});
  RunJoints(simulator.get(), 0.6, crouch);
  EXPECT_NEAR(Joint(*simulator, "front_left_hip_roll").angle_rad, from_rad + 0.3, 0.06);
  EXPECT_NEAR(Joint(*simulator, "front_left_hip_roll").rate_radps, 0.5, 0.1);
}

TEST(QuadrupedTest, KneesGiveWayWithoutEffort) {
  const auto simulator = OneDog();
  RunFor(simulator.get(), 1.0);
  const double stretched_rad = Joint(*simulator, "front_right_knee").angle_rad;
  RunJoints(simulator.get(), 0.3, OfEveryLeg("_knee", kNan, kNan, 0.0));
  EXPECT_LT(Joint(*simulator, "front_right_knee").angle_rad, stretched_rad - 0.1);
}

TEST(QuadrupedTest, FallsWhereALegIsTakenFromUnderItGetsUpAndWalksAgain) {
  const auto simulator = OneDog();
  RunFor(simulator.get(), 1.0);
  RunJoints(simulator.get(), 1.5,
            {{"front_left_hip_pitch", -0.5, kNan, kNan}, {"front_left_knee", -0.6, kNan, kNan}});
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kKnockedOver, "dog"), 1);
  EXPECT_LT(Up(Now(*simulator, "dog")), 0.5);
  RunFor(simulator.get(), 6.0);
  EXPECT_GT(Up(Now(*simulator, "dog")), 0.98);
  EXPECT_NEAR(Now(*simulator, "dog").position_m.z(), 0.0, 0.06);
  const Eigen::Vector3d start_m = Now(*simulator, "dog").position_m;
  RunWith(simulator.get(), 4.0, "dog", Forward(0.5));
  EXPECT_GT((Now(*simulator, "dog").position_m - start_m).norm(), 0.8 * 0.5 * 4.0);
}

TEST(QuadrupedTest, NamesTwelveJoints) {
  const auto joints = JointsOf(SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kRoboticDog));
  ASSERT_EQ(joints.size(), 12u);
  EXPECT_EQ(joints[0].name, "front_left_hip_roll");
  EXPECT_EQ(joints[5].name, "front_right_knee");
  EXPECT_EQ(joints[11].name, "rear_right_knee");
}

TEST(QuadrupedTest, WhatLiesDeadFollowsNoCommandedJoint) {
  MindWorld world(TestScene{});
  Agent& dog = world.Add("robotic dog", 1, 0.0, 0.0);
  PhysicsWorld& physics = *world.Now().physics;
  // Mean effort of a hip in the last half of a second of so many; stops bear some of its weight.
  const auto effort_nm = [&](int steps) {
    double sum_nm = 0.0;
    for (int i = 0; i < steps; ++i) {
      Drive(&dog, {}, &world.Now());
      physics.Step(0.01, ++world.step);
      dog.motion = physics.MotionOf(dog.body);
      if (i >= steps - 50) sum_nm += std::abs(physics.JointOf(dog.body, 0).effort_nm) / 50.0;
    }
    return sum_nm;
  };
  const double most_nm = dog.species->quadruped->max_effort_nm;
  dog.posture.down = true;
  dog.joint_targets[0] = {JointMode::kVelocity, 3.0};  // against its stop
  ASSERT_GT(effort_nm(100), 0.8 * most_nm);
  dog.hit_points = 0.0;
  EXPECT_LT(effort_nm(200), 0.3 * most_nm);
}

}  // namespace
}  // namespace latticeworld
