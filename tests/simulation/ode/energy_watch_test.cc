// No body gains energy out of nothing, and none that moves by right is taken for one that does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulation/battle/battle.h"
#include "simulation/ode/back_ends.h"

namespace latticeworld {
namespace {

using EnergyWatchTest = PhysicsContract;

constexpr double kFastestPart_mps = 2.0;  // that putting right what is torn may make a body

// Its arm begins beyond its stop: the joint wants 1.2 rad undone at once.
BodySpec Torn() {
  BodySpec body = Box(20.0, {0.3, 0.3, 0.1});
  LinkSpec arm;
  arm.mass_kg = 5.0;
  arm.inertia_kgm2 = Eigen::Vector3d::Constant(0.2);
  arm.anchor_m = {0.0, 0.0, 0.1};
  arm.center_m = {0.5, 0.0, 0.1};
  arm.low_rad = 1.2;
  arm.high_rad = 1.5;
  body.links = {arm};
  return body;
}

double MotionEnergyOf(const PhysicsWorld& physics, BodyId body) {
  const double mass_kg = physics.SpecOf(body).total_mass_kg();
  return physics.EnergyOf(body) - mass_kg * kGravity_mps2 * physics.MotionOf(body).position_m.z();
}

TEST_P(EnergyWatchTest, AJointThatIsTornDoesNotShootItsBodyOff) {
  const auto physics = Make();
  const BodyId body = physics->Add(Torn(), {0.0, 0.0, 10.0}, 0.0);
  const double allowed_j = 0.5 * 25.0 * kFastestPart_mps * kFastestPart_mps;
  const double before_j = MotionEnergyOf(*physics, body);
  physics->Step(kStep_s, 0);
  EXPECT_EQ(physics->slowed(), std::vector<BodyId>{body});
  // What lies higher than base_link counts as well: 0.2 m of the arm's way at most.
  EXPECT_LT(MotionEnergyOf(*physics, body), before_j + allowed_j + 5.0 * kGravity_mps2 * 0.2);
  // The joint heals, and the body falls as any other.
  for (std::uint64_t i = 1; i < 400; ++i) {
    physics->Step(kStep_s, i);
    EXPECT_TRUE(physics->strayed().empty()) << i;
  }
  EXPECT_NEAR(physics->JointOf(body, 0).angle_rad, 1.35, 0.25);
  EXPECT_LT(physics->MotionOf(body).position_m.z(), 1.0);
}

TEST_P(EnergyWatchTest, WhatIsPutIntoAnotherComesOutSlowly) {
  const std::vector<double> masses_kg = {5.0, 50.0, 5000.0};
  for (const double mass_kg : masses_kg) {
    for (const double beside_m : {0.0, 0.01, 0.3}) {
      const auto physics = Make();
      const BodyId a = physics->Add(Box(mass_kg, {0.4, 0.4, 0.4}), {0.0, 0.0, 0.01}, 0.0);
      const BodyId b = physics->Add(Box(5.0, {0.4, 0.4, 0.4}), {beside_m, 0.0, 0.1}, 0.3);
      const BodyId robot = physics->Add(Robot(), {0.1, beside_m, 0.0}, 0.0);
      double fastest_mps = 0.0;
      for (int i = 0; i < 300; ++i) {
        physics->Step(kStep_s, static_cast<std::uint64_t>(i));
        for (const BodyId body : {a, b, robot}) {
          fastest_mps = std::max(fastest_mps, physics->MotionOf(body).linear_velocity_mps.norm());
        }
      }
      // Out at 2 m/s, and down from where it was pushed to.
      EXPECT_LT(fastest_mps, 8.0) << mass_kg << " " << beside_m;
    }
  }
}

TEST_P(EnergyWatchTest, FallsAndCollisionsAreLeftAlone) {
  TestScene scene;
  scene.AddBuilding(8.0, 0.0, 1.0, 6.0);
  scene.AddTree(-8.0, 0.0, 0.05);
  BodySpec sprung = Robot();
  for (WheelSpec& wheel : sprung.wheels) {
    wheel.spring_npm = 2500.0;
    wheel.damper_nspm = 150.0;
    wheel.travel_m = 0.04;
  }
  const std::vector<BodySpec> specs = {Ball(4.0, 0.3), Box(40.0, {0.5, 0.1, 0.05}), Robot(), sprung,
                                       Walker(60.0, 0.3)};
  for (const double step_s : {0.002, 0.01, 0.02}) {
    for (std::size_t k = 0; k < specs.size(); ++k) {
      for (const double speed_mps : {0.0, 20.0, -20.0}) {
        const auto physics = Make(scene);
        BodyMotion motion;
        motion.position_m = {0.0, 0.0, 8.0};
        motion.orientation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 0.5).normalized());
        motion.linear_velocity_mps = {speed_mps, 0.0, 0.0};
        motion.angular_velocity_radps = {3.0, -20.0, 5.0};
        physics->Add(specs[k], motion);
        motion.position_m = {1.5, 0.1, 3.0};
        motion.linear_velocity_mps = -motion.linear_velocity_mps;
        physics->Add(specs[(k + 1) % specs.size()], motion);
        for (int i = 0; i < static_cast<int>(3.0 / step_s); ++i) {
          physics->Step(step_s, static_cast<std::uint64_t>(i));
          ASSERT_TRUE(physics->slowed().empty())
              << "spec " << k << ", speed " << speed_mps << ", step " << step_s << ", after " << i;
        }
      }
    }
  }
}

TEST_P(EnergyWatchTest, AFreeFallIsNotSlowedDown) {
  const auto physics = Make();
  const BodyId body = physics->Add(Box(40.0, {0.5, 0.1, 0.05}), {0.0, 0.0, 500.0}, 0.0);
  StepFor(physics.get(), 8.0);
  EXPECT_NEAR(physics->MotionOf(body).linear_velocity_mps.z(), -kGravity_mps2 * 8.0, 1e-9);
  EXPECT_TRUE(physics->strayed().empty());
}

// Arm and body so long that its joint asks for more than can be given for seconds.
TEST_P(EnergyWatchTest, WhatGoesOnGainingEnergyIsPutBackAndListed) {
  const auto physics = Make();
  BodySpec spec = Torn();
  spec.inertia_kgm2 = BoxInertia(spec.mass_kg, {10.0, 10.0, 0.1});
  spec.links[0].center_m = {20.0, 0.0, 0.1};
  const BodyId body = physics->Add(spec, {0.0, 0.0, 20.0}, 0.0);
  int excess = 0;  // steps that slowed it down, less the others
  bool listed = false;
  BodyMotion before;
  for (int i = 1; i <= 60 && !listed; ++i) {
    before = physics->MotionOf(body);
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    excess += physics->slowed().empty() ? -1 : 1;
    listed = physics->strayed() == std::vector<BodyId>{body};
  }
  EXPECT_TRUE(listed);
  EXPECT_NEAR(excess, 26, 1);  // it has a quarter of a second
  const BodyMotion after = physics->MotionOf(body);
  EXPECT_LT((after.position_m - before.position_m).norm(), 1e-12);
  EXPECT_EQ(after.linear_velocity_mps.norm() + after.angular_velocity_radps.norm(), 0.0);
}

TEST_P(EnergyWatchTest, AWorldThatIsWatchedGoesOnTheSameAfterRestore) {
  const auto physics = Make();
  physics->Add(Torn(), {0.0, 0.0, 2.0}, 0.0);
  physics->Add(Torn(), {0.2, 0.1, 2.2}, 1.0);
  StepFor(physics.get(), 0.02);
  ASSERT_FALSE(physics->slowed().empty());
  const auto snapshot = physics->Save();
  StepFor(physics.get(), 2.0, 2);
  const std::string straight = DigestOf(*physics);
  physics->Restore(*snapshot);
  StepFor(physics.get(), 2.0, 2);
  EXPECT_EQ(DigestOf(*physics), straight);
  const auto other = Make();
  other->Restore(*snapshot);
  StepFor(other.get(), 2.0, 2);
  EXPECT_EQ(DigestOf(*other), straight);
}

// A hundred fight, and trees fall.
TEST(EnergyWatchBattleTest, NobodyIsFrozenInABattle) {
  const auto simulator = BeginBattle(BattleScene(), 3);
  int felled = 0, frozen = 0;
  for (int i = 0; i < 2000; ++i) {
    StepBattle(simulator.get());
    for (const Event& event : simulator->TakeEvents()) {
      felled += event.kind == EventKind::kFelledTree ? 1 : 0;
      frozen += event.kind == EventKind::kFrozen ? 1 : 0;
    }
  }
  EXPECT_GT(felled, 0);
  EXPECT_EQ(frozen, 0);
}

LATTICEWORLD_ON_EVERY_BACK_END(EnergyWatchTest);

}  // namespace
}  // namespace latticeworld
