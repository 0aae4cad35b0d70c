#include "latticeworld/learning/arena.h"

#include <cstring>

#include "learning/learning_scene.h"

namespace latticeworld {
namespace {

// Dropped beams are NaN, which equals nothing.
bool AreSameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), 4 * a.size()) == 0;
}

void Drive(Arena* arena, int steps, int of) {
  ASSERT_TRUE(arena->simulator()->Command("robot", Forward(1.0, 0.3)).ok());
  for (int done = 0; done < steps; done += of) {
    ASSERT_TRUE(arena->Advance(of, {"robot"}).ok());
  }
}

TEST(ArenaTest, SweepsAreTheSameWhetherStepsComeOneByOneOrTogether) {
  for (const double rate_hz : {4.0, 10.0, 33.0, 40.0, 100.0}) {
    const auto together = MakeArena(rate_hz), one_by_one = MakeArena(rate_hz);
    int complete = 0;
    for (int call = 0; call < 6; ++call) {
      Drive(together.get(), 10, 10);
      Drive(one_by_one.get(), 10, 1);
      const LidarSweep* a = together->SweepOf("robot");
      const LidarSweep* b = one_by_one->SweepOf("robot");
      ASSERT_EQ(a == nullptr, b == nullptr) << rate_hz << " Hz, call " << call;
      if (a == nullptr) continue;
      ++complete;
      EXPECT_EQ(a->begin_s, b->begin_s);
      EXPECT_TRUE(AreSameBits(a->ranges_m, b->ranges_m)) << rate_hz << " Hz, call " << call;
      EXPECT_TRUE(AreSameBits(a->intensities, b->intensities));
    }
    EXPECT_GE(complete, 2) << rate_hz << " Hz";
    EXPECT_EQ(together->simulator()->StateHash(), one_by_one->simulator()->StateHash());
  }
}

TEST(ArenaTest, TheSweepIsTheLastCompleteOne) {
  const auto arena = MakeArena(40.0);
  Drive(arena.get(), 20, 10);
  const LidarSweep* sweep = arena->SweepOf("robot");
  ASSERT_NE(sweep, nullptr);
  EXPECT_NEAR(sweep->end_s, 0.2, 1e-9);
  Drive(arena.get(), 1, 1);
  EXPECT_NEAR(arena->SweepOf("robot")->end_s, 0.2, 1e-9);
}

TEST(ArenaTest, OnlyThoseThatAreScannedHaveSweeps) {
  const auto arena = MakeArena();
  ASSERT_TRUE(arena->Advance(10, {"robot", "scout"}).ok());
  EXPECT_NE(arena->SweepOf("scout"), nullptr);
  ASSERT_TRUE(arena->Advance(10, {"robot"}).ok());
  EXPECT_EQ(arena->SweepOf("scout"), nullptr);
  EXPECT_NE(arena->SweepOf("robot"), nullptr);
}

TEST(ArenaTest, AfterAResetAllIsAsAtTheStart) {
  const auto fresh = MakeArena(40.0, 5), used = MakeArena(40.0, 1);
  Drive(used.get(), 70, 7);
  used->Reset(5);
  EXPECT_EQ(used->SweepOf("robot"), nullptr);
  Drive(used.get(), 30, 10);
  Drive(fresh.get(), 30, 10);
  EXPECT_EQ(fresh->simulator()->StateHash(), used->simulator()->StateHash());
  EXPECT_TRUE(AreSameBits(fresh->SweepOf("robot")->ranges_m, used->SweepOf("robot")->ranges_m));
}

TEST(ArenaTest, EventsAreThoseOfTheStepsAlone) {
  const auto arena = MakeArena();
  MustSpawn(arena->simulator(), RequestFor("sheep", "sheep", 10.0, 20.0));
  ASSERT_TRUE(arena->Advance(1, {}).ok());
  EXPECT_EQ(0, Count(arena->events(), EventKind::kSpawned, "sheep"));
}

TEST(ArenaTest, ACheckEndsItBetweenTwoSteps) {
  const auto arena = MakeArena();
  int asked = 0;
  const Status status =
      arena->Advance(1000, {"robot"}, [&] { return ++asked < 3 ? Status() : Cancelled("enough"); });
  EXPECT_EQ(status.code(), StatusCode::kCancelled);
  EXPECT_EQ(arena->simulator()->State()->episode_step, 150u);
  EXPECT_TRUE(arena->Advance(10, {"robot"}).ok());
  EXPECT_NE(arena->SweepOf("robot"), nullptr);
}

TEST(ArenaTest, ASuiteWithoutAScannerIsRefusedByName) {
  ArenaOptions options;
  options.sensors = std::make_shared<const SensorSuite>(SensorSuite{"blind", {}});
  const auto arena = Arena::Create(HillsWithRobots(), options, 1);
  EXPECT_EQ(arena.status().code(), StatusCode::kInvalidArgument);
  EXPECT_NE(arena.status().message().find("blind"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
