#include "latticeworld/campaign/workers/dispatcher.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "generation/test_world.h"
#include "latticeworld/campaign/workers/slurm_job.h"
#include "latticeworld/common/files.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class DispatcherTest : public ::testing::Test {
 protected:
  DispatcherTest() {
    folder_.out = directory_.path() / "out";
    fs::create_directories(folder_.out / "trials");
    folder_.campaign.worlds.resize(2);
    folder_.campaign.worlds[0].name = "a";
    folder_.campaign.worlds[1].name = "b";
    folder_.campaign.robots.resize(1);
    folder_.campaign.conditions.resize(1);
    folder_.campaign.conditions[0].seeds = {1};
    folder_.campaign.tasks.count = 3;
    folder_.plan = PlanOf(folder_.campaign);
    for (std::size_t i = 0; i < folder_.plan.size(); ++i) all_.push_back(i);
  }

  // A worker that is a shell script: what it does with each $trial.
  Status Run(const std::string& body, double trial_time_s = 60.0, int workers = 2) {
    DispatchOptions options;
    options.workers = workers;
    options.trial_time_s = trial_time_s;
    options.command = {"/bin/bash", "-c", "while read -r trial; do\n" + body + "\ndone", "worker"};
    options.wall_times = folder_.out / "wall_times.csv";
    return Dispatch(folder_, all_, options, Progress(), [this](std::size_t done) { done_ = done; });
  }
  std::string ErrorOfTrial(std::size_t index) const {
    const auto result = ReadTrialResult(folder_.out, folder_.plan[index].id);
    return result.ok() ? result->error : "";
  }
  std::string Log() const { return ReadFile(directory_.path() / "log", 1 << 20).value(); }
  std::string LogPath() const { return (directory_.path() / "log").string(); }

  TemporaryDirectory directory_;
  CampaignFolder folder_;
  std::vector<std::size_t> all_;
  std::size_t done_ = 0;
};

TEST_F(DispatcherTest, EveryTrialIsGivenOnceAndWorldsStayTogether) {
  const Status run = Run("echo $$ $trial >> " + LogPath() + "; echo done $trial", 60.0, 1);
  ASSERT_TRUE(run.ok()) << run.ToString();
  EXPECT_EQ(done_, 6u);
  std::string order;
  const std::string log = Log();
  for (std::size_t i = 0; i + 1 < log.size(); ++i) {
    if (log[i] == ' ') order += log[i + 1];
  }
  EXPECT_EQ(order, "012345");
}

TEST_F(DispatcherTest, ACrashIsTriedOnceMoreAndTheOthersGoOn) {
  const Status run =
      Run("echo $trial >> " + LogPath() + "; [ $trial = 2 ] && kill -SEGV $$; echo done $trial");
  ASSERT_TRUE(run.ok()) << run.ToString();
  EXPECT_EQ(done_, 6u);
  EXPECT_EQ(ErrorOfTrial(2), "its process was ended by signal 11, twice");
  int tries = 0;
  for (const char letter : Log()) tries += letter == '2';
  EXPECT_EQ(tries, 2);
}

TEST_F(DispatcherTest, ACrashThatDoesNotComeAgainLeavesNoTrace) {
  const Status run = Run("[ $trial = 2 ] && mkdir " + LogPath() +
                         " 2>/dev/null && kill -KILL $$; echo done $trial");
  ASSERT_TRUE(run.ok()) << run.ToString();
  EXPECT_EQ(done_, 6u);
  EXPECT_EQ(ErrorOfTrial(2), "");
}

TEST_F(DispatcherTest, AHungTrialIsEnded) {
  const Status run = Run("[ $trial = 4 ] && exec sleep 1000; echo done $trial", 1.0);
  ASSERT_TRUE(run.ok()) << run.ToString();
  EXPECT_EQ(ErrorOfTrial(4), "it took longer than 1 s, twice");
  EXPECT_EQ(done_, 6u);
}

TEST_F(DispatcherTest, AFullDiskEndsItAll) {
  const Status run = Run("echo failed $trial 'RESOURCE_EXHAUSTED: no space left'");
  EXPECT_EQ(run.code(), StatusCode::kResourceExhausted);
  EXPECT_NE(run.message().find("no space left"), std::string::npos);
}

TEST_F(DispatcherTest, WorkersThatCannotStartAreNoErrorsOfTrials) {
  DispatchOptions options;
  options.command = {"/no/such/program"};
  const Status run =
      Dispatch(folder_, all_, options, Progress(), [this](std::size_t done) { done_ = done; });
  EXPECT_EQ(run.code(), StatusCode::kInternal);
  EXPECT_EQ(done_, 0u);
}

TEST_F(DispatcherTest, WhoeverCancelsIsHeard) {
  Progress progress;
  progress.Cancel();
  DispatchOptions options;
  options.command = {"/bin/cat"};
  EXPECT_EQ(Dispatch(folder_, all_, options, progress, [](std::size_t) {}).code(),
            StatusCode::kCancelled);
}

TEST_F(DispatcherTest, ShardsShareTheTrialsOut) {
  std::vector<int> seen(folder_.plan.size(), 0);
  for (const int shards : {1, 2, 4}) {
    for (int shard = 0; shard < shards; ++shard) {
      const auto missing = MissingTrials(folder_, shard, shards);
      ASSERT_TRUE(missing.ok());
      for (const std::size_t index : *missing) ++seen[index];
    }
  }
  for (const int times : seen) EXPECT_EQ(times, 3);
}

TEST_F(DispatcherTest, AnotherFileIsRefusedInAFolderWithResults) {
  folder_.text = "a: 1\n";
  fs::remove_all(folder_.out);
  ASSERT_TRUE(PrepareFolder(folder_, false).ok());
  EXPECT_EQ(PrepareFolder(folder_, false).code(), StatusCode::kAlreadyExists);
  EXPECT_TRUE(PrepareFolder(folder_, true).ok());
  folder_.text = "a: 2\n";
  EXPECT_EQ(PrepareFolder(folder_, true).code(), StatusCode::kFailedPrecondition);
}

TEST(SlurmJobTest, PathsOfAnyLettersStayOneWord) {
  const std::string job =
      SlurmJobFile({"my campaign", "/bin/lw", "/a b/it's $HOME.yaml", "/out", 3, 2});
  EXPECT_NE(job.find("'/a b/it'\\''s $HOME.yaml'"), std::string::npos) << job;
  EXPECT_NE(job.find("--array=0-2\n"), std::string::npos);
  EXPECT_NE(job.find("--job-name=my-campaign\n"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
