#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// A goblin that is back three seconds after its death and takes a blow to die.
SimulatorOptions WithPhoenix() {
  const char* const text = R"({"species": [{
      "name": "phoenix", "category": "goblin", "plan": "biped", "mass_kg": 45, "height_m": 1.2,
      "radius_m": 0.4, "eye_height_m": 1.1, "cruise_mps": 1.2, "top_speed_mps": 3.5,
      "acceleration_mps2": 4, "turn_rate_radps": 3, "max_slope_rad": 0.7, "wade_depth_m": 0.4,
      "drag_area_m2": 0.4, "water_drag_area_m2": 0.35, "density_kgpm3": 1010,
      "field_of_view_rad": 3.3, "sight_m": 50, "hearing_m": 25, "hit_points": 5, "grip": 1.5,
      "drowning_depth_m": 1.0, "drowning_time_s": 20, "knock_over_mps": 1.8, "get_up_s": 1.5,
      "hurt_share": 0.3, "respawn_s": 3}]})";
  const auto species = SpeciesCatalogue::Extended({{"phoenix.json", text}});
  EXPECT_TRUE(species.ok()) << species.status().ToString();
  SimulatorOptions options;
  if (species.ok()) options.species = *species;
  return options;
}

// A hero who can strike, and a phoenix before it.
std::unique_ptr<Simulator> Duel() {
  TestScene scene;
  AgentStart& hero = scene.AddAgent("hero", AgentCategory::kAncientWarrior, 0.0, 0.0);
  hero.controllable = true;
  hero.team = 1;
  auto simulator = MakeSimulator(scene, 1, WithPhoenix());
  SpawnRequest request = RequestFor("phoenix", "phoenix", 1.3, 0.0);
  request.policy = "external";  // stands
  MustSpawn(simulator.get(), request);
  return simulator;
}

void Slay(Simulator* simulator) {
  ASSERT_TRUE(simulator->Strike("hero").ok());
  RunFor(simulator, 0.5);
  ASSERT_EQ(Now(*simulator, "phoenix").health, 0.0);
}

TEST(RespawningTest, ComesBackWholeAtItsStartAfterItsTime) {
  const auto simulator = Duel();
  Slay(simulator.get());
  RunFor(simulator.get(), 2.0);
  AgentSnapshot phoenix = Now(*simulator, "phoenix");
  EXPECT_EQ(phoenix.behaviour, Behaviour::kDead);
  EXPECT_EQ(phoenix.health, 0.0);
  RunFor(simulator.get(), 1.0);
  phoenix = Now(*simulator, "phoenix");
  EXPECT_EQ(phoenix.health, 1.0);
  EXPECT_NEAR((phoenix.position_m - Eigen::Vector3d(1.3, 0.0, 0.0)).norm(), 0.0, 0.05);
  const auto events = simulator->TakeEvents();
  EXPECT_EQ(Count(events, EventKind::kDied, "phoenix"), 1);
  EXPECT_EQ(Count(events, EventKind::kRespawned, "phoenix"), 1);
  // It lives: it can die again, and be removed.
  Slay(simulator.get());
  EXPECT_TRUE(simulator->Remove("phoenix").ok());
  RunFor(simulator.get(), 4.0);
}

TEST(RespawningTest, ComesBackNearbyWhereItsStartIsTaken) {
  const auto simulator = Duel();
  ASSERT_TRUE(simulator->Strike("hero").ok());
  RunFor(simulator.get(), 0.5);
  // Whoever slew it goes and stands there.
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(simulator->Command("hero", Forward(1.5)).ok());
    simulator->Step();
  }
  RunFor(simulator.get(), 3.0);
  const AgentSnapshot phoenix = Now(*simulator, "phoenix"), hero = Now(*simulator, "hero");
  EXPECT_EQ(phoenix.health, 1.0);
  EXPECT_GT((phoenix.position_m - hero.position_m).head<2>().norm(), 0.8);
  EXPECT_LT((phoenix.position_m - Eigen::Vector3d(1.3, 0.0, 0.0)).norm(), 16.0);
}

TEST(RespawningTest, WhoHasNoSuchRuleStaysDead) {
  TestScene scene;
  AgentStart& hero = scene.AddAgent("hero", AgentCategory::kAncientWarrior, 0.0, 0.0);
  hero.controllable = true;
  hero.team = 1;
  scene.AddAgent("goblin", AgentCategory::kGoblin, 1.3, 0.0).state = AgentState::kIdle;
  const auto simulator = MakeSimulator(scene);
  ASSERT_TRUE(simulator->SetPolicy({"goblin", std::nullopt, "external"}).ok());
  for (int i = 0; i < 3000 && Now(*simulator, "goblin").health > 0.0; ++i) {
    // Follows it where the blows push it.
    const AgentSnapshot goblin = Now(*simulator, "goblin"), self = Now(*simulator, "hero");
    const Eigen::Vector3d way =
        self.orientation.conjugate() * (goblin.position_m - self.position_m);
    const double turn = std::atan2(way.y(), way.x());
    const double speed_mps = way.norm() > 1.4 && std::abs(turn) < 0.5 ? 1.0 : 0.0;
    ASSERT_TRUE(simulator->Command("hero", Forward(speed_mps, 2.0 * turn)).ok());
    ASSERT_TRUE(simulator->Strike("hero").ok());
    simulator->Step();
  }
  ASSERT_EQ(Now(*simulator, "goblin").health, 0.0);
  RunFor(simulator.get(), 5.0);
  EXPECT_EQ(Now(*simulator, "goblin").health, 0.0);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kDead);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kDied, "goblin"), 1);
}

}  // namespace
}  // namespace latticeworld
