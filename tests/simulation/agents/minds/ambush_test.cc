#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "latticeworld/common/digest.h"
#include "latticeworld/sensing/line_of_sight.h"
#include "latticeworld/simulation/agents/minds/pieces_cunning.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "simulation/agents/minds/mind_world.h"

namespace latticeworld {
namespace {

TestScene RoadBesideHouses() {
  TestScene scene;
  scene.size_m = 128.0;
  scene.surface = [](double, double y) {
    return std::abs(y) < 2.0 ? SurfaceClass::kRoad : SurfaceClass::kGrass;
  };
  for (int i = 0; i < 12; ++i) scene.AddBuilding(-44.0 + 8.0 * i, 7.0, 1.5, 1.5);
  return scene;
}

std::string HashOf(const Agent& agent) {
  Digest digest;
  AddTo(&digest, agent);
  return digest.Hex();
}

TEST(AmbushTest, HidesAndLetsTheFarPassAndStrikesTheNear) {
  MindWorld world(RoadBesideHouses());
  Agent& goblin = world.Add("goblin", 2, 0.0, 1.0);
  world.Run(40.0, {{goblin.id, "ambusher"}});
  ASSERT_EQ(goblin.behaviour, Behaviour::kAmbush);
  ASSERT_LT(goblin.motion.linear_velocity_mps.norm(), 0.1) << "it waits";
  const WorldPoint hide = goblin.place();
  int hidden = 0, looks = 0;
  for (double x = -30.0; x <= 30.0; x += 3.0, ++looks) {
    const Eigen::Vector3d road(x, 0.0, 1.2), eye(hide.x_m, hide.y_m, goblin.species->eye_height_m);
    hidden += HasLineOfSight(*world.Now().scene, SceneChanges(), road, eye) ? 0 : 1;
  }
  EXPECT_GT(hidden, looks / 3) << "from much of the road it is not seen";

  Agent& robot = world.Add("humanoid robot", 1, hide.x_m + 15.0, hide.y_m);
  robot.controllable = true;
  world.Run(5.0, {{goblin.id, "ambusher"}});
  EXPECT_EQ(goblin.behaviour, Behaviour::kAmbush) << "too far";
  const double yaw_rad = goblin.motion.yaw_rad();
  robot.motion.position_m.head<2>() =
      Eigen::Vector2d(hide.x_m + 3.0 * std::cos(yaw_rad), hide.y_m + 3.0 * std::sin(yaw_rad));
  world.Run(4.0, {{goblin.id, "ambusher"}});
  EXPECT_GT(world.Count(EventKind::kAttacked, goblin.name), 0);
}

// Sight rays are dear, and a world may hold many who lie in wait.
TEST(AmbushTest, LooksAtOnePlaceAThoughtAndStandsUntilItHasDecided) {
  MindWorld world(TestScene{});  // nothing hides it anywhere: it looks at as many as it may
  Agent& goblin = world.Add("goblin", 2, 0.0, 1.0);
  int thoughts = 0, tries = 0;
  for (; thoughts < 30 && !goblin.mind.hide.has_value(); ++thoughts) {
    world.Run(0.1, {{goblin.id, "ambusher"}});
    EXPECT_LE(goblin.mind.ambush.tries, tries + 1) << "of thought " << thoughts;
    tries = goblin.mind.ambush.tries;
    EXPECT_EQ(goblin.behaviour, Behaviour::kAmbush);
    EXPECT_LT(goblin.motion.position_m.head<2>().norm(), 1.1) << "it stands";
  }
  EXPECT_GE(thoughts, 12);
  EXPECT_LE(thoughts, 14);
  EXPECT_TRUE(goblin.mind.hide.has_value());
}

TEST(AmbushTest, WhatItHasLookedAtIsPartOfTheState) {
  MindWorld world(RoadBesideHouses());
  Agent& goblin = world.Add("goblin", 2, 0.0, 1.0);
  world.Run(0.2, {{goblin.id, "ambusher"}});
  ASSERT_FALSE(goblin.mind.ambush.watched.empty());
  const std::string hash = HashOf(goblin);
  const AmbushPlan plan = goblin.mind.ambush;
  goblin.mind.ambush.tries += 1;
  EXPECT_NE(HashOf(goblin), hash);
  goblin.mind.ambush = plan;
  goblin.mind.ambush.watched.pop_back();
  EXPECT_NE(HashOf(goblin), hash);
  goblin.mind.ambush = plan;
  goblin.mind.ambush.best = WorldPoint{1.0, 2.0};
  EXPECT_NE(HashOf(goblin), hash);
  goblin.mind.ambush = plan;
  EXPECT_EQ(HashOf(goblin), hash);
}

TEST(AmbushTest, WhereNothingHidesItWaitsSomewhereAllTheSame) {
  MindWorld world(TestScene{});
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  world.Run(40.0, {{goblin.id, "ambusher"}});
  EXPECT_EQ(goblin.behaviour, Behaviour::kAmbush);
  EXPECT_LT(goblin.motion.linear_velocity_mps.norm(), 0.1);
}

}  // namespace
}  // namespace latticeworld
