#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/agents/minds/mind_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

double Up(const AgentSnapshot& agent) { return (agent.orientation * Eigen::Vector3d::UnitZ()).z(); }

// A robot that a vehicle runs into: it stands 6 m ahead of it.
std::unique_ptr<Simulator> RunInto(const std::string& species, double speed_mps,
                                   std::vector<Event>* events, double seconds) {
  TestScene scene;
  auto simulator = MakeSimulator(scene);
  SpawnRequest walker = RequestFor("humanoid robot", "walker", 6.0, 0.0);
  walker.controllable = true;
  SpawnRequest car = RequestFor(species, "car", 0.0, 0.0);
  car.controllable = true;
  MustSpawn(simulator.get(), walker);
  MustSpawn(simulator.get(), car);
  for (int i = 0; i < seconds / 0.01; ++i) {
    const bool near = Now(*simulator, "car").position_m.x() > 4.6;
    EXPECT_TRUE(simulator->Command("car", Forward(near ? 0.0 : speed_mps)).ok());
    simulator->Step();
    for (const Event& event : simulator->TakeEvents()) events->push_back(event);
  }
  return simulator;
}

TEST(BipedTest, IsKnockedOverByAHeavyVehicleAndGetsUpAgain) {
  std::vector<Event> events;
  const auto simulator = RunInto("ackermann car", 6.0, &events, 2.6);
  ASSERT_EQ(Count(events, EventKind::kKnockedOver, "walker"), 1);
  EXPECT_LT(Up(Now(*simulator, "walker")), 0.6);
  EXPECT_EQ(Now(*simulator, "walker").behaviour, Behaviour::kFallen);
  const double get_up_s = SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kHumanoidRobot).get_up_s;
  RunFor(simulator.get(), get_up_s + 4.0);
  const AgentSnapshot walker = Now(*simulator, "walker");
  ASSERT_GT(walker.health, 0.0);
  EXPECT_NEAR(Up(walker), 1.0, 1e-6);
  EXPECT_NEAR(walker.position_m.z(), 0.0, 0.05);
  const Eigen::Vector3d from_m = walker.position_m;
  RunWith(simulator.get(), 2.0, "walker", Forward(1.0));
  EXPECT_GT((Now(*simulator, "walker").position_m - from_m).norm(), 1.0) << "it walks again";
}

TEST(BipedTest, IsNotKnockedOverByALightTouch) {
  std::vector<Event> events;
  const auto simulator = RunInto("differential robot", 1.0, &events, 8.0);
  EXPECT_EQ(Count(events, EventKind::kKnockedOver, "walker"), 0);
  EXPECT_NEAR(Up(Now(*simulator, "walker")), 1.0, 1e-6);
}

// What holds it up when it stands is its base alone, on any ground that it climbs.
TEST(BipedTest, OnlyItsBaseTouchesASlopeThatItClimbs) {
  for (const Species& species : SpeciesCatalogue::BuiltIn()->all()) {
    if (species.plan != BodyPlan::kBiped && species.plan != BodyPlan::kGrazer) continue;
    const BodySpec body = BodyOf(species);
    const double slope_rad = species.max_slope_rad;
    for (std::size_t i = 1; i < body.ground_samples.size(); ++i) {
      const GroundSample& sample = body.ground_samples[i];
      const double above_m = sample.offset_m.z() * std::cos(slope_rad) -
                             sample.offset_m.head<2>().norm() * std::sin(slope_rad);
      EXPECT_GT(above_m, sample.radius_m) << species.name << " " << i;
    }
  }
}

TEST(BipedTest, WhatDiesStandingFalls) {
  for (const char* species : {"humanoid robot", "goblin", "ancient warrior", "sheep", "horse"}) {
    MindWorld world(TestScene{});
    Agent& agent = world.Add(species, 1, 0.3, 0.2, 0.7);
    PhysicsWorld& physics = *world.Now().physics;
    const auto run = [&](int steps) {
      for (int i = 0; i < steps; ++i) {
        Drive(&agent, {}, &world.Now());
        physics.Step(0.01, ++world.step);
        agent.motion = physics.MotionOf(agent.body);
      }
    };
    run(50);
    agent.hit_points = 0.0;
    run(300);
    EXPECT_LT((agent.motion.orientation * Eigen::Vector3d::UnitZ()).z(), 0.6) << species;
  }
}

}  // namespace
}  // namespace latticeworld
