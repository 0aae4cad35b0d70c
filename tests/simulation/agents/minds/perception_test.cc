#include "latticeworld/simulation/agents/minds/perception.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/agents/minds/mind_world.h"

namespace latticeworld {
namespace {

// A goblin (team 2) at the origin that looks east, and a warrior of team 3.
struct Meeting {
  explicit Meeting(const TestScene& scene, double x_m, double y_m)
      : world(scene),
        goblin(world.Add("goblin", 2, 0.0, 0.0)),
        other(world.Add("ancient warrior", 3, x_m, y_m)) {}

  // What one look of a goblin that knows of nobody tells it about the other.
  const Sighting* Look() {
    goblin.mind.memory.clear();
    world.Look(&goblin);
    return MemoryOf(goblin, other.id);
  }
  bool GoblinSees() {
    const Sighting* sighting = Look();
    return sighting != nullptr && sighting->seen_now;
  }
  bool GoblinHears() {
    const Sighting* sighting = Look();
    return sighting != nullptr && sighting->only_heard;
  }

  MindWorld world;
  Agent& goblin;
  Agent& other;
};

TestScene Wide() {
  TestScene scene;
  scene.size_m = 256.0;
  return scene;
}

TEST(PerceptionTest, SeesWhatIsInItsFieldOfViewAlone) {
  EXPECT_TRUE(Meeting(Wide(), 10.0, 0.0).GoblinSees());
  EXPECT_TRUE(Meeting(Wide(), 1.0, 10.0).GoblinSees());
  EXPECT_FALSE(Meeting(Wide(), -10.0, 0.0).GoblinSees());
  Meeting turned(Wide(), -10.0, 0.0);
  turned.goblin.motion.orientation = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(turned.GoblinSees());
}

TEST(PerceptionTest, SeesNoFartherThanItsKindDoes) {
  const double sight_m = Meeting(Wide(), 1.0, 0.0).goblin.species->sight_m;
  EXPECT_TRUE(Meeting(Wide(), sight_m - 1.0, 0.0).GoblinSees());
  EXPECT_FALSE(Meeting(Wide(), sight_m + 1.0, 0.0).GoblinSees());
}

TEST(PerceptionTest, FogAndNightShortenTheSight) {
  Meeting meeting(Wide(), 20.0, 0.0);
  EXPECT_TRUE(meeting.GoblinSees());
  meeting.world.atmosphere.visibility_m = 15.0;
  EXPECT_FALSE(meeting.GoblinSees());
  meeting.world.atmosphere.visibility_m = 20000.0;
  meeting.world.atmosphere.sun_intensity = 0.0;
  meeting.world.atmosphere.ambient_intensity = 0.05;
  EXPECT_FALSE(meeting.GoblinSees());
  meeting.other.motion.position_m.x() = 10.0;
  EXPECT_TRUE(meeting.GoblinSees());
}

TEST(PerceptionTest, TreesBuildingsAndHillsHide) {
  TestScene tree = Wide();
  tree.AddTree(5.0, 0.0, 0.5);
  EXPECT_FALSE(Meeting(tree, 10.0, 0.0).GoblinSees());
  EXPECT_TRUE(Meeting(tree, 10.0, 5.0).GoblinSees());
  TestScene building = Wide();
  building.AddBuilding(5.0, 0.0, 1.0, 4.0);
  EXPECT_FALSE(Meeting(building, 10.0, 0.0).GoblinSees());
  TestScene hill = Wide();
  hill.height_m = [](double x, double) { return 3.0 * std::exp(-0.1 * (x - 8.0) * (x - 8.0)); };
  EXPECT_FALSE(Meeting(hill, 16.0, 0.0).GoblinSees());
}

TEST(PerceptionTest, AFallenTreeHidesNoMore) {
  TestScene scene = Wide();
  scene.AddTree(5.0, 0.0, 0.5);
  Meeting meeting(scene, 10.0, 0.0);
  ASSERT_FALSE(meeting.GoblinSees());
  meeting.world.changes.fallen.push_back({0, {5.0, 0.0, 0.2}, {5.0, 8.0, 0.2}});
  EXPECT_TRUE(meeting.GoblinSees());
}

TEST(PerceptionTest, HearsWhatMovesBehindItsBackAndNotWhatStands) {
  Meeting meeting(Wide(), -8.0, 0.0);
  EXPECT_FALSE(meeting.GoblinHears());
  meeting.other.motion.linear_velocity_mps.x() = meeting.other.species->top_speed_mps;
  EXPECT_TRUE(meeting.GoblinHears());
  meeting.world.Look(&meeting.goblin);
  const Sighting* heard = MemoryOf(meeting.goblin, meeting.other.id);
  ASSERT_NE(heard, nullptr);
  EXPECT_TRUE(heard->only_heard);
  EXPECT_FALSE(heard->seen_now);
  EXPECT_EQ(heard->velocity_mps.norm(), 0.0);
}

TEST(PerceptionTest, SlowOnesWindAndRainAreHeardLessFar) {
  Meeting meeting(Wide(), -15.0, 0.0);
  meeting.other.motion.linear_velocity_mps.x() = meeting.other.species->top_speed_mps;
  ASSERT_TRUE(meeting.GoblinHears());
  meeting.world.atmosphere.wind_mps = {12.0, 0.0, 0.0};
  EXPECT_FALSE(meeting.GoblinHears());
  meeting.world.atmosphere.wind_mps.setZero();
  meeting.world.atmosphere.rain_mmph = 20.0;
  EXPECT_FALSE(meeting.GoblinHears());
  meeting.world.atmosphere.rain_mmph = 0.0;
  meeting.other.motion.linear_velocity_mps *= 0.3;
  EXPECT_FALSE(meeting.GoblinHears());
}

TEST(PerceptionTest, RemembersWhereItSawSomebodyForHalfAMinute) {
  Meeting meeting(Wide(), 10.0, 0.0);
  meeting.world.step = 100;
  meeting.other.motion.linear_velocity_mps = {0.0, 2.0, 0.0};
  meeting.world.Look(&meeting.goblin);
  ASSERT_EQ(meeting.goblin.mind.memory.size(), 1u);
  EXPECT_TRUE(meeting.goblin.mind.memory[0].seen_now);
  EXPECT_EQ(meeting.goblin.mind.memory[0].velocity_mps.y(), 2.0);

  meeting.other.motion.position_m = {-40.0, 0.0, 0.0};  // behind it, out of hearing
  meeting.world.step += 2900;
  meeting.world.Look(&meeting.goblin);
  const Sighting* known = MemoryOf(meeting.goblin, meeting.other.id);
  ASSERT_NE(known, nullptr);
  EXPECT_FALSE(known->seen_now);
  EXPECT_NEAR(known->position_m.x(), 10.0, 1e-9);
  EXPECT_EQ(known->step, 100u);
  meeting.world.step += 200;
  meeting.world.Look(&meeting.goblin);
  EXPECT_TRUE(meeting.goblin.mind.memory.empty());
}

TEST(PerceptionTest, ForgetsTheDeadAndTheRemovedAtOnce) {
  for (const bool removed : {false, true}) {
    Meeting meeting(Wide(), 10.0, 0.0);
    meeting.world.Look(&meeting.goblin);
    ASSERT_EQ(meeting.goblin.mind.memory.size(), 1u);
    if (removed) {
      meeting.world.Remove(meeting.other.id);
    } else {
      meeting.other.hit_points = 0.0;
    }
    meeting.world.Look(&meeting.goblin);
    EXPECT_TRUE(meeting.goblin.mind.memory.empty());
  }
}

TEST(PerceptionTest, OfACrowdItTakesInTheNearest) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  std::vector<AgentId> near;
  for (int i = 19; i >= 0; --i) {
    const Agent& enemy = world.Add("ancient warrior", 3, 5.0 + i, 2.0 * (i % 5) - 4.0);
    if (i < 4) near.push_back(enemy.id);
  }
  world.Look(&goblin);
  EXPECT_GE(goblin.mind.memory.size(), 4u);
  EXPECT_LE(goblin.mind.memory.size(), 8u);
  for (const AgentId id : near) EXPECT_NE(MemoryOf(goblin, id), nullptr);
  for (std::size_t i = 1; i < goblin.mind.memory.size(); ++i) {
    EXPECT_LT(goblin.mind.memory[i - 1].who, goblin.mind.memory[i].who);
  }
  const Sighting* nearest = NearestEnemy(goblin, world.Now(), 100.0, 1.0);
  ASSERT_NE(nearest, nullptr);
  for (const Sighting& sighting : goblin.mind.memory) {
    EXPECT_LE(nearest->position_m.norm(), sighting.position_m.norm());
  }
}

TEST(PerceptionTest, FriendsAndNeutralsAreNotHeeded) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  world.Add("goblin", 2, 5.0, 0.0);
  Agent& sheep = world.Add("sheep", 0, 8.0, 0.0, M_PI);
  world.Look(&goblin);
  EXPECT_TRUE(goblin.mind.memory.empty());
  world.Look(&sheep);
  EXPECT_EQ(sheep.mind.memory.size(), 2u) << "animals heed all that hunt";
  world.Add("humanoid robot", 1, 3.0, 0.0);  // strikes
  world.Add("ackermann car", 2, 3.0, 3.0);   // strikes nobody
  world.Look(&sheep);
  EXPECT_EQ(sheep.mind.memory.size(), 3u);
}

TEST(PerceptionTest, FeelsWhoStruckItFromBehind) {
  Meeting meeting(Wide(), -1.5, 0.0);
  meeting.world.step = 50;
  meeting.goblin.mind.hit_by = meeting.other.id;
  meeting.goblin.mind.hit_at = 45;
  meeting.world.Look(&meeting.goblin);
  EXPECT_NE(MemoryOf(meeting.goblin, meeting.other.id), nullptr);
}

}  // namespace
}  // namespace latticeworld
