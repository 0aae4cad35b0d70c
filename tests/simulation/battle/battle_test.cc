// A battle of a hundred agents over 60 s of simulated time is the same battle every time.

#include "simulation/battle/battle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::uint64_t kSteps = 6000, kMiddle = 3000;

// Another process that fights the same battle; its hashes once it has ended.
class OtherProcess {
 public:
  OtherProcess() {
    const std::string command = std::string(LATTICEWORLD_BATTLE_RUN) + " " + std::to_string(kSeed) +
                                " " + std::to_string(kSteps);
    pipe_ = ::popen(command.c_str(), "r");
  }
  ~OtherProcess() {
    if (pipe_ != nullptr) ::pclose(pipe_);
  }
  std::vector<std::string> Hashes() {
    std::vector<std::string> hashes;
    char line[128];
    while (pipe_ != nullptr && std::fgets(line, sizeof(line), pipe_) != nullptr) {
      hashes.emplace_back(line);
      while (!hashes.back().empty() && hashes.back().back() == '\n') hashes.back().pop_back();
    }
    return hashes;
  }

 private:
  std::FILE* pipe_ = nullptr;
};

int CountOf(const std::vector<Event>& events, EventKind kind) {
  return static_cast<int>(std::count_if(events.begin(), events.end(),
                                        [&](const Event& event) { return event.kind == kind; }));
}

TEST(BattleTest, IsTheSameInOneProcessInTwoAfterRestoreAndWithAnyThreads) {
  OtherProcess other;  // runs beside this one
  const auto scene = BattleScene();
  const auto one = BeginBattle(scene, kSeed, 1);
  EXPECT_GE(one->State()->agents.size(), 100u);
  std::vector<std::string> hashes;
  RunBattle(one.get(), kMiddle, &hashes);
  const auto middle = one->Save();
  RunBattle(one.get(), kSteps, &hashes);
  ASSERT_EQ(hashes.size(), 12u);

  // It is a battle: otherwise the hashes would say little.
  const std::vector<Event> events = one->TakeEvents();
  EXPECT_GT(CountOf(events, EventKind::kHit), 100);
  EXPECT_GT(CountOf(events, EventKind::kDied), 10);
  EXPECT_GT(CountOf(events, EventKind::kKnockedOver), 0);
  EXPECT_GT(CountOf(events, EventKind::kFelledTree), 0);
  EXPECT_EQ(CountOf(events, EventKind::kFrozen), 0);
  EXPECT_EQ(CountOf(events, EventKind::kLeftWorld), 0);

  std::vector<std::string> again;
  const auto two = BeginBattle(scene, kSeed, 3);
  RunBattle(two.get(), kMiddle, &again);
  // The rest from the first one's snapshot, after a detour of its own.
  for (int i = 0; i < 100; ++i) two->Step();
  ASSERT_NE(two->StateHash(), again.back());
  ASSERT_TRUE(two->Restore(*middle).ok());
  ASSERT_EQ(two->StateHash(), again.back());
  RunBattle(two.get(), kSteps, &again);
  EXPECT_EQ(again, hashes);
  EXPECT_EQ(other.Hashes(), hashes);
}

TEST(BattleTest, AnotherSeedIsAnotherBattle) {
  const auto scene = BattleScene();
  // By where the fighters are: hashes hold the seed itself.
  const auto places = [&scene](std::uint64_t seed) {
    const auto battle = BeginBattle(scene, seed);
    std::vector<std::string> hashes;
    RunBattle(battle.get(), 500, &hashes);
    std::map<std::string, Eigen::Vector3d> places;
    for (const AgentSnapshot& agent : battle->State()->agents) {
      places[agent.name] = agent.position_m;
    }
    return places;
  };
  const auto one = places(1), two = places(2);
  ASSERT_EQ(one.size(), two.size());
  int apart = 0;
  for (const auto& [name, place] : one) apart += two.at(name) != place;
  EXPECT_GT(apart, static_cast<int>(one.size()) / 2);
}

}  // namespace
}  // namespace latticeworld
