#include "latticeworld/simulation/physics_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/ode_world.h"
#include "test_scene.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;

BodySpec Ball(double mass_kg, double radius_m) {
  BodySpec ball;
  ball.mass_kg = mass_kg;
  ball.inertia_kgm2 = Eigen::Vector3d::Constant(0.4 * mass_kg * radius_m * radius_m);
  ball.center_height_m = radius_m;
  ball.height_m = 2.0 * radius_m;
  ball.radius_m = radius_m;
  ball.ground_samples = {{{0.0, 0.0, radius_m}, radius_m}};
  return ball;
}

BodySpec Box(double mass_kg, double half_m, double height_m) {
  BodySpec box;
  box.mass_kg = mass_kg;
  box.inertia_kgm2 =
      Eigen::Vector3d(4 * half_m * half_m + height_m * height_m,
                      4 * half_m * half_m + height_m * height_m, 8 * half_m * half_m) *
      (mass_kg / 12.0);
  box.center_height_m = 0.5 * height_m;
  box.height_m = height_m;
  box.half_length_m = box.half_width_m = half_m;
  box.radius_m = std::sqrt(2.0) * half_m;
  for (const double x : {-half_m, half_m}) {
    for (const double y : {-half_m, half_m}) {
      for (const double z : {0.0, height_m}) box.ground_samples.push_back({{x, y, z}, 0.0});
    }
  }
  return box;
}

void StepFor(PhysicsWorld* physics, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep_s)); ++i) {
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
  }
}

TestScene Ramp(double slope_rad) {
  TestScene scene;
  scene.height_m = [slope_rad](double x, double) { return std::tan(slope_rad) * x; };
  return scene;
}

double FrictionOfGrass() { return DryPropertiesOf(SurfaceClass::kGrass).friction; }

TEST(PhysicsWorldTest, FreeFallFollowsGravity) {
  const auto physics = MakeOdeWorld(TestScene().Build());
  const BodyId ball = physics->Add(Ball(2.0, 0.2), {0.0, 0.0, 30.0}, 0.0);
  StepFor(physics.get(), 2.0);
  const BodyMotion motion = physics->MotionOf(ball);
  // Semi-implicit Euler: g t (t + dt) / 2.
  EXPECT_NEAR(motion.position_m.z(), 30.0 - 0.5 * kGravity_mps2 * 2.0 * 2.01, 1e-9);
  EXPECT_NEAR(motion.linear_velocity_mps.z(), -kGravity_mps2 * 2.0, 1e-9);
}

TEST(PhysicsWorldTest, FallenBallRestsOnTheGroundAndSleeps) {
  const auto physics = MakeOdeWorld(TestScene().Build());
  const BodyId ball = physics->Add(Ball(2.0, 0.2), {0.0, 0.0, 3.0}, 0.0);
  StepFor(physics.get(), 4.0);
  EXPECT_NEAR(physics->MotionOf(ball).position_m.z(), 0.0, 0.003);
  EXPECT_LT(physics->SinkageOf(ball), 0.003);
  EXPECT_TRUE(physics->IsResting(ball));
  physics->AddForce(ball, {0.0, 0.0, 100.0});
  physics->Step(kStep_s, 0);
  EXPECT_FALSE(physics->IsResting(ball));
  EXPECT_GT(physics->MotionOf(ball).linear_velocity_mps.z(), 0.1);
}

TEST(PhysicsWorldTest, BallRollsDownARampAtFiveSeventhsOfItsPull) {
  const double slope_rad = 0.2;
  const auto physics = MakeOdeWorld(Ramp(slope_rad).Build());
  const double radius_m = 0.25;
  const BodyId ball =
      physics->Add(Ball(3.0, radius_m), {10.0, 0.0, 10.0 * std::tan(slope_rad)}, 0.0);
  StepFor(physics.get(), 0.2);
  const BodyMotion start = physics->MotionOf(ball);
  StepFor(physics.get(), 1.0);
  const BodyMotion end = physics->MotionOf(ball);
  // Velocity of the centre: base_link turns with the ball, so it takes the trip around.
  const auto center_velocity = [radius_m](const BodyMotion& motion) {
    const Eigen::Vector3d arm = motion.orientation * Eigen::Vector3d(0, 0, radius_m);
    return Eigen::Vector3d(motion.linear_velocity_mps + motion.angular_velocity_radps.cross(arm));
  };
  const double gained_mps = (center_velocity(end) - center_velocity(start)).norm();
  EXPECT_NEAR(gained_mps, 5.0 / 7.0 * kGravity_mps2 * std::sin(slope_rad), 0.03);
}

TEST(PhysicsWorldTest, BoxSlidesOnlyBeyondTheAngleOfFriction) {
  const double critical_rad = std::atan(FrictionOfGrass());
  for (const double offset_rad : {-0.08, 0.08}) {
    const double slope_rad = critical_rad + offset_rad;
    const auto physics = MakeOdeWorld(Ramp(slope_rad).Build());
    BodySpec spec = Box(10.0, 0.4, 0.1);
    BodyMotion motion;
    motion.position_m = {5.0, 0.0, 5.0 * std::tan(slope_rad) + 0.01};
    motion.orientation = Eigen::AngleAxisd(-slope_rad, Eigen::Vector3d::UnitY());
    const BodyId box = physics->Add(spec, motion.position_m, 0.0);
    physics->Place(box, motion);
    StepFor(physics.get(), 0.3);
    const double before_m = physics->MotionOf(box).position_m.x();
    StepFor(physics.get(), 1.0);
    const double slid_m = before_m - physics->MotionOf(box).position_m.x();
    if (offset_rad < 0.0) {
      EXPECT_LT(slid_m, 0.02);
    } else {
      EXPECT_GT(slid_m, 0.1);
    }
  }
}

TEST(PhysicsWorldTest, BodiesDoNotPassThroughEachOther) {
  const auto physics = MakeOdeWorld(TestScene().Build());
  BodySpec walker = Ball(50.0, 0.4);
  walker.upright = true;
  walker.ground_samples = {{Eigen::Vector3d::Zero(), 0.0}};
  const BodyId a = physics->Add(walker, {-2.0, 0.0, 0.0}, 0.0);
  const BodyId b = physics->Add(walker, {2.0, 0.05, 0.0}, 0.0);
  physics->SetWalkVelocity(a, {1.0, 0.0, 0.0});
  physics->SetWalkVelocity(b, {-1.0, 0.0, 0.0});
  for (int i = 0; i < 600; ++i) {
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    const Eigen::Vector3d gap = physics->MotionOf(a).position_m - physics->MotionOf(b).position_m;
    ASSERT_GT(gap.head<2>().norm(), 0.8 - 0.03);
  }
}

TEST(PhysicsWorldTest, StandingNeighboursFallAsleepAndAMovingOneWakesThem) {
  const auto physics = MakeOdeWorld(TestScene().Build());
  BodySpec walker = Ball(50.0, 0.4);
  walker.upright = true;
  walker.ground_samples = {{Eigen::Vector3d::Zero(), 0.0}};
  const BodyId a = physics->Add(walker, {0.0, 0.0, 0.0}, 0.0);
  const BodyId b = physics->Add(walker, {0.79, 0.0, 0.0}, 0.0);
  StepFor(physics.get(), 3.0);
  EXPECT_TRUE(physics->IsResting(a));
  EXPECT_TRUE(physics->IsResting(b));
  walker.mass_kg = 400.0;  // has the traction to push both
  const BodyId mover = physics->Add(walker, {-3.0, 0.0, 0.0}, 0.0);
  physics->SetWalkVelocity(mover, {2.0, 0.0, 0.0});
  const double before_m = physics->MotionOf(a).position_m.x();
  StepFor(physics.get(), 3.0);
  EXPECT_GT(physics->MotionOf(a).position_m.x(), before_m + 0.05);
}

TEST(PhysicsWorldTest, RemovedBodiesAreGone) {
  const auto physics = MakeOdeWorld(TestScene().Build());
  const BodyId a = physics->Add(Ball(1.0, 0.3), {0.0, 0.0, 0.0}, 0.0);
  const BodyId b = physics->Add(Ball(1.0, 0.3), {0.0, 0.0, 0.6}, 0.0);
  physics->Remove(a);
  StepFor(physics.get(), 2.0);
  EXPECT_NEAR(physics->MotionOf(b).position_m.z(), 0.0, 0.003);
  EXPECT_NE(physics->Add(Ball(1.0, 0.3), {5.0, 0.0, 0.0}, 0.0), a);
}

TEST(PhysicsWorldTest, WorldsInOneProcessDoNotSeeEachOther) {
  const auto build = [] {
    auto physics = MakeOdeWorld(TestScene().Build());
    for (int i = 0; i < 8; ++i) {
      physics->Add(Box(5.0, 0.3, 0.4), {0.05 * i, 0.03 * i, 0.2 + 0.5 * i}, 0.2 * i);
    }
    return physics;
  };
  const auto alone = build();
  StepFor(alone.get(), 3.0);
  const auto first = build();
  const auto second = build();
  for (int i = 0; i < 300; ++i) {
    first->Step(kStep_s, static_cast<std::uint64_t>(i));
    second->Step(kStep_s, static_cast<std::uint64_t>(i) + 17);
  }
  Digest of_alone, of_first;
  alone->AddTo(&of_alone);
  first->AddTo(&of_first);
  EXPECT_EQ(of_alone.Hex(), of_first.Hex());
}

}  // namespace
}  // namespace latticeworld
