#include "latticeworld/simulation/physics_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "simulation/ode/back_ends.h"

namespace latticeworld {
namespace {

using PhysicsWorldTest = PhysicsContract;

TestScene Ramp(double slope_rad) {
  TestScene scene;
  scene.height_m = [slope_rad](double x, double) { return std::tan(slope_rad) * x; };
  return scene;
}

TEST_P(PhysicsWorldTest, FreeFallFollowsGravity) {
  const auto physics = Make();
  const BodyId ball = physics->Add(Ball(2.0, 0.2), {0.0, 0.0, 30.0}, 0.0);
  StepFor(physics.get(), 2.0);
  const BodyMotion motion = physics->MotionOf(ball);
  // Semi-implicit Euler: g t (t + dt) / 2.
  EXPECT_NEAR(motion.position_m.z(), 30.0 - 0.5 * kGravity_mps2 * 2.0 * 2.01, 1e-9);
  EXPECT_NEAR(motion.linear_velocity_mps.z(), -kGravity_mps2 * 2.0, 1e-9);
}

TEST_P(PhysicsWorldTest, FallenBallRestsOnTheGroundAndSleeps) {
  const auto physics = Make();
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

TEST_P(PhysicsWorldTest, BallRollsDownARampAtFiveSeventhsOfItsPull) {
  const double slope_rad = 0.2;
  const auto physics = Make(Ramp(slope_rad));
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

TEST_P(PhysicsWorldTest, BoxSlidesOnlyBeyondTheAngleOfFriction) {
  const double critical_rad = std::atan(Friction(SurfaceClass::kGrass));
  for (const double offset_rad : {-0.08, 0.08}) {
    const double slope_rad = critical_rad + offset_rad;
    const auto physics = Make(Ramp(slope_rad));
    BodyMotion motion;
    motion.position_m = {5.0, 0.0, 5.0 * std::tan(slope_rad) + 0.01};
    motion.orientation = Eigen::AngleAxisd(-slope_rad, Eigen::Vector3d::UnitY());
    const BodyId box = physics->Add(Box(10.0, {0.4, 0.4, 0.05}), motion);
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

TEST_P(PhysicsWorldTest, BodiesDoNotPassThroughEachOther) {
  const auto physics = Make();
  BodySpec walker = Walker(50.0);
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

TEST_P(PhysicsWorldTest, StandingNeighboursFallAsleepAndAMovingOneWakesThem) {
  const auto physics = Make();
  BodySpec walker = Walker(50.0);
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

TEST_P(PhysicsWorldTest, RemovedBodiesAreGone) {
  const auto physics = Make();
  const BodyId a = physics->Add(Ball(1.0, 0.3), {0.0, 0.0, 0.0}, 0.0);
  const BodyId b = physics->Add(Ball(1.0, 0.3), {0.0, 0.0, 0.6}, 0.0);
  physics->Remove(a);
  StepFor(physics.get(), 2.0);
  EXPECT_NEAR(physics->MotionOf(b).position_m.z(), 0.0, 0.003);
  EXPECT_NE(physics->Add(Ball(1.0, 0.3), {5.0, 0.0, 0.0}, 0.0), a);
}

TEST_P(PhysicsWorldTest, WorldsInOneProcessDoNotSeeEachOther) {
  const auto build = [] {
    auto physics = Make();
    for (int i = 0; i < 8; ++i) {
      physics->Add(Box(5.0, {0.3, 0.3, 0.2}), {0.05 * i, 0.03 * i, 0.2 + 0.5 * i}, 0.2 * i);
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
  EXPECT_EQ(DigestOf(*alone), DigestOf(*first));
}

LATTICEWORLD_ON_EVERY_BACK_END(PhysicsWorldTest);

}  // namespace
}  // namespace latticeworld
