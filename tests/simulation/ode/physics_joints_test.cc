// Wheels, links and anchors of a PhysicsWorld.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "simulation/ode/back_ends.h"

namespace latticeworld {
namespace {

using PhysicsJointsTest = PhysicsContract;

BodySpec SprungRobot(double max_steering_rad) {
  BodySpec robot = Robot();
  for (WheelSpec& wheel : robot.wheels) {
    wheel.spring_npm = 2500.0;
    wheel.damper_nspm = 150.0;
    wheel.travel_m = 0.04;
    if (wheel.center_m.x() > 0.0) wheel.max_steering_rad = max_steering_rad;
  }
  return robot;
}

TEST_P(PhysicsJointsTest, DrivenWheelsTakeARobotForwardAtTheirRate) {
  for (const BodySpec& spec : {Robot(), SprungRobot(0.0), SprungRobot(0.5)}) {
    const auto physics = Make();
    const BodyId robot = physics->Add(spec, {-10.0, 0.0, 0.0}, 0.0);
    DriveAll(physics.get(), robot, 10.0);
    StepFor(physics.get(), 5.0);
    const BodyMotion motion = physics->MotionOf(robot);
    EXPECT_NEAR(motion.linear_velocity_mps.x(), 1.2, 0.06);
    EXPECT_NEAR(motion.position_m.y(), 0.0, 0.05);
    EXPECT_NEAR(physics->WheelOf(robot, 0).rate_radps, 10.0, 0.5);
    EXPECT_GT(physics->WheelOf(robot, 0).effort_nm, 0.0);
  }
}

TEST_P(PhysicsJointsTest, FreeWheelsAreRolledByTheOthers) {
  BodySpec spec = Robot();
  spec.wheels[2].max_torque_nm = spec.wheels[3].max_torque_nm = 0.0;
  const auto physics = Make();
  const BodyId robot = physics->Add(spec, {-10.0, 0.0, 0.0}, 0.0);
  DriveAll(physics.get(), robot, 8.0);
  StepFor(physics.get(), 4.0);
  EXPECT_NEAR(physics->MotionOf(robot).linear_velocity_mps.x(), 0.96, 0.06);
  EXPECT_NEAR(physics->WheelOf(robot, 2).rate_radps, 8.0, 0.5);
  DriveAll(physics.get(), robot, 0.0);
  StepFor(physics.get(), 1.0);
  EXPECT_LT(physics->MotionOf(robot).linear_velocity_mps.norm(), 0.02);
}

TEST_P(PhysicsJointsTest, SprungRobotStandsWithItsWheelsInTheirPlaces) {
  const auto physics = Make();
  const BodyId robot = physics->Add(SprungRobot(0.0), {0.0, 0.0, 0.0}, 0.0);
  StepFor(physics.get(), 3.0);
  EXPECT_NEAR(physics->MotionOf(robot).position_m.z(), 0.0, 0.004);
  EXPECT_TRUE(physics->IsResting(robot));
}

// A weight on top makes every spring shorter by its share over the stiffness.
TEST_P(PhysicsJointsTest, SpringsGiveByLoadOverStiffness) {
  const auto physics = Make();
  const BodyId robot = physics->Add(SprungRobot(0.0), {0.0, 0.0, 0.0}, 0.0);
  StepFor(physics.get(), 1.0);
  const double before_m = physics->MotionOf(robot).position_m.z();
  for (int i = 0; i < 200; ++i) {
    physics->AddForce(robot, {0.0, 0.0, -200.0});
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
  }
  EXPECT_NEAR(before_m - physics->MotionOf(robot).position_m.z(), 200.0 / (4 * 2500.0), 0.003);
  // Far beyond their travel a stop takes over.
  for (int i = 0; i < 200; ++i) {
    physics->AddForce(robot, {0.0, 0.0, -2000.0});
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
  }
  EXPECT_LT(before_m - physics->MotionOf(robot).position_m.z(), 0.06);
}

// The circle of an Ackermann vehicle with both axles' middles: radius = wheelbase / tan(angle).
TEST_P(PhysicsJointsTest, SteeredWheelsTurnARobotLeftOnTheCircleOfTheirAngle) {
  BodySpec spec = SprungRobot(0.6);
  const auto physics = Make();
  const BodyId robot = physics->Add(spec, {0.0, 0.0, 0.0}, 0.0);
  const double base_m = 0.4, track_m = 0.44, radius_m = 1.6;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& center = spec.wheels[i].center_m;
    const double from_center_m = radius_m - center.y();
    const double steer_rad = center.x() > 0.0 ? std::atan(base_m / from_center_m) : 0.0;
    const double path_m = std::hypot(from_center_m, center.x() > 0.0 ? base_m : 0.0);
    physics->SetWheel(robot, i, 0.8 / 0.12 * path_m / radius_m, steer_rad);
  }
  (void)track_m;
  StepFor(physics.get(), 3.0);
  const BodyMotion motion = physics->MotionOf(robot);
  const double turning_m = motion.linear_velocity_mps.head<2>().norm() /
                           std::max(1e-6, motion.angular_velocity_radps.z());
  EXPECT_NEAR(turning_m, radius_m, 0.15 * radius_m);
  EXPECT_NEAR(physics->SteeringOf(robot, 2).angle_rad, std::atan(base_m / (radius_m + 0.22)), 0.02);
  EXPECT_EQ(physics->SteeringOf(robot, 0).angle_rad, 0.0);
}

// An arm of 2 kg and 0.5 m on a heavy base, its hinge along y.
BodySpec Arm() {
  BodySpec base = Box(200.0, {0.5, 0.5, 0.2});
  LinkSpec arm;
  arm.mass_kg = 2.0;
  arm.inertia_kgm2 = BoxInertia(2.0, {0.25, 0.02, 0.02});
  arm.anchor_m = {0.0, 0.0, 1.0};
  arm.center_m = {0.25, 0.0, 1.0};
  arm.low_rad = -1.0;
  arm.high_rad = 1.2;
  arm.max_effort_nm = 12.0;
  arm.max_rate_radps = 4.0;
  base.links.push_back(arm);
  base.may_rest = false;
  return base;
}

TEST_P(PhysicsJointsTest, PositionIsReachedAndHeldAgainstGravity) {
  const auto physics = Make();
  const BodyId body = physics->Add(Arm(), {0.0, 0.0, 0.0}, 0.3);
  physics->SetJoint(body, 0, {JointMode::kPosition, -0.5});
  StepFor(physics.get(), 1.0);
  const JointReading reading = physics->JointOf(body, 0);
  EXPECT_NEAR(reading.angle_rad, -0.5, 0.01);
  EXPECT_NEAR(reading.rate_radps, 0.0, 0.02);
  // About y, positive downwards: it holds the arm up against its weight.
  EXPECT_NEAR(reading.effort_nm, -2.0 * kGravity_mps2 * 0.25 * std::cos(0.5), 0.2);
  const BodyMotion frame = physics->LinkMotionOf(body, 0);
  EXPECT_NEAR(frame.position_m.z(), physics->MotionOf(body).position_m.z() + 1.0, 1e-3);
  EXPECT_NEAR((frame.orientation * Eigen::Vector3d::UnitX()).z(), std::sin(0.5), 0.01);
}

TEST_P(PhysicsJointsTest, VelocityIsHeldWithinTheJointsRateAndStops) {
  const auto physics = Make();
  const BodyId body = physics->Add(Arm(), {0.0, 0.0, 0.0}, 0.0);
  physics->SetJoint(body, 0, {JointMode::kVelocity, -1.0});
  StepFor(physics.get(), 0.5);
  EXPECT_NEAR(physics->JointOf(body, 0).rate_radps, -1.0, 0.05);
  EXPECT_NEAR(physics->JointOf(body, 0).angle_rad, -0.5, 0.05);
  physics->SetJoint(body, 0, {JointMode::kVelocity, 100.0});
  StepFor(physics.get(), 0.2);
  EXPECT_LT(physics->JointOf(body, 0).rate_radps, 4.2);
  StepFor(physics.get(), 1.0);
  EXPECT_NEAR(physics->JointOf(body, 0).angle_rad, 1.2, 0.03);
}

TEST_P(PhysicsJointsTest, EffortMovesTheArmAsMuchAsItSays) {
  const auto physics = Make();
  const BodyId body = physics->Add(Arm(), {0.0, 0.0, 0.0}, 0.0);
  // What its weight asks for holds it level; the rest makes it faster by its inertia.
  const double weight_nm = 2.0 * kGravity_mps2 * 0.25;
  physics->SetJoint(body, 0, {JointMode::kEffort, -weight_nm - 0.2});
  StepFor(physics.get(), 0.3);
  const double about_anchor = BoxInertia(2.0, {0.25, 0.02, 0.02}).y() + 2.0 * 0.25 * 0.25;
  EXPECT_NEAR(physics->JointOf(body, 0).rate_radps, -0.2 / about_anchor * 0.3, 0.03);
  EXPECT_NEAR(physics->JointOf(body, 0).effort_nm, -weight_nm - 0.2, 0.05);
  // No more than the motor has.
  physics->SetJoint(body, 0, {JointMode::kEffort, 1e9});
  physics->Step(kStep_s, 0);
  EXPECT_LE(physics->JointOf(body, 0).effort_nm, 12.0 + 1e-6);
}

TEST_P(PhysicsJointsTest, FreeJointSwingsAsAPendulum) {
  BodySpec spec = Arm();
  spec.links[0].low_rad = -M_PI;
  spec.links[0].high_rad = M_PI;
  spec.anchor = AnchorSpec();
  // Held fast, nothing of a body moves: the base is heavy instead.
  spec.anchor.reset();
  const auto physics = Make();
  const BodyId body = physics->Add(spec, {0.0, 0.0, 0.0}, 0.0);
  physics->SetJoint(body, 0, {JointMode::kPosition, M_PI / 2 - 0.2});
  StepFor(physics.get(), 1.5);
  physics->SetJoint(body, 0, {JointMode::kFree, 0.0});
  double crossed_s[2] = {0.0, 0.0};
  int crossings = 0;
  double last_rad = -0.2;
  for (int i = 0; i < 400 && crossings < 2; ++i) {
    physics->Step(0.005, static_cast<std::uint64_t>(i));
    const double angle_rad = physics->JointOf(body, 0).angle_rad - M_PI / 2;
    if (last_rad * angle_rad < 0.0) crossed_s[crossings++] = 0.005 * i;
    last_rad = angle_rad;
  }
  ASSERT_EQ(crossings, 2);
  const double about_anchor = BoxInertia(2.0, {0.25, 0.02, 0.02}).y() + 2.0 * 0.25 * 0.25;
  const double half_period_s = M_PI * std::sqrt(about_anchor / (2.0 * kGravity_mps2 * 0.25));
  EXPECT_NEAR(crossed_s[1] - crossed_s[0], half_period_s, 0.02);
}

TEST_P(PhysicsJointsTest, FixedBodyHoldsUntilItComesLoose) {
  const auto physics = Make();
  BodySpec spec = Box(20.0, {0.5, 0.5, 0.1});
  spec.anchor = AnchorSpec();
  const BodyId deck = physics->Add(spec, {0.0, 0.0, 2.0}, 0.0);
  const BodyId ball = physics->Add(Ball(5.0, 0.2), {0.0, 0.0, 2.5}, 0.0);
  physics->AddImpulse(deck, {1000.0, 0.0, 0.0}, {0.0, 0.0, 2.1});
  StepFor(physics.get(), 2.0);
  EXPECT_EQ(physics->MotionOf(deck).position_m, Eigen::Vector3d(0.0, 0.0, 2.0));
  EXPECT_NEAR(physics->MotionOf(ball).position_m.z(), 2.2, 0.01);
  EXPECT_TRUE(physics->IsResting(ball));
  EXPECT_TRUE(physics->IsAnchored(deck));
  physics->SetAnchored(deck, false);
  EXPECT_FALSE(physics->IsAnchored(deck));
  StepFor(physics.get(), 2.0);
  EXPECT_LT(physics->MotionOf(deck).position_m.z(), 0.02);
  EXPECT_LT(physics->MotionOf(ball).position_m.z(), 0.3);
}

BodySpec Gate(double friction_nm) {
  BodySpec gate = Box(30.0, {0.04, 1.0, 0.5});
  gate.ground_samples.clear();
  gate.anchor.emplace();
  gate.anchor->kind = AnchorKind::kHinge;
  gate.anchor->pivot_m = {0.0, -1.0, 0.0};
  gate.anchor->low_rad = -1.5;
  gate.anchor->high_rad = 1.5;
  gate.anchor->friction_nm = friction_nm;
  return gate;
}

TEST_P(PhysicsJointsTest, GateTurnsAboutItsHingeUpToItsStop) {
  const auto physics = Make();
  const BodyId gate = physics->Add(Gate(5.0), {0.0, 0.0, 0.1}, 0.0);
  const Eigen::Vector3d pivot(0.0, -1.0, 0.1);
  StepFor(physics.get(), 1.0);
  EXPECT_NEAR(physics->AnchorAngleOf(gate), 0.0, 1e-4);
  for (int i = 0; i < 300; ++i) {
    physics->AddTorque(gate, {0.0, 0.0, -40.0});
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
  }
  EXPECT_NEAR(physics->AnchorAngleOf(gate), -1.5, 0.05);
  const BodyMotion motion = physics->MotionOf(gate);
  const Eigen::Vector3d now = motion.position_m + motion.orientation * Eigen::Vector3d(0, -1, 0);
  EXPECT_LT((now - pivot).norm(), 0.01);
  EXPECT_NEAR(motion.yaw_rad(), physics->AnchorAngleOf(gate), 1e-6);
}

TEST_P(PhysicsJointsTest, GateHoldsAgainstLessThanItsFriction) {
  const auto physics = Make();
  const BodyId gate = physics->Add(Gate(30.0), {0.0, 0.0, 0.1}, 0.0);
  for (int i = 0; i < 200; ++i) {
    physics->AddTorque(gate, {0.0, 0.0, 25.0});
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
  }
  EXPECT_NEAR(physics->AnchorAngleOf(gate), 0.0, 0.01);
}

TEST_P(PhysicsJointsTest, WalkerPushesAGateOpen) {
  const auto physics = Make();
  const BodyId gate = physics->Add(Gate(10.0), {0.0, 0.0, 0.1}, 0.0);
  const BodyId walker = physics->Add(Walker(80.0, 0.3), {-1.5, 0.5, 0.0}, 0.0);
  StepFor(physics.get(), 1.5);  // the gate sleeps
  EXPECT_TRUE(physics->IsResting(gate));
  physics->SetWalkVelocity(walker, {1.0, 0.0, 0.0});
  StepFor(physics.get(), 4.0);
  EXPECT_LT(physics->AnchorAngleOf(gate), -0.5);
  EXPECT_GT(physics->MotionOf(walker).position_m.x(), 0.3);
}

LATTICEWORLD_ON_EVERY_BACK_END(PhysicsJointsTest);

}  // namespace
}  // namespace latticeworld
