#include "latticeworld/campaign/reports/tables.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "latticeworld/campaign/trial_result.h"

namespace latticeworld {
namespace {

Campaign MakeCampaign() {
  Campaign campaign;
  campaign.name = "test";
  campaign.worlds.resize(2);
  campaign.worlds[0].name = "lake";
  campaign.worlds[1].name = "wood";
  campaign.robots.resize(1);
  campaign.conditions.resize(1);
  campaign.conditions[0].seeds = {1};
  campaign.tasks.count = 3;
  return campaign;
}

// Task k of each world is 10 (k + 1) m long; all succeed in the first world and none in the second.
std::vector<FinishedTrial> MakeTrials(const Campaign& campaign) {
  std::vector<FinishedTrial> trials;
  for (const PlannedTrial& plan : PlanOf(campaign)) {
    FinishedTrial trial{plan, {}};
    trial.result.id = plan.id;
    trial.result.world_id = "world-1";
    trial.result.ended_by = plan.world == 0 ? "arrived" : "time limit";
    trial.result.difficulty.length_m = 10.0 * static_cast<double>(plan.task + 1);
    trial.result.metrics.success = plan.world == 0;
    trial.result.metrics.timed_out = plan.world == 1;
    trial.result.metrics.spl = plan.world == 0 ? 0.5 : 0.0;
    trial.result.metrics.least_time_to_collision_s = std::numeric_limits<double>::infinity();
    trials.push_back(trial);
  }
  return trials;
}

const TrialGroup& Find(const std::vector<TrialGroup>& groups, const std::string& by,
                       const std::string& name) {
  for (const TrialGroup& group : groups) {
    if (group.by == by && group.name == name) return group;
  }
  ADD_FAILURE() << "no group " << by << " " << name;
  return groups.front();
}

TEST(TablesTest, GroupsSplitByWorldAndByThirdsOfDifficulty) {
  const Campaign campaign = MakeCampaign();
  const auto groups = GroupsOf(campaign, MakeTrials(campaign));
  EXPECT_EQ(Find(groups, "all", "").summary.trials, 6);
  EXPECT_DOUBLE_EQ(Find(groups, "all", "").summary.success_share, 0.5);
  EXPECT_DOUBLE_EQ(Find(groups, "world", "lake").summary.success_share, 1.0);
  EXPECT_DOUBLE_EQ(Find(groups, "world", "wood").summary.success_share, 0.0);
  int thirds = 0, in_thirds = 0;
  for (const TrialGroup& group : groups) {
    EXPECT_NE(group.by, "climb_m");  // all tasks are as level
    if (group.by != "length_m") continue;
    ++thirds;
    in_thirds += group.summary.trials;
  }
  EXPECT_EQ(thirds, 3);
  EXPECT_EQ(in_thirds, 6);
}

TEST(TablesTest, WhatCouldNotBeRunIsCountedApart) {
  const Campaign campaign = MakeCampaign();
  auto trials = MakeTrials(campaign);
  trials[0].result = ErrorOf(trials[0].plan, "its process was ended by signal 11, twice");
  const auto groups = GroupsOf(campaign, trials);
  EXPECT_EQ(Find(groups, "all", "").summary.trials, 5);
  EXPECT_EQ(Find(groups, "all", "").errors, 1);
  EXPECT_EQ(Find(groups, "world", "lake").errors, 1);
}

TEST(TablesTest, TheCsvHasARowForEveryTrialAndQuotesReasons) {
  const Campaign campaign = MakeCampaign();
  auto trials = MakeTrials(campaign);
  trials[4].result.ended_by = "stack failed";
  trials[4].result.why = "blocked, \"twice\"";
  const std::string csv = TrialsCsv(campaign, trials);
  std::size_t rows = 0;
  for (const char letter : csv) rows += letter == '\n';
  EXPECT_EQ(rows, 7u);
  EXPECT_NE(csv.find("stack failed,\"blocked, \"\"twice\"\"\","), std::string::npos);
  EXPECT_NE(csv.find(",inf,"), std::string::npos);
}

TEST(TablesTest, ResultsReadBackAsTheyWere) {
  const Campaign campaign = MakeCampaign();
  TrialResult result = MakeTrials(campaign)[1].result;
  result.why = "\xff\xfe broken letters";
  result.interventions = {1, 2, 3};
  result.metrics.energy_j = 1.0 / 3.0;
  result.driven_m = {{1.0, 2.0}, {3.25, -4.5}};
  const std::string text = EncodeTrialResult(result);
  const auto read = DecodeTrialResult(text);
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  EXPECT_EQ(EncodeTrialResult(*read), text);
  EXPECT_EQ(read->metrics.energy_j, result.metrics.energy_j);
  EXPECT_EQ(read->metrics.least_time_to_collision_s, std::numeric_limits<double>::infinity());
  EXPECT_EQ(read->driven_m, result.driven_m);
  for (std::size_t cut = 0; cut + 2 < text.size(); cut += 7) {
    EXPECT_EQ(DecodeTrialResult(text.substr(0, cut)).status().code(), StatusCode::kDataLoss);
  }
}

// Once such numbers were cast to counts, whatever their size.
TEST(TablesTest, CountsThatAreNoneAreDamage) {
  const Campaign campaign = MakeCampaign();
  TrialResult result = MakeTrials(campaign)[1].result;
  result.difficulty.agents = 12321;
  result.interventions.hits = 12322;
  const std::string text = EncodeTrialResult(result);
  ASSERT_TRUE(DecodeTrialResult(text).ok());
  for (const char* count : {"12321", "12322"}) {
    for (const char* number : {"null", "1e300", "-1e300", "2.5", "4294967296", "\"1\""}) {
      std::string damaged = text;
      const std::size_t at = damaged.find(count);
      ASSERT_NE(at, std::string::npos) << count;
      const std::size_t end = damaged.find_first_of(",}", at);
      damaged.replace(at, end - at, number);
      EXPECT_EQ(DecodeTrialResult(damaged).status().code(), StatusCode::kDataLoss) << damaged;
    }
  }
}

}  // namespace
}  // namespace latticeworld
