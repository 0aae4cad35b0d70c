// What becomes of the loop when its simulator or its listener throws.

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "latticeworld_ros/running/loop_test.h"

namespace latticeworld {
namespace {

constexpr std::chrono::seconds kWhile(2);  // in which statistics are told

class SimulationFailureTest : public LoopTest {
 protected:
  // From now on that call of the simulator throws.
  void LetFail(const std::string& call) {
    fake_->before = [call](const std::string& begun) {
      if (begun == call) throw std::runtime_error("numbers ran away in " + call);
    };
  }
  void LetRun() { fake_->before = nullptr; }
  Status Spawn(const std::string& name = "scout") {
    SpawnRequest request;
    request.name = name;
    return loop_.Apply([&](Simulator* simulator) { return simulator->Spawn(request); }).status();
  }
  // All that ask for a simulator with a whole state.
  std::vector<Status> AskEverything() {
    return {loop_.Inspect(true).status(), loop_.Step(1, false).status(),
            loop_.SetWeather({}).status(), loop_.SaveSnapshot("b").status(), Spawn()};
  }
  // It stands still, says why, and nobody touches it.
  void ExpectStandsStill(const std::string& words) {
    const std::uint64_t step = fake_->episode_step();
    for (const Status& status : AskEverything()) {
      EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition) << status.ToString();
      EXPECT_NE(status.message().find(words), std::string::npos) << status.ToString();
    }
    loop_.Command("robot", VelocityCommand());
    ASSERT_TRUE(loop_.SetPaused(false).ok());
    Pass(kWhile);
    const LoopStatistics told = recorder_.statistics().back();
    EXPECT_NE(told.failure.find(words), std::string::npos) << told.failure;
    EXPECT_EQ(told.simulator, nullptr);
    ASSERT_TRUE(loop_.SetPaused(true).ok());
    EXPECT_EQ(fake_->episode_step(), step);
    EXPECT_FALSE(fake_->touched_while_torn);
  }
};

TEST_F(SimulationFailureTest, AStepThatThrowsIsTheLastUntilAReset) {
  ASSERT_TRUE(loop_.Step(4, false).ok());
  LetFail("Step");
  const Status failed = loop_.Step(10, false).status();
  EXPECT_EQ(failed.code(), StatusCode::kInternal);
  EXPECT_NE(failed.message().find("numbers ran away in Step"), std::string::npos);
  ExpectStandsStill("numbers ran away in Step");
  LetRun();
  EXPECT_EQ(loop_.Reset(0)->episode_step, 0u);
  EXPECT_EQ(loop_.Step(3, false)->episode_step, 3u);
  EXPECT_FALSE(fake_->touched_while_torn);
}

TEST_F(SimulationFailureTest, SoIsOneWhileTimeRuns) {
  LetFail("Step");
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  Pass(kWhile);
  EXPECT_NE(recorder_.statistics().back().failure.find("in Step"), std::string::npos);
  ASSERT_TRUE(loop_.SetPaused(true).ok());
  EXPECT_FALSE(fake_->touched_while_torn);
}

TEST_F(SimulationFailureTest, AChangeThatThrowsIsTheCallersAndLeavesNothingToTrust) {
  LetFail("Spawn");
  EXPECT_EQ(Spawn().code(), StatusCode::kInternal);
  ExpectStandsStill("numbers ran away in Spawn");
  LetRun();
  EXPECT_TRUE(loop_.Reset(0).ok());
  EXPECT_TRUE(Spawn().ok());
}

TEST_F(SimulationFailureTest, AChangeThatIsRefusedLeavesAllAsItWas) {
  EXPECT_EQ(Spawn("").code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(loop_.Step(1, false).ok());
}

TEST_F(SimulationFailureTest, WeatherThatThrowsIsTheCallersToo) {
  LetFail("SetWeather");
  EXPECT_EQ(loop_.SetWeather({}).status().code(), StatusCode::kInternal);
  ExpectStandsStill("numbers ran away in SetWeather");
}

TEST_F(SimulationFailureTest, ACommandThatThrowsEndsNothingButTheSimulator) {
  for (const std::string call : {"Command", "CommandJoints", "Strike"}) {
    LetFail(call);
    loop_.Command("robot", VelocityCommand());
    loop_.CommandJoints("robot", {});
    loop_.Strike("robot");
    ExpectStandsStill("numbers ran away in " + call);
    LetRun();
    ASSERT_TRUE(loop_.Reset(0).ok());
  }
  EXPECT_TRUE(loop_.Step(1, false).ok());
}

TEST_F(SimulationFailureTest, AResetThatThrowsIsTheCallersAndAnotherOneHeals) {
  LetFail("Reset");
  const int begins = recorder_.begins;
  EXPECT_EQ(loop_.Reset(0).status().code(), StatusCode::kInternal);
  EXPECT_EQ(recorder_.begins, begins);
  ExpectStandsStill("numbers ran away in Reset");
  LetRun();
  EXPECT_TRUE(loop_.Reset(0).ok());
  EXPECT_TRUE(loop_.Step(1, false).ok());
}

TEST_F(SimulationFailureTest, ARestoreThatThrowsIsTheCallersAndAnotherOneHeals) {
  ASSERT_TRUE(loop_.Step(7, false).ok());
  ASSERT_TRUE(loop_.SaveSnapshot("a").ok());
  LetFail("Restore");
  EXPECT_EQ(loop_.RestoreSnapshot("a").status().code(), StatusCode::kInternal);
  EXPECT_EQ(recorder_.restores, 0);
  ExpectStandsStill("numbers ran away in Restore");
  EXPECT_EQ(loop_.RestoreSnapshot("absent").status().code(), StatusCode::kNotFound);
  LetRun();
  EXPECT_EQ(loop_.RestoreSnapshot("a")->episode_step, 7u);
  EXPECT_TRUE(loop_.Step(1, false).ok());
  // Whole parts first: it was reset before it was restored.
  EXPECT_FALSE(fake_->touched_while_torn);
}

TEST_F(SimulationFailureTest, AnotherWorldRunsWhateverBecameOfTheOneBefore) {
  LetFail("Step");
  EXPECT_EQ(loop_.Step(1, false).status().code(), StatusCode::kInternal);
  LaunchedWorld world = FakeWorld("two", 4);
  ASSERT_TRUE(loop_.Swap(&world).ok());
  EXPECT_TRUE(loop_.Step(2, false).ok());
  EXPECT_FALSE(fake_->touched_while_torn);
}

TEST_F(SimulationFailureTest, AStepCallHearsOfAChangeThatFailedMeanwhile) {
  // The failure comes from the call's own third step, through a command.
  int steps = 0;
  fake_->before = [&](const std::string& call) {
    if (call == "Step" && ++steps == 3) loop_.Command("robot", VelocityCommand());
    if (call == "Command") throw std::bad_alloc();
  };
  const Status failed = loop_.Step(1000, false).status();
  EXPECT_EQ(failed.code(), StatusCode::kInternal);
  EXPECT_EQ(steps, 3);
}

TEST_F(SimulationFailureTest, AListenerThatThrowsStopsNobody) {
  recorder_.throws = true;
  EXPECT_EQ(loop_.Step(5, false)->episode_step, 5u);
  EXPECT_TRUE(Spawn().ok());
  EXPECT_TRUE(loop_.Reset(0).ok());
  EXPECT_TRUE(loop_.SaveSnapshot("a").ok());
  EXPECT_TRUE(loop_.RestoreSnapshot("a").ok());
  LaunchedWorld world = FakeWorld("two", 4);
  EXPECT_TRUE(loop_.Swap(&world).ok());
  Pass(kWhile);  // at a standstill
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  Pass(kWhile);
  EXPECT_GE(recorder_.statistics().size(), 2u);
  EXPECT_GE(loop_.Inspect(false)->episode_step, 100u);
}

}  // namespace
}  // namespace latticeworld
