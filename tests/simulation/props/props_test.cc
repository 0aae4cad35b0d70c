#include "latticeworld/simulation/props/props.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/scene/props/props.h"
#include "latticeworld/simulation/props/blows.h"
#include "latticeworld/simulation/props/prop_body.h"
#include "simulation/props/thing_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

Prop PropAt(PropKind kind, double x_m, double y_m, const std::string& name = "thing") {
  Prop prop = UsualProp(kind);
  prop.position = {x_m, y_m};
  prop.name = name;
  return prop;
}

PropSnapshot Now(const ThingWorld& world, const std::string& name = "thing") {
  for (const PropSnapshot& one : world.props.Snapshots()) {
    if (one.name == name) return one;
  }
  ADD_FAILURE() << "no element " << name;
  return {};
}

double YawOf(const PropSnapshot& prop) {
  const Eigen::Vector3d forward = prop.orientation * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

// A channel of that width along y between level banks, 2 m deep, its water half a metre below them.
TestScene Channel(double width_m) {
  TestScene scene;
  scene.height_m = [=](double x_m, double) { return std::abs(x_m) < 0.5 * width_m ? -2.0 : 0.0; };
  scene.water_depth_m = [=](double x_m, double) {
    return std::abs(x_m) < 0.5 * width_m ? 1.5 : 0.0;
  };
  return scene;
}

TEST(PropsTest, EveryKindStandsWhereItIsPutAndRests) {
  for (const auto& entry : EnumNames(PropKind{})) {
    ThingWorld world(TestScene().Build());
    ASSERT_TRUE(world.props.Add(PropAt(entry.value, 3.0, 4.0)).ok()) << entry.name;
    world.Run(3.0);
    const PropSnapshot now = Now(world);
    EXPECT_NEAR(now.position_m.x(), 3.0, 0.02) << entry.name;
    EXPECT_NEAR(now.position_m.y(), 4.0, 0.02) << entry.name;
    if (entry.value != PropKind::kBridge) {
      EXPECT_NEAR(now.position_m.z(), 0.0, 0.02) << entry.name;
    }
    EXPECT_FALSE(now.broken);
    EXPECT_TRUE(world.events.empty()) << entry.name;
    EXPECT_TRUE(world.physics->IsResting(world.props.state().at("thing").body)) << entry.name;
  }
}

TEST(PropsTest, ACrateIsPushedAsFarAsItsPusherGoesAndStops) {
  ThingWorld world(TestScene().Build());
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kCrate, 0.0, 0.0)).ok());
  BodyMotion motion;
  motion.position_m = {-2.0, 0.0, 0.0};
  BodySpec spec = RammerOf(60.0, {0.6, 0.6, 0.3}, 0.05);
  spec.inertia_kgm2.setConstant(1e4);  // goes straight on
  const BodyId pusher = world.physics->Add(spec, motion);
  for (int i = 0; i < 600; ++i) {
    const double speed_mps = world.physics->MotionOf(pusher).linear_velocity_mps.x();
    world.physics->AddForce(pusher, {600.0 * (0.8 - speed_mps), 0.0, 0.0});
    world.Step(0.01);
  }
  EXPECT_GT(Now(world).position_m.x(), 1.5);
  EXPECT_NEAR(Now(world).position_m.x() - world.physics->MotionOf(pusher).position_m.x(), 0.55,
              0.1);
  world.physics->Remove(pusher);
  const double left_at_m = Now(world).position_m.x();
  world.Run(2.0);
  EXPECT_NEAR(Now(world).position_m.x(), left_at_m, 0.2);
}

TEST(PropsTest, ALooseStoneLiesStillOnGentleSlopesAndRollsDownSteepOnes) {
  for (const double slope_deg : {8.0, 14.0, 32.0}) {
    TestScene scene;
    const double slope = std::tan(slope_deg * M_PI / 180.0);
    scene.height_m = [=](double x_m, double) { return x_m > 0.0 ? slope * x_m : 0.0; };
    ThingWorld world(scene.Build());
    ASSERT_TRUE(world.props.Add(PropAt(PropKind::kLooseStone, 12.0, 0.0)).ok());
    world.Run(12.0);
    const double way_m = 12.0 - Now(world).position_m.x();
    if (slope_deg < 20.0) {
      EXPECT_LT(std::abs(way_m), 0.3) << slope_deg;
    } else {
      EXPECT_GT(way_m, 10.0) << slope_deg;
    }
    EXPECT_TRUE(world.physics->IsResting(world.props.state().at("thing").body)) << slope_deg;
  }
}

TEST(PropsTest, AGateOpensAndClosesWhenToldTo) {
  ThingWorld world(TestScene().Build());
  Prop gate = PropAt(PropKind::kGate, 0.0, 0.0);
  gate.yaw_rad = 0.5;
  ASSERT_TRUE(world.props.Add(gate).ok());
  for (const double opening_rad : {1.4, -1.2, 0.0}) {
    ASSERT_TRUE(world.props.OpenGate("thing", opening_rad).ok());
    world.Run(6.0);
    EXPECT_NEAR(Now(world).opening_rad, opening_rad, 0.06);
    EXPECT_NEAR(YawOf(Now(world)), 0.5 + opening_rad, 0.06);
    // The hinge stays.
    EXPECT_LT(Now(world).position_m.head<2>().norm(), 0.02);
    EXPECT_TRUE(world.physics->IsResting(world.props.state().at("thing").body));
  }
  // On its way from one side to the other it was closed.
  EXPECT_EQ(world.Count(EventKind::kOpened), 2);
  EXPECT_EQ(world.Count(EventKind::kClosed), 2);
}

TEST(PropsTest, AGateIsPushedOpen) {
  ThingWorld world(TestScene().Build());
  Prop gate = PropAt(PropKind::kGate, 0.0, 0.0);
  gate.yaw_rad = M_PI / 2.0;  // across the way east
  ASSERT_TRUE(world.props.Add(gate).ok());
  BodyMotion motion;
  motion.position_m = {-1.5, 0.7, 0.0};
  const BodyId pusher = world.physics->Add(RammerOf(60.0, {0.5, 0.5, 1.0}, 0.05), motion);
  for (int i = 0; i < 500; ++i) {
    const double speed_mps = world.physics->MotionOf(pusher).linear_velocity_mps.x();
    world.physics->AddForce(pusher, {600.0 * (0.8 - speed_mps), 0.0, 0.0});
    world.Step(0.01);
  }
  EXPECT_EQ(world.Count(EventKind::kOpened), 1);
  EXPECT_LT(Now(world).opening_rad, -0.5);
  EXPECT_GT(world.physics->MotionOf(pusher).position_m.x(), 1.0);
  EXPECT_FALSE(Now(world).broken);
}

TEST(PropsTest, ABridgeFeelsWhatHasLongStoodOnIt) {
  ThingWorld world(Channel(5.0).Build());
  Prop bridge = PropAt(PropKind::kBridge, 0.0, 0.0);
  bridge.strength = 500.0;
  ASSERT_TRUE(world.props.Add(bridge).ok());
  BodyMotion motion;
  for (const double x_m : {-0.5, 0.5}) {
    motion.position_m = {x_m, 0.0, 0.05};
    BodySpec load = RammerOf(400.0, {0.6, 0.6, 0.5}, 0.0);
    load.grip = 1.0;
    world.physics->Add(load, motion);
    EXPECT_EQ(world.Count(EventKind::kBroke), 0);
    world.Run(3.0);
  }
  EXPECT_EQ(world.Count(EventKind::kBroke), 1);
}

TEST(PropsTest, ABridgeCarriesWhatItBearsAndBreaksUnderMore) {
  for (const double share : {0.8, 1.3}) {
    ThingWorld world(Channel(5.0).Build());
    Prop bridge = PropAt(PropKind::kBridge, 0.0, 0.0);
    bridge.strength = 500.0;
    ASSERT_TRUE(world.props.Add(bridge).ok());
    EXPECT_NEAR(Now(world).position_m.z() + bridge.size_m.z(), 0.0, 0.03);  // flush
    BodyMotion motion;
    motion.position_m = {0.0, 0.0, 0.05};
    BodySpec load = RammerOf(share * bridge.strength, {1.0, 1.0, 0.5}, 0.0);
    load.grip = 1.0;
    const BodyId body = world.physics->Add(load, motion);
    double load_n = 0.0;
    for (int i = 0; i < 40; ++i) {
      world.Run(0.1);
      if (i == 5) load_n = world.props.state().at("thing").load;
    }
    const double z_m = world.physics->MotionOf(body).position_m.z();
    if (share < 1.0) {
      EXPECT_FALSE(Now(world).broken);
      EXPECT_EQ(world.Count(EventKind::kBroke), 0);
      EXPECT_NEAR(z_m, 0.0, 0.05);
      EXPECT_NEAR(load_n, share * 500.0 * kGravity_mps2, 300.0);
    } else {
      EXPECT_TRUE(Now(world).broken);
      EXPECT_EQ(world.Count(EventKind::kBroke), 1);
      EXPECT_LT(z_m, -0.8);
      EXPECT_LT(Now(world).position_m.z(), -0.3);
    }
  }
}

TEST(PropsTest, APostStopsALightBodyAndBreaksUnderAHeavyOne) {
  for (const bool heavy : {false, true}) {
    ThingWorld world(TestScene().Build());
    ASSERT_TRUE(world.props.Add(PropAt(PropKind::kPost, 0.0, 0.0)).ok());
    BodyMotion motion;
    motion.position_m = {-3.0, 0.0, 0.0};
    motion.linear_velocity_mps.x() = heavy ? 8.0 : 2.0;
    const BodyId body = world.physics->Add(
        heavy ? RammerOf(2500.0, {3.0, 1.6, 1.0}) : RammerOf(24.0, {0.6, 0.4, 0.3}), motion);
    world.Run(2.5);
    EXPECT_EQ(world.Count(EventKind::kBroke), heavy ? 1 : 0);
    EXPECT_EQ(Now(world).broken, heavy);
    if (heavy) {
      EXPECT_GT(world.physics->MotionOf(body).position_m.x(), 5.0);
      const Eigen::Vector3d up = Now(world).orientation * Eigen::Vector3d::UnitZ();
      EXPECT_LT(std::abs(up.z()), 0.5);  // it lies
    } else {
      EXPECT_LT(world.physics->MotionOf(body).position_m.x(), -0.3);
      EXPECT_NEAR((Now(world).position_m).norm(), 0.0, 0.02);
    }
  }
}

TEST(PropsTest, APostMeetsOnlyTheShareOfAStemThatHitsIt) {
  // A log that turns about its end meets a post near that end with nearly all of its mass, and one
  // far from its middle with a part of it.
  struct Hit {
    double along_m;
    bool breaks;
  };
  for (const Hit& hit : {Hit{0.0, true}, Hit{2.6, false}}) {
    ThingWorld world(TestScene().Build());
    Prop post = PropAt(PropKind::kPost, 0.0, hit.along_m);
    BodySpec log;
    log.mass_kg = 60.0;
    log.inertia_kgm2 = {60.0 * 36.0 / 12.0, 5.0, 60.0 * 36.0 / 12.0};
    BodyShape box;
    box.form = ShapeForm::kBox;
    box.half_extents_m = {0.15, 3.0, 0.15};
    log.shapes = {box};
    BodyMotion motion;
    motion.position_m = {-0.3, 0.0, 0.6};
    motion.linear_velocity_mps = {2.0, 0.0, 0.0};
    // Between what the whole log and what its share breaks at.
    const double whole_kg = log.mass_kg;
    const double share_kg = MassMet(log, motion, {0.0, 2.6, 0.6}, Eigen::Vector3d::UnitX());
    ASSERT_LT(share_kg, 0.5 * whole_kg);
    const auto moment_nm = [&](double mass_kg) {
      return ImpactMoment(mass_kg, 2.0, StiffnessMet(mass_kg, PostStiffness(post)));
    };
    post.strength = 0.5 * (moment_nm(share_kg) + moment_nm(whole_kg));
    ASSERT_TRUE(world.props.Add(post).ok());
    world.physics->Add(log, motion);
    world.Run(0.2);
    EXPECT_EQ(world.Count(EventKind::kBroke), hit.breaks ? 1 : 0) << hit.along_m;
  }
}

TEST(PropsTest, ACrateFloatsAndAStoneSinks) {
  TestScene scene;
  scene.height_m = [](double, double) { return -3.0; };
  scene.water_depth_m = [](double, double) { return 3.0; };
  ThingWorld world(scene.Build());
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kCrate, -4.0, 0.0, "crate")).ok());
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kLooseStone, 4.0, 0.0, "stone")).ok());
  world.Run(15.0);
  const double crate_m = Now(world, "crate").position_m.z();
  EXPECT_GT(crate_m, -0.2);
  EXPECT_LT(crate_m, 0.0);
  EXPECT_NEAR(Now(world, "stone").position_m.z(), -3.0, 0.05);
}

TEST(PropsTest, RefusesWhatCannotBeAndChangesNothing) {
  TestScene scene;
  scene.AddTree(10.0, 0.0, 0.3);
  scene.AddBuilding(-10.0, 0.0, 4.0, 3.0, 0.4);
  ThingWorld world(scene.Build());
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kCrate, 0.0, 0.0, "first")).ok());
  std::string before = world.Hash();
  const auto code = [&](const Prop& prop) { return world.props.Add(prop).status().code(); };
  EXPECT_EQ(code(PropAt(PropKind::kCrate, 10.3, 0.2)), StatusCode::kFailedPrecondition);
  EXPECT_EQ(code(PropAt(PropKind::kCrate, -7.0, 0.0)), StatusCode::kFailedPrecondition);
  EXPECT_EQ(code(PropAt(PropKind::kCrate, 0.3, 0.3)), StatusCode::kFailedPrecondition);
  EXPECT_EQ(code(PropAt(PropKind::kCrate, 31.9, 0.0)), StatusCode::kOutOfRange);
  EXPECT_EQ(world.Hash(), before);
  EXPECT_EQ(code(PropAt(PropKind::kBridge, 0.0, 30.0)), StatusCode::kOk);
  EXPECT_NE(world.Hash(), before);
  ASSERT_TRUE(world.props.Remove("thing").ok());
  before = world.Hash();
  EXPECT_EQ(world.props.OpenGate("first", 1.0).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(world.props.OpenGate("nobody", 1.0).code(), StatusCode::kNotFound);
  EXPECT_EQ(world.Hash(), before);
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kGate, 5.0, 0.0, "gate")).ok());
  before = world.Hash();
  EXPECT_EQ(world.props.OpenGate("gate", 2.0).code(), StatusCode::kOutOfRange);
  EXPECT_EQ(world.props.OpenGate("gate", NAN).code(), StatusCode::kOutOfRange);
  EXPECT_EQ(world.Hash(), before);
  ASSERT_TRUE(world.props.OpenGate("gate", 1.0).ok());
  EXPECT_NE(world.Hash(), before);
  ASSERT_TRUE(world.props.Remove("gate").ok());
  EXPECT_EQ(world.props.Remove("gate").code(), StatusCode::kNotFound);
  EXPECT_EQ(world.props.state().size(), 1u);
}

TEST(PropsTest, HoldsAsManyAsAWorldHolds) {
  TestScene scene;
  scene.size_m = 256.0;
  for (int i = 0; i < kMaxProps; ++i) {
    Prop crate = PropAt(PropKind::kCrate, -120.0 + 4.0 * (i % 50), -120.0 + 4.0 * (i / 50),
                        "crate_" + std::to_string(i));
    scene.props.push_back(crate);
  }
  ThingWorld world(scene.Build());
  const Result<std::string> more = world.props.Add(PropAt(PropKind::kCrate, 110, 110));
  EXPECT_EQ(more.status().code(), StatusCode::kResourceExhausted);
  EXPECT_NE(more.status().message().find(std::to_string(kMaxProps)), std::string::npos);
}

TEST(PropsTest, GoesOnTheSameWayFromASnapshot) {
  ThingWorld world(Channel(5.0).Build());
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kBridge, 0.0, 0.0, "bridge")).ok());
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kGate, 8.0, 0.0, "gate")).ok());
  ASSERT_TRUE(world.props.Add(PropAt(PropKind::kPost, -20.0, 0.0, "post")).ok());
  ASSERT_TRUE(world.props.OpenGate("gate", 1.2).ok());
  BodyMotion motion;
  motion.position_m.z() = 0.05;
  world.physics->Add(RammerOf(3000.0, {1.0, 1.0, 0.5}, 0.0), motion);
  world.Run(0.3);
  const auto snapshot = world.physics->Save();
  const Props::State state = world.props.state();
  const std::uint64_t steps = world.steps;
  const std::string begin = world.Hash();
  world.Run(2.0);
  const std::string expected = world.Hash();
  EXPECT_EQ(world.Count(EventKind::kBroke), 1);
  world.physics->Restore(*snapshot);
  world.props.Restore(state);
  world.steps = steps;
  EXPECT_EQ(world.Hash(), begin);
  world.Run(2.0);
  EXPECT_EQ(world.Hash(), expected);
}

}  // namespace
}  // namespace latticeworld
