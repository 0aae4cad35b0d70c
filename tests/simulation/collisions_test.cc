#include "latticeworld/simulation/collisions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

TEST(CollisionsTest, DamageGrowsFromHarmlessToDeadly) {
  const Species& sheep = SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kSheep);
  EXPECT_EQ(CollisionDamage(sheep, 0.0), 0.0);
  EXPECT_EQ(CollisionDamage(sheep, 3.0), 0.0);
  EXPECT_NEAR(CollisionDamage(sheep, 10.5), 0.5 * sheep.hit_points, 1e-9);
  EXPECT_EQ(CollisionDamage(sheep, 18.0), sheep.hit_points);
  EXPECT_EQ(CollisionDamage(sheep, 1e9), sheep.hit_points);
}

// What a goblin suffers from a vehicle that is driven at it.
struct Ram {
  double health;
  int knocked_over;
  int collided;
};
Ram RunOver(const std::string& species, double speed_mps) {
  TestScene scene;
  scene.size_m = 128.0;
  scene.cells = 128;
  scene.AddAgent("goblin", AgentCategory::kGoblin, 20.0, 0.0).state = AgentState::kIdle;
  const auto simulator = MakeSimulator(scene);
  EXPECT_TRUE(simulator->SetPolicy({"goblin", std::nullopt, "external"}).ok());
  SpawnRequest request = RequestFor(species, "rammer", -40.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  for (int i = 0; i < 6000 && Now(*simulator, "rammer").position_m.x() < 21.0; ++i) {
    EXPECT_TRUE(simulator->Command("rammer", Forward(speed_mps)).ok());
    simulator->Step();
  }
  const auto events = simulator->TakeEvents();
  return {Now(*simulator, "goblin").health, Count(events, EventKind::kKnockedOver, "goblin"),
          Count(events, EventKind::kCollided, "goblin")};
}

TEST(CollisionsTest, ASlowPushHurtsNobodyAndAFastHeavyOneDoes) {
  const Ram slow = RunOver("tractor", 1.0);
  EXPECT_EQ(slow.health, 1.0);
  EXPECT_GE(slow.collided, 1);
  const Ram fast = RunOver("tractor", 7.0);
  EXPECT_LT(fast.health, 1.0);
  EXPECT_GE(fast.knocked_over, 1);
}

TEST(CollisionsTest, ALightOneAtTheSameSpeedHurtsLess) {
  // 24 kg at 2 m/s against 45 kg: it changes the goblin's speed by 0.7 m/s.
  const Ram light = RunOver("wheeled robot", 2.0);
  EXPECT_EQ(light.health, 1.0);
  EXPECT_EQ(light.knocked_over, 0);
}

}  // namespace
}  // namespace latticeworld
