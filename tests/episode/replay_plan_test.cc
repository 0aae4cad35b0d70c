#include "latticeworld/episode/replay_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace latticeworld {
namespace {

// Ten calls of steps 10, 20 .. 100, the sixth of them a reset, and a hash 5 steps after each.
RecordedSimulation Recorded() {
  RecordedSimulation recorded;
  recorded.beginning = {7, 0, 0};
  recorded.hashes.push_back({0, 0, "start"});
  for (std::uint64_t i = 1; i <= 10; ++i) {
    JournalCall call = StrikeCall{"a"};
    if (i == 6) call = ResetCall{9};
    recorded.calls.push_back({i, 10 * i, call});
    recorded.hashes.push_back({10 * i + 5, i, "hash"});
  }
  return recorded;
}

ReplayPlan PlanOf(RecordedSimulation recorded, std::size_t warnings_wanted) {
  std::vector<std::string> warnings;
  auto plan = MakeReplayPlan(std::move(recorded), &warnings);
  EXPECT_TRUE(plan.ok()) << plan.status().ToString();
  EXPECT_EQ(warnings.size(), warnings_wanted);
  return plan.ok() ? *std::move(plan) : ReplayPlan();
}

TEST(ReplayPlanTest, AWholeRecordIsUsedWhole) {
  const ReplayPlan plan = PlanOf(Recorded(), 0);
  EXPECT_EQ(plan.beginning.seed, 7u);
  EXPECT_EQ(plan.calls.size(), 10u);
  EXPECT_EQ(plan.hashes.size(), 11u);
}

TEST(ReplayPlanTest, OrderAndRepetitionDoNotMatter) {
  RecordedSimulation recorded = Recorded();
  std::reverse(recorded.calls.begin(), recorded.calls.end());
  std::reverse(recorded.hashes.begin(), recorded.hashes.end());
  recorded.calls.push_back(recorded.calls.front());
  recorded.hashes.push_back(recorded.hashes.front());
  const ReplayPlan plan = PlanOf(recorded, 0);
  ASSERT_EQ(plan.calls.size(), 10u);
  EXPECT_EQ(plan.calls.front().number, 1u);
  EXPECT_EQ(plan.hashes.size(), 11u);
  EXPECT_EQ(plan.hashes.front().step, 0u);
}

TEST(ReplayPlanTest, HashesThatContradictEachOtherBothStay) {
  RecordedSimulation recorded = Recorded();
  recorded.hashes.push_back({15, 1, "another"});
  EXPECT_EQ(PlanOf(recorded, 0).hashes.size(), 12u);
}

TEST(ReplayPlanTest, AfterALateGapTheRestIsLeftOut) {
  RecordedSimulation recorded = Recorded();
  recorded.calls.erase(recorded.calls.begin() + 8);  // the ninth
  const ReplayPlan plan = PlanOf(recorded, 1);
  EXPECT_EQ(plan.beginning.number, 0u);
  EXPECT_EQ(plan.calls.size(), 8u);
  EXPECT_EQ(plan.hashes.back().calls, 8u);
}

TEST(ReplayPlanTest, AfterAnEarlyGapTheResetIsTheBeginning) {
  RecordedSimulation recorded = Recorded();
  recorded.calls.erase(recorded.calls.begin() + 1);  // the second
  const ReplayPlan plan = PlanOf(recorded, 1);
  EXPECT_EQ(plan.beginning.seed, 9u);
  EXPECT_EQ(plan.beginning.number, 6u);
  EXPECT_EQ(plan.beginning.step, 60u);
  ASSERT_EQ(plan.calls.size(), 4u);
  EXPECT_EQ(plan.calls.front().number, 7u);
  EXPECT_EQ(plan.hashes.size(), 5u);  // of after the reset itself as well
}

TEST(ReplayPlanTest, CallsThatAreMissingAtTheEndTakeTheirHashesAlong) {
  RecordedSimulation recorded = Recorded();
  recorded.calls.pop_back();
  EXPECT_EQ(PlanOf(recorded, 1).hashes.back().calls, 9u);
}

TEST(ReplayPlanTest, WithoutAHashThereIsNothingToProve) {
  RecordedSimulation recorded = Recorded();
  recorded.hashes.clear();
  std::vector<std::string> warnings;
  EXPECT_EQ(MakeReplayPlan(recorded, &warnings).status().code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
