// What a PhysicsWorld does at the limits: huge and meaningless numbers, sleepers that lose their
// stand, the edge of the world.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/simulation/water_forces.h"
#include "simulation/ode/back_ends.h"

namespace latticeworld {
namespace {

using PhysicsLimitsTest = PhysicsContract;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

BodySpec Table() {
  BodySpec table = Box(20.0, {0.3, 0.2, 0.1});
  table.shapes[0].center_m.z() += 0.5;
  table.center_height_m = 0.6;
  table.ground_samples.clear();
  for (const double x : {-0.3, 0.3}) {
    for (const double y : {-0.2, 0.2}) {
      LinkSpec leg;
      leg.inertia_kgm2 = Eigen::Vector3d::Constant(0.02);
      leg.anchor_m = {x, y, 0.5};
      leg.center_m = {x, y, 0.25};
      leg.max_effort_nm = 50.0;
      leg.ground_samples = {{{x, y, 0.02}, 0.02}};
      table.links.push_back(leg);
    }
  }
  return table;
}

BodyId AddDeck(PhysicsWorld* physics) {
  BodySpec deck = Box(500.0, {2.0, 1.0, 0.1});
  deck.anchor.emplace();
  return physics->Add(deck, {0.0, 0.0, 3.0}, 0.0);
}

// On a slope, crates that rest side by side are told apart by the last bits of where they are.
TEST_P(PhysicsLimitsTest, ARunBesideSleepersIsTheSameAfterRestore) {
  const double slope = 0.45;
  TestScene scene;
  scene.height_m = [slope](double x, double) { return slope * x; };
  for (int trial = 0; trial < 6; ++trial) {
    const auto physics = Make(scene);
    RandomStream random(trial, "x");
    BodyMotion motion;
    motion.orientation = Eigen::AngleAxisd(-std::atan(slope), Eigen::Vector3d::UnitY());
    for (int i = 0; i < 24; ++i) {
      const double x_m = random.Uniform(-3e-5, 3e-5);
      motion.position_m = {x_m, -6.0 + 0.5 * i, slope * x_m + 0.002};
      physics->Add(Box(random.Uniform(3.0, 9.0), {0.25, 0.249, 0.25}), motion);
    }
    StepFor(physics.get(), 2.5);
    motion.position_m = {1.0, 0.0, slope + 0.02};
    motion.linear_velocity_mps = {-3.0, 0.0, -3.0 * slope};
    physics->Add(Box(400.0, {0.3, 6.2, 0.3}), motion);
    const auto snapshot = physics->Save();
    StepFor(physics.get(), 2.5, 250);
    const std::string straight = DigestOf(*physics);
    physics->Restore(*snapshot);
    StepFor(physics.get(), 2.5, 250);
    EXPECT_EQ(DigestOf(*physics), straight) << trial;
    const auto other = Make(scene);
    other->Restore(*snapshot);
    StepFor(other.get(), 2.5, 250);
    EXPECT_EQ(DigestOf(*other), straight) << trial;
  }
}

TEST_P(PhysicsLimitsTest, NoForceOrBlowMovesABodyFurtherInAStepThanItsSpeedLimit) {
  using Push = std::function<void(PhysicsWorld*, BodyId)>;
  const std::vector<Push> pushes = {
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddForce(body, {1e7, 0.0, 0.0});
      },
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddForce(body, {1e300, 1e300, 0.0});
      },
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddImpulse(body, {1e6, 0.0, 0.0}, physics->MotionOf(body).position_m);
      },
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddImpulse(body, {1e200, 0.0, 0.0}, {0.0, 3.0, 9.0});
      },
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddForceAt(body, {1e100, 0.0, 0.0}, {0.0, 0.0, 1e10});
      },
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddTorque(body, {1e250, 1e9, 1e200});
      },
      [](PhysicsWorld* physics, BodyId body) {
        BodyMotion motion = physics->MotionOf(body);
        motion.linear_velocity_mps = {1e200, 0.0, 0.0};
        motion.angular_velocity_radps = {0.0, 1e200, 0.0};
        physics->Place(body, motion);
      }};
  for (std::size_t i = 0; i < pushes.size(); ++i) {
    for (BodySpec spec : {Box(0.5, {0.2, 0.2, 0.2}), Robot(), Walker(60.0, 0.3)}) {
      spec.max_speed_mps = 20.0;
      const auto physics = Make();
      const BodyId body = physics->Add(spec, {0.0, 0.0, 4.0}, 0.0);
      physics->Step(kStep_s, 0);
      pushes[i](physics.get(), body);
      for (int step = 1; step < 5; ++step) {
        const Eigen::Vector3d before = physics->MotionOf(body).position_m;
        physics->Step(kStep_s, static_cast<std::uint64_t>(step));
        const Eigen::Vector3d way_m = physics->MotionOf(body).position_m - before;
        // base_link lies up to 0.8 m below the centre, about which it turns by 50 rad/s.
        EXPECT_LT(way_m.norm(), kStep_s * (20.0 + 0.8 * 50.0 + 1.0)) << i;
      }
    }
  }
}

TEST_P(PhysicsLimitsTest, NumbersTooLargeToAddUpAreListedAsStrayed) {
  using Push = std::function<void(PhysicsWorld*, BodyId)>;
  const std::vector<Push> pushes = {
      [](PhysicsWorld* physics, BodyId body) {
        for (int i = 0; i < 2; ++i) physics->AddForce(body, {1.5e308, 0.0, 0.0});
      },
      [](PhysicsWorld* physics, BodyId body) {
        for (int i = 0; i < 2; ++i) physics->AddTorque(body, {1.5e308, 1.5e308, 0.0});
      },
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddForceAt(body, {1e308, 0.0, 0.0}, {0.0, 0.0, 1e10});
      },
      [](PhysicsWorld* physics, BodyId body) {
        physics->AddImpulse(body, {1.5e308, 1e308, 0.0}, {0.0, 0.0, 1e9});
      }};
  for (const Push& push : pushes) {
    for (const BodySpec& spec : {Box(0.5, {0.2, 0.2, 0.2}), Robot()}) {
      const auto physics = Make();
      const BodyId body = physics->Add(spec, {0.0, 0.0, 4.0}, 0.0);
      const Eigen::Vector3d before = physics->MotionOf(body).position_m;
      push(physics.get(), body);
      physics->Step(kStep_s, 0);
      EXPECT_EQ(physics->strayed(), std::vector<BodyId>{body});
      EXPECT_LT((physics->MotionOf(body).position_m - before).norm(), 1e-12);
      physics->Step(kStep_s, 1);
      EXPECT_TRUE(physics->strayed().empty());
    }
  }
}

TEST_P(PhysicsLimitsTest, WhatIsAddedNowhereIsStrayed) {
  const auto physics = Make();
  BodyMotion motion;
  motion.position_m = {kNan, 0.0, 1.0};
  const std::vector<BodyId> bodies = {
      physics->Add(Robot(), motion), physics->Add(Robot(), {0.0, kNan, 0.0}, 0.0),
      physics->Add(Box(1.0, {0.1, 0.1, 0.1}), {0.0, 0.0, 0.0}, kNan),
      physics->Add(Ball(1.0, 0.1), {1e300, 0.0, 0.0}, 0.0)};
  physics->Step(kStep_s, 0);
  EXPECT_EQ(physics->strayed(), bodies);
  for (const BodyId body : bodies) {
    EXPECT_TRUE(physics->MotionOf(body).position_m.allFinite());
  }
}

TEST_P(PhysicsLimitsTest, SleepersOnFeetFallWhenTheirDeckGoes) {
  for (const BodySpec& spec : {Table(), Walker(60.0, 0.3)}) {
    for (const bool removed : {true, false}) {
      const auto physics = Make();
      const BodyId deck = AddDeck(physics.get());
      const BodyId body = physics->Add(spec, {0.0, 0.0, 3.201}, 0.0);
      for (std::size_t i = 0; i < spec.links.size(); ++i) {
        physics->SetJoint(body, i, {JointMode::kPosition, 0.0});
      }
      StepFor(physics.get(), 4.0);
      ASSERT_TRUE(physics->IsResting(body));
      ASSERT_GT(physics->MotionOf(body).position_m.z(), 3.1);
      if (removed) {
        physics->Remove(deck);
      } else {
        physics->SetAnchored(deck, false);
      }
      StepFor(physics.get(), 3.0);
      // Beside the ground, or on the deck that lies on it.
      EXPECT_LT(physics->MotionOf(body).position_m.z(), 0.5);
    }
  }
}

TEST_P(PhysicsLimitsTest, FeetRideTheirDeckDown) {
  const auto physics = Make();
  const BodyId deck = AddDeck(physics.get());
  const BodyId walker = physics->Add(Walker(60.0, 0.3), {0.0, 0.0, 3.201}, 0.0);
  StepFor(physics.get(), 1.0);
  physics->SetAnchored(deck, false);
  StepFor(physics.get(), 4.0);
  EXPECT_LT(physics->MotionOf(deck).position_m.z(), 0.05);
  EXPECT_NEAR(physics->MotionOf(walker).position_m.z(), 0.2, 0.05);
}

TEST_P(PhysicsLimitsTest, NothingFastGoesFarBeyondTheEdge) {
  const auto physics = Make();
  BodySpec point = Ball(2.0, 0.1);
  point.shapes.clear();
  point.ground_samples.clear();
  for (const BodySpec& spec : {Ball(2.0, 0.1), point}) {
    BodyMotion motion;
    motion.position_m = {25.0, 0.0, 5.0};
    motion.linear_velocity_mps = {95.0, 0.0, 0.0};
    const BodyId body = physics->Add(spec, motion);
    double furthest_m = 0.0;
    for (int i = 0; i < 20; ++i) {
      physics->Step(0.05, static_cast<std::uint64_t>(i));
      furthest_m = std::max(furthest_m, physics->MotionOf(body).position_m.x());
    }
    const double half_m = TestScene().Build()->geometry().half_size_m();
    EXPECT_LT(furthest_m, half_m + 0.6);
    physics->Remove(body);
  }
}

TEST_P(PhysicsLimitsTest, TheEdgePushesBackOnlyWhatMeetsIt) {
  const auto physics = Make();
  const double edge_m = TestScene().Build()->geometry().half_size_m();
  BodySpec box = Box(20.0, {0.5, 0.25, 0.25});
  const BodyId held = physics->Add(box, {edge_m, -3.0, 0.0}, 0.0);
  box.meets_boundary = false;
  const BodyId lies = physics->Add(box, {edge_m, 3.0, 0.0}, 0.0);
  StepFor(physics.get(), 2.0);
  EXPECT_LT(physics->MotionOf(held).position_m.x(), edge_m - 0.4);
  EXPECT_NEAR(physics->MotionOf(lies).position_m.x(), edge_m, 0.01);
  EXPECT_NEAR(physics->MotionOf(lies).position_m.z(), 0.0, 0.01);  // on the ground beyond it too
}

BodySpec Turntable() {
  BodySpec base = Box(200.0, {0.5, 0.5, 0.2});
  LinkSpec table;
  table.axis = Eigen::Vector3d::UnitZ();
  table.anchor_m = table.center_m = {0.0, 0.0, 1.0};
  table.inertia_kgm2 = Eigen::Vector3d::Constant(0.01);
  table.max_effort_nm = 12.0;
  table.max_rate_radps = 4.0;
  table.low_rad = -100.0;
  table.high_rad = 100.0;
  base.links = {table};
  return base;
}

TEST_P(PhysicsLimitsTest, EffortTurnsAJointNoFasterThanItsRate) {
  const auto physics = Make();
  const BodyId body = physics->Add(Turntable(), {0.0, 0.0, 0.0}, 0.0);
  physics->SetJoint(body, 0, {JointMode::kEffort, -12.0});
  StepFor(physics.get(), 0.5);
  EXPECT_NEAR(physics->JointOf(body, 0).rate_radps, -4.0, 0.05);
}

TEST_P(PhysicsLimitsTest, AJointThatTurnsSlowlyArrives) {
  const auto physics = Make();
  BodySpec spec = Turntable();
  spec.links[0].max_rate_radps = 0.05;
  const BodyId body = physics->Add(spec, {0.0, 0.0, 0.0}, 0.0);
  physics->SetJoint(body, 0, {JointMode::kPosition, 0.3});
  StepFor(physics.get(), 8.0);
  EXPECT_NEAR(physics->JointOf(body, 0).angle_rad, 0.3, 0.06);
  EXPECT_TRUE(physics->IsResting(body));
}

TEST_P(PhysicsLimitsTest, AVehicleParkedOnTheBedOfALakeSleeps) {
  TestScene scene;
  scene.height_m = [](double, double) { return -6.0; };
  scene.water_depth_m = [](double, double) { return 6.0; };
  const auto built = scene.Build();
  const auto physics = GetParam().make(built);
  const Buoyancy buoyancy{0.005, 0.3};
  for (const BodySpec& spec : {Robot(), Table()}) {
    const BodyId body = physics->Add(spec, {0.0, 0.0, -6.0}, 0.0);
    for (std::size_t i = 0; i < spec.links.size(); ++i) {
      physics->SetJoint(body, i, {JointMode::kPosition, 0.0});
    }
    for (int i = 0; i < 500; ++i) {
      ActOfWater(*built->terrain, Atmosphere(), buoyancy, body, physics.get());
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    }
    ActOfWater(*built->terrain, Atmosphere(), buoyancy, body, physics.get());
    EXPECT_TRUE(physics->IsResting(body));
    physics->Remove(body);
  }
}

LATTICEWORLD_ON_EVERY_BACK_END(PhysicsLimitsTest);

}  // namespace
}  // namespace latticeworld
