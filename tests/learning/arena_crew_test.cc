#include "latticeworld/learning/arena_crew.h"

#include <cmath>
#include <cstring>

#include "learning/learning_scene.h"

namespace latticeworld {
namespace {

constexpr int kArenas = 5, kRobots = 2, kSectors = 36, kCalls = 4;

struct Rollout {
  std::vector<RobotView> views = std::vector<RobotView>(kArenas * kRobots);
  std::vector<float> scans = std::vector<float>(kArenas * kRobots * kSectors);
  std::vector<std::string> hashes;
};

CrewLayout Layout() { return {{"robot", "scout"}, kSectors, 20.0f}; }

std::vector<double> ActionsOf(int call) {
  std::vector<double> actions;
  for (int row = 0; row < kArenas * kRobots; ++row) {
    actions.push_back(1.0 + 0.05 * row);
    actions.push_back(std::sin(call + row));
  }
  return actions;
}

Rollout RollOut(int threads) {
  std::vector<std::unique_ptr<Arena>> arenas;
  std::vector<Arena*> all;
  for (int i = 0; i < kArenas; ++i) {
    arenas.push_back(MakeArena(40.0, static_cast<std::uint64_t>(i + 1)));
    all.push_back(arenas.back().get());
  }
  ArenaCrew crew(Layout(), threads);
  Rollout rollout;
  const std::vector<unsigned char> acting(kArenas * kRobots, 1);
  for (int call = 0; call < kCalls; ++call) {
    const std::vector<double> actions = ActionsOf(call);
    const CrewArrays arrays{actions.data(), acting.data(), rollout.views.data(),
                            rollout.scans.data(), kSectors};
    for (const Status& status : crew.Advance(all, std::vector<int>(kArenas, 10), arrays)) {
      EXPECT_TRUE(status.ok()) << status.ToString();
    }
  }
  for (Arena* arena : all) rollout.hashes.push_back(arena->simulator()->StateHash());
  return rollout;
}

TEST(ArenaCrewTest, ManySideBySideAreWhatEachIsAlone) {
  Rollout alone;
  for (int i = 0; i < kArenas; ++i) {
    const auto arena = MakeArena(40.0, static_cast<std::uint64_t>(i + 1));
    for (int call = 0; call < kCalls; ++call) {
      const std::vector<double> actions = ActionsOf(call);
      for (int robot = 0; robot < kRobots; ++robot) {
        const int row = i * kRobots + robot;
        ASSERT_TRUE(
            arena->simulator()
                ->Command(Layout().robots[robot], Forward(actions[2 * row], actions[2 * row + 1]))
                .ok());
      }
      ASSERT_TRUE(arena->Advance(10, Layout().robots).ok());
    }
    for (int robot = 0; robot < kRobots; ++robot) {
      const int row = i * kRobots + robot;
      alone.views[row] = ViewOf(Now(*arena->simulator(), Layout().robots[robot]));
      NearestInSectors(arena->SweepOf(Layout().robots[robot]), arena->scanner()->min_range_m,
                       kSectors, 20.0f, &alone.scans[row * kSectors]);
    }
    alone.hashes.push_back(arena->simulator()->StateHash());
  }
  for (const int threads : {1, 2, 4}) {
    const Rollout together = RollOut(threads);
    EXPECT_EQ(alone.hashes, together.hashes) << threads;
    EXPECT_EQ(alone.scans, together.scans) << threads;
    EXPECT_EQ(0, std::memcmp(alone.views.data(), together.views.data(),
                             alone.views.size() * sizeof(RobotView)))
        << threads;
  }
}

TEST(ArenaCrewTest, AnErrorIsOfItsArenaAlone) {
  const auto well = MakeArena(), lacking = MakeArena();
  ASSERT_TRUE(lacking->simulator()->Remove("scout").ok());
  ArenaCrew crew(Layout(), 2);
  std::vector<RobotView> views(2 * kRobots);
  std::vector<float> scans(2 * kRobots * kSectors, -1.0f);
  const std::vector<double> actions(4 * kRobots, 0.5);
  const std::vector<unsigned char> acting(2 * kRobots, 1);
  const auto statuses =
      crew.Advance({lacking.get(), well.get()}, {10, 10},
                   {actions.data(), acting.data(), views.data(), scans.data(), kSectors});
  EXPECT_EQ(statuses[0].code(), StatusCode::kNotFound);
  EXPECT_TRUE(statuses[1].ok());
  EXPECT_EQ(scans[0], -1.0f);
  EXPECT_NE(scans[kRobots * kSectors], -1.0f);
}

TEST(ArenaCrewTest, WhoDoesNotActIsNeitherToldNorObserved) {
  const auto arena = MakeArena();
  ArenaCrew crew(Layout(), 1);
  std::vector<RobotView> views(kRobots);
  views[1].x_m = 1234.0;
  std::vector<float> scans(kRobots * kSectors, -1.0f);
  const std::vector<double> actions = {0.5, 0.0, std::nan(""), 0.0};
  const std::vector<unsigned char> acting = {1, 0};
  const auto statuses = crew.Advance(
      {arena.get()}, {10}, {actions.data(), acting.data(), views.data(), scans.data(), kSectors});
  EXPECT_TRUE(statuses[0].ok()) << statuses[0].ToString();
  EXPECT_EQ(views[1].x_m, 1234.0);
  EXPECT_EQ(scans[kSectors], -1.0f);
}

}  // namespace
}  // namespace latticeworld
