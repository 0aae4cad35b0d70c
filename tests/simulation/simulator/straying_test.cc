// What physics cannot compute, or what leaves the world, is told and dealt with. No command brings
// that about, so policies of the tests' own do it: they reach the physics as every policy does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "latticeworld/simulation/agents/minds/policy.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr std::uint64_t kStrike = 100;  // episode step of what befalls the agent

// Walks east, and once is pushed by a force that is no number.
class Poisoned : public Policy {
 public:
  Steering Decide(Agent* agent, Surroundings* world) const override {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (world->episode_step / 10 == kStrike / 10) {
      world->physics->AddForce(agent->body, {nan, 0.0, 0.0});
    }
    agent->behaviour = Behaviour::kWander;
    Steering steering;
    steering.speed_mps = 1.0;
    return steering;
  }
};

// Once is put where there is no world; and so is body 1, the first that was made.
class Abducted : public Policy {
 public:
  explicit Abducted(Eigen::Vector3d where_m) : where_m_(where_m) {}
  Steering Decide(Agent* agent, Surroundings* world) const override {
    if (world->episode_step / 10 == kStrike / 10) {
      BodyMotion motion;
      motion.position_m = where_m_;
      world->physics->Place(agent->body, motion);
      world->physics->Place(1, motion);
    }
    return {};
  }

 private:
  Eigen::Vector3d where_m_;
};

std::unique_ptr<Simulator> With(const std::string& policy) {
  TestScene scene;
  scene.AddProp("crate", PropKind::kCrate, 20.0, 20.0);
  auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("goblin", "goblin", 0.0, 0.0);
  request.policy = policy;
  MustSpawn(simulator.get(), request);
  RunFor(simulator.get(), 0.95);
  simulator->TakeEvents();
  return simulator;
}

TEST(StrayingTest, WhatLeavesFiniteNumbersIsFrozenForASecondAndGoesOn) {
  RegisterPolicy("poisoned", std::make_unique<Poisoned>());
  const auto simulator = With("poisoned");
  EXPECT_GT(Now(*simulator, "goblin").linear_velocity_mps.x(), 0.5);
  RunFor(simulator.get(), 0.2);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kFrozen, "goblin"), 1);
  const Eigen::Vector3d there = Now(*simulator, "goblin").position_m;
  EXPECT_TRUE(there.allFinite());
  EXPECT_NEAR(there.x(), 0.8, 0.4);
  RunFor(simulator.get(), 0.7);
  EXPECT_EQ((Now(*simulator, "goblin").position_m - there).norm(), 0.0);
  RunFor(simulator.get(), 2.0);
  EXPECT_GT(Now(*simulator, "goblin").position_m.x(), there.x() + 1.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kFrozen, "goblin"), 0);
}

TEST(StrayingTest, WhoLeavesTheWorldIsPutBackAndAThingIsTakenAway) {
  const double nowhere_m[][3] = {{500.0, 0.0, 0.0}, {5.0, 5.0, -50.0}, {0.0, 0.0, 5000.0}};
  for (int i = 0; i < 3; ++i) {
    const std::string policy = "abducted_" + std::to_string(i);
    RegisterPolicy(policy, std::make_unique<Abducted>(
                               Eigen::Vector3d(nowhere_m[i][0], nowhere_m[i][1], nowhere_m[i][2])));
    const auto simulator = With(policy);
    ASSERT_EQ(simulator->State()->props.size(), 1u);
    RunFor(simulator.get(), 3.0);
    const auto events = simulator->TakeEvents();
    EXPECT_GE(Count(events, EventKind::kLeftWorld, "goblin"), 1) << i;
    EXPECT_EQ(Count(events, EventKind::kLeftWorld, "crate"), 1) << i;
    EXPECT_TRUE(simulator->State()->props.empty());
    const Eigen::Vector3d place = Now(*simulator, "goblin").position_m;
    EXPECT_LT(place.head<2>().norm(), 10.0) << i;
    EXPECT_GT(place.z(), -0.5) << i;
  }
}

// Puts the first three bodies into each other and the ground, for a second, and three seconds later
// again.
class Crusher : public Policy {
 public:
  Steering Decide(Agent* agent, Surroundings* world) const override {
    agent->behaviour = Behaviour::kIdle;
    if (world->episode_step % 400 < kStrike || world->episode_step % 400 >= 2 * kStrike) return {};
    BodyMotion motion;
    motion.position_m = {0.0, 10.0, -0.2};
    for (const BodyId body : {1, 2, 3}) {
      motion.position_m.z() += 0.02;
      world->physics->Place(body, motion);
    }
    return {};
  }
};

TEST(StrayingTest, WhatIsSlowedDownIsToldOnceForAsLongAsItGoesOn) {
  RegisterPolicy("crusher", std::make_unique<Crusher>());
  TestScene scene;
  for (const char* name : {"box", "case", "crate"}) {
    scene.AddProp(name, PropKind::kCrate, 20.0, 2.0 * scene.props.size());
  }
  const auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor("goblin", "goblin", 0.0, 0.0);
  request.policy = "crusher";
  MustSpawn(simulator.get(), request);
  RunFor(simulator.get(), 0.95);
  simulator->TakeEvents();
  for (int crush = 0; crush < 2; ++crush) {
    const auto snapshot = simulator->Save();
    RunFor(simulator.get(), 4.0);
    const auto events = simulator->TakeEvents();
    for (const std::string name : {"box", "case", "crate"}) {
      EXPECT_EQ(Count(events, EventKind::kSlowed, name), 1) << name << ", crush " << crush;
    }
    // What has been told is part of the state.
    const std::string hash = simulator->StateHash();
    ASSERT_TRUE(simulator->Restore(*snapshot).ok());
    RunFor(simulator.get(), 4.0);
    EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kSlowed, "crate"), 1);
    EXPECT_EQ(simulator->StateHash(), hash);
  }
}

// Is put out of the world, or pushed by what is no number, whenever it thinks; and so is body 1.
class Cursed : public Policy {
 public:
  explicit Cursed(bool leaves) : leaves_(leaves) {}
  Steering Decide(Agent* agent, Surroundings* world) const override {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (leaves_) {
      BodyMotion motion;
      motion.position_m = {500.0, 0.0, 0.0};
      world->physics->Place(agent->body, motion);
    } else {
      world->physics->AddForce(agent->body, {nan, 0.0, 0.0});
      const bool is_there =
          std::any_of(world->agents->begin(), world->agents->end(),
                      [](const auto& one) { return one.second.name == "goblin"; });
      if (is_there) world->physics->AddForce(1, {nan, 0.0, 0.0});
    }
    return {};
  }

 private:
  bool leaves_;
};

TEST(StrayingTest, WhatStraysAgainAndAgainIsToldOnceAndThenTakenAway) {
  for (const bool leaves : {true, false}) {
    const std::string policy = leaves ? "exiled" : "cursed";
    RegisterPolicy(policy, std::make_unique<Cursed>(leaves));
    TestScene scene;
    scene.AddProp("crate", PropKind::kCrate, 20.0, 20.0);
    const auto simulator = MakeSimulator(scene);
    SpawnRequest request = RequestFor("goblin", "goblin", 0.0, 0.0);
    request.policy = policy;
    MustSpawn(simulator.get(), request);
    RunFor(simulator.get(), 8.0);
    auto events = simulator->TakeEvents();
    const EventKind told = leaves ? EventKind::kLeftWorld : EventKind::kFrozen;
    EXPECT_EQ(Count(events, told, "goblin"), 1) << policy;
    if (!leaves) {
      EXPECT_EQ(Count(events, EventKind::kFrozen, "crate"), 1);
    }
    RunFor(simulator.get(), 4.0);
    events = simulator->TakeEvents();
    EXPECT_EQ(Count(events, EventKind::kLeftWorld, "goblin"), 1) << policy;
    EXPECT_EQ(Count(events, EventKind::kFrozen, "goblin"), 0) << policy;
    EXPECT_TRUE(simulator->State()->agents.empty()) << policy;
    EXPECT_EQ(simulator->Remove("goblin").code(), StatusCode::kNotFound);
    RunFor(simulator.get(), 1.0);
    EXPECT_TRUE(simulator->TakeEvents().empty());
    // Its name is free again, and it is well.
    request.policy = "";
    MustSpawn(simulator.get(), request);
    RunFor(simulator.get(), 1.0);
    EXPECT_EQ(simulator->State()->agents.size(), 1u);
  }
}

TEST(StrayingTest, EventsThatNobodyTakesAreBoundedWhateverTellsThem) {
  TestScene scene;
  const auto simulator = MakeSimulator(scene);
  Prop crate;
  crate.name = "crate";
  crate.size_m.setConstant(0.5);
  for (int i = 0; i < 40000; ++i) {
    ASSERT_TRUE(simulator->SpawnProp(crate).ok());
    ASSERT_TRUE(simulator->RemoveProp("crate").ok());
  }
  EXPECT_LE(simulator->TakeEvents().size(), 65536u);
  WeatherChange rain;
  rain.weather = Weather::kRain;
  for (int i = 0; i < 40000; ++i) {
    ASSERT_TRUE(simulator->SetWeather(rain).ok());
    rain.weather = rain.weather == Weather::kRain ? Weather::kSunny : Weather::kRain;
  }
  EXPECT_LE(simulator->TakeEvents().size(), 65536u);
}

TEST(StrayingTest, TheFrozenArePartOfTheState) {
  RegisterPolicy("poisoned", std::make_unique<Poisoned>());
  const auto simulator = With("poisoned");
  RunFor(simulator.get(), 0.3);
  const auto snapshot = simulator->Save();
  RunFor(simulator.get(), 2.0);
  const std::string hash = simulator->StateHash();
  simulator->Reset(5);
  ASSERT_TRUE(simulator->Restore(*snapshot).ok());
  RunFor(simulator.get(), 2.0);
  EXPECT_EQ(simulator->StateHash(), hash);
  // Nobody is frozen who is gone.
  ASSERT_TRUE(simulator->Restore(*snapshot).ok());
  ASSERT_TRUE(simulator->Remove("goblin").ok());
  RunFor(simulator.get(), 1.0);
}

}  // namespace
}  // namespace latticeworld
