// Repeatability of a PhysicsWorld: snapshots, churn, and numbers that make no sense.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "latticeworld/common/random.h"
#include "simulation/ode/back_ends.h"

namespace latticeworld {
namespace {

using PhysicsSnapshotTest = PhysicsContract;

TestScene Forest() {
  TestScene scene;
  scene.height_m = Hills(0.8, 20.0);
  RandomStream random(5, "trees");
  for (int i = 0; i < 60; ++i) {
    scene.AddTree(random.Uniform(-20.0, 20.0), random.Uniform(-20.0, 20.0), 0.2);
  }
  return scene;
}

BodySpec SprungLeggedThing() {
  BodySpec thing = Robot();
  for (WheelSpec& wheel : thing.wheels) {
    wheel.spring_npm = 3000.0;
    wheel.damper_nspm = 150.0;
    wheel.travel_m = 0.05;
    wheel.max_steering_rad = wheel.center_m.x() > 0.0 ? 0.5 : 0.0;
  }
  LinkSpec arm;
  arm.mass_kg = 1.0;
  arm.inertia_kgm2 = Eigen::Vector3d::Constant(0.01);
  arm.anchor_m = {0.2, 0.0, 0.3};
  arm.center_m = {0.4, 0.0, 0.3};
  arm.ground_samples = {{{0.5, 0.0, 0.3}, 0.02}};
  thing.links.push_back(arm);
  return thing;
}

BodySpec Gate() {
  BodySpec gate = Box(30.0, {0.04, 1.0, 0.5});
  gate.ground_samples.clear();
  gate.anchor.emplace();
  gate.anchor->kind = AnchorKind::kHinge;
  gate.anchor->pivot_m = {0.0, -1.0, 0.0};
  return gate;
}

std::vector<BodyId> Crowd(PhysicsWorld* physics) {
  std::vector<BodyId> bodies;
  RandomStream random(9, "bodies");
  for (int i = 0; i < 24; ++i) {
    const Eigen::Vector3d at(random.Uniform(-6.0, 6.0), random.Uniform(-6.0, 6.0), 1.5);
    const BodySpec specs[] = {Robot(),           SprungLeggedThing(), Box(8.0, {0.3, 0.2, 0.2}),
                              Walker(60.0, 0.3), Ball(3.0, 0.2),      Gate()};
    bodies.push_back(physics->Add(specs[i % 6], at, random.Uniform(-3.0, 3.0)));
  }
  return bodies;
}

// Commands that depend on the step alone.
void Act(PhysicsWorld* physics, const std::vector<BodyId>& bodies, int step) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double phase = 0.01 * step + static_cast<double>(i);
    const BodySpec& spec = physics->SpecOf(bodies[i]);
    if (!spec.wheels.empty()) {
      DriveAll(physics, bodies[i], 12.0 * std::sin(phase), 0.4 * std::cos(phase));
    }
    if (!spec.links.empty()) {
      physics->SetJoint(bodies[i], 0, {JointMode::kPosition, std::sin(2.0 * phase)});
    }
    if (spec.upright) {
      physics->SetWalkVelocity(bodies[i], {1.5 * std::cos(phase), 1.5 * std::sin(phase), 0.0});
    }
    if (spec.anchor) physics->AddTorque(bodies[i], {0.0, 0.0, 50.0 * std::sin(phase)});
  }
}

void Advance(PhysicsWorld* physics, const std::vector<BodyId>& bodies, int from, int to) {
  for (int step = from; step < to; ++step) {
    Act(physics, bodies, step);
    physics->Step(kStep_s, static_cast<std::uint64_t>(step));
  }
}

TEST_P(PhysicsSnapshotTest, RunsOnTheSameFromASnapshotInTheSameWorldAndInAnother) {
  const TestScene scene = Forest();
  const auto physics = Make(scene);
  const std::vector<BodyId> bodies = Crowd(physics.get());
  Advance(physics.get(), bodies, 0, 300);
  const auto snapshot = physics->Save();
  const std::string saved = DigestOf(*physics);
  const std::size_t contacts = physics->contacts().size();
  Advance(physics.get(), bodies, 300, 600);
  const std::string end = DigestOf(*physics);
  EXPECT_NE(end, saved);

  physics->Restore(*snapshot);
  EXPECT_EQ(DigestOf(*physics), saved);
  EXPECT_EQ(physics->contacts().size(), contacts);
  Advance(physics.get(), bodies, 300, 600);
  EXPECT_EQ(DigestOf(*physics), end);

  const auto other = Make(scene);
  other->Restore(*snapshot);
  EXPECT_EQ(DigestOf(*other), saved);
  Advance(other.get(), bodies, 300, 600);
  EXPECT_EQ(DigestOf(*other), end);
}

TEST_P(PhysicsSnapshotTest, HoldsWhatWasAddedRemovedLoosenedAndKnockedOver) {
  const TestScene scene = Forest();
  const auto physics = Make(scene);
  std::vector<BodyId> bodies = Crowd(physics.get());
  Advance(physics.get(), bodies, 0, 100);
  const auto churn = [&](PhysicsWorld* world, std::vector<BodyId> alive, int step) {
    world->Remove(alive[4]);
    world->Remove(alive[13]);
    alive.erase(alive.begin() + 13);
    alive.erase(alive.begin() + 4);
    for (const BodyId body : alive) {
      if (world->SpecOf(body).upright) world->SetUpright(body, body % 2 == 0);
      if (world->SpecOf(body).anchor) world->SetAnchored(body, body % 4 < 2);
    }
    BodyMotion motion;
    motion.position_m = {0.0, 0.0, 4.0 + step};
    motion.linear_velocity_mps = {1.0, 0.0, 0.0};
    alive.push_back(world->Add(Box(4.0, {0.2, 0.3, 0.2}), motion));
    world->SetAssetPresent(static_cast<std::uint32_t>(step) % 7, false);
    GroundState wet;
    wet.wetness = 0.4;
    world->SetGround(wet);
    return alive;
  };
  const auto early = physics->Save();
  std::vector<BodyId> later = churn(physics.get(), bodies, 1);
  Advance(physics.get(), later, 100, 250);
  const auto middle = physics->Save();
  const std::string at_middle = DigestOf(*physics);
  std::vector<BodyId> last = churn(physics.get(), later, 2);
  Advance(physics.get(), last, 250, 400);
  const std::string end = DigestOf(*physics);

  physics->Restore(*early);
  EXPECT_EQ(churn(physics.get(), bodies, 1), later);
  Advance(physics.get(), later, 100, 250);
  EXPECT_EQ(DigestOf(*physics), at_middle);

  const auto other = Make(scene);
  other->Restore(*middle);
  EXPECT_EQ(DigestOf(*other), at_middle);
  EXPECT_EQ(churn(other.get(), later, 2), last);
  Advance(other.get(), last, 250, 400);
  EXPECT_EQ(DigestOf(*other), end);
}

TEST_P(PhysicsSnapshotTest, KeepsForcesThatActInTheNextStep) {
  const auto physics = Make();
  const BodyId ball = physics->Add(Ball(2.0, 0.2), {0.0, 0.0, 5.0}, 0.0);
  physics->AddForce(ball, {100.0, 0.0, 0.0});
  const auto snapshot = physics->Save();
  physics->Step(kStep_s, 0);
  const double speed_mps = physics->MotionOf(ball).linear_velocity_mps.x();
  EXPECT_NEAR(speed_mps, 0.5, 1e-9);
  physics->Restore(*snapshot);
  physics->Step(kStep_s, 0);
  EXPECT_EQ(physics->MotionOf(ball).linear_velocity_mps.x(), speed_mps);
}

TEST_P(PhysicsSnapshotTest, WorldsInOneProcessDoNotSeeEachOther) {
  const auto alone = Make(Forest());
  const std::vector<BodyId> bodies = Crowd(alone.get());
  Advance(alone.get(), bodies, 0, 200);
  const auto first = Make(Forest()), second = Make(Forest());
  Crowd(first.get());
  Crowd(second.get());
  for (int i = 0; i < 200; ++i) {
    Advance(first.get(), bodies, i, i + 1);
    Advance(second.get(), bodies, i + 17, i + 18);
  }
  EXPECT_EQ(DigestOf(*alone), DigestOf(*first));
  EXPECT_NE(DigestOf(*alone), DigestOf(*second));
}

TEST_P(PhysicsSnapshotTest, NumbersThatAreNotFiniteStopTheBodyAndNobodyElse) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto physics = Make();
  const BodyId robot = physics->Add(SprungLeggedThing(), {0.0, 0.0, 0.0}, 0.0);
  const BodyId crate = physics->Add(Box(5.0, {0.2, 0.2, 0.2}), {0.55, 0.0, 0.0}, 0.0);
  const BodyId post_at = physics->Add(Gate(), {5.0, 5.0, 0.0}, 0.0);
  const Eigen::Vector3d bad(nan, 0.0, 0.0), huge(0.0, infinity, 0.0);
  const auto check = [&](const char* what) {
    physics->Step(kStep_s, 3);
    EXPECT_EQ(physics->strayed(), std::vector<BodyId>{robot}) << what;
    EXPECT_TRUE(physics->MotionOf(robot).position_m.allFinite()) << what;
    EXPECT_EQ(physics->MotionOf(robot).linear_velocity_mps, Eigen::Vector3d::Zero()) << what;
    EXPECT_TRUE(physics->MotionOf(crate).position_m.allFinite()) << what;
    physics->Step(kStep_s, 4);
    EXPECT_TRUE(physics->strayed().empty()) << what;
  };
  physics->AddForce(robot, bad);
  check("force");
  physics->AddForceAt(robot, {1.0, 0.0, 0.0}, huge);
  check("force at");
  physics->AddTorque(robot, huge);
  check("torque");
  physics->AddImpulse(robot, bad, {0.0, 0.0, 0.0});
  check("impulse");
  physics->SetWalkVelocity(robot, bad);
  check("walk");
  physics->SetWheel(robot, 0, nan, 0.0);
  check("wheel");
  physics->SetWheel(robot, 0, 0.0, infinity);
  check("steering");
  physics->SetJoint(robot, 0, {JointMode::kEffort, nan});
  check("joint");
  BodyMotion nowhere;
  nowhere.position_m = bad;
  physics->Place(robot, nowhere);
  check("place");
  EXPECT_TRUE(physics->IsAnchored(post_at));
}

TEST_P(PhysicsSnapshotTest, HugeForcesAndSpeedsStayWithinLimits) {
  const auto physics = Make();
  BodySpec spec = SprungLeggedThing();
  spec.max_speed_mps = 20.0;
  const BodyId robot = physics->Add(spec, {0.0, 0.0, 0.0}, 0.0);
  for (int i = 0; i < 200; ++i) {
    const double sign = i % 3 == 0 ? -1.0 : 1.0;
    physics->AddForce(robot, {1e7 * sign, 0.0, 1e6});
    physics->AddTorque(robot, {1e7, 1e7 * sign, 1e7});
    DriveAll(physics.get(), robot, 1e9 * sign, 1e9);
    physics->SetJoint(robot, 0, {JointMode::kVelocity, 1e12 * sign});
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    const BodyMotion motion = physics->MotionOf(robot);
    ASSERT_TRUE(motion.position_m.allFinite());
    ASSERT_LT(motion.linear_velocity_mps.norm(), 60.0);
    ASSERT_LT(motion.angular_velocity_radps.norm(), 51.0);
  }
}

TEST_P(PhysicsSnapshotTest, BodiesInsideEachOtherPartWithoutBeingShotAway) {
  const auto physics = Make();
  std::vector<BodyId> bodies;
  for (int i = 0; i < 10; ++i) {
    bodies.push_back(physics->Add(i % 2 == 0 ? Robot() : Box(10.0, {0.3, 0.3, 0.3}),
                                  {0.02 * i, 0.01 * i, 0.0}, 0.1 * i));
  }
  double fastest_mps = 0.0;
  for (int i = 0; i < 400; ++i) {
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    EXPECT_TRUE(physics->strayed().empty());
    for (const BodyId body : bodies) {
      fastest_mps = std::max(fastest_mps, physics->MotionOf(body).linear_velocity_mps.norm());
    }
  }
  EXPECT_LT(fastest_mps, 12.0);
}

TEST_P(PhysicsSnapshotTest, AnEmptyWorldSteps) {
  const auto physics = Make();
  StepFor(physics.get(), 0.1);
  EXPECT_TRUE(physics->contacts().empty());
  const auto snapshot = physics->Save();
  physics->Add(Robot(), {0.0, 0.0, 0.0}, 0.0);
  StepFor(physics.get(), 0.1);
  physics->Restore(*snapshot);
  StepFor(physics.get(), 0.1);
  EXPECT_TRUE(physics->contacts().empty());
}

LATTICEWORLD_ON_EVERY_BACK_END(PhysicsSnapshotTest);

}  // namespace
}  // namespace latticeworld
