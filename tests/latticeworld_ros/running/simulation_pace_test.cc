// How the loop spends wall time.

#include <gtest/gtest.h>

#include <utility>

#include "latticeworld_ros/running/loop_test.h"

namespace latticeworld {
namespace {

using std::chrono::milliseconds;

class SimulationPaceTest : public LoopTest {
 protected:
  using LoopTest::LoopTest;

  // Steps in a second of wall time at that factor, once the last factor's pace is over.
  std::uint64_t StepsInASecondAt(double factor) {
    EXPECT_TRUE(loop_.SetRealTimeFactor(factor).ok());
    Pass(milliseconds(2000));
    const std::uint64_t before = fake_->episode_step();
    Pass(milliseconds(1000));
    return fake_->episode_step() - before;
  }
};

TEST_F(SimulationPaceTest, TheRealTimeFactorIsThePace) {
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  EXPECT_EQ(StepsInASecondAt(1.0), 100u);
  EXPECT_EQ(StepsInASecondAt(0.5), 50u);
  EXPECT_EQ(StepsInASecondAt(0.01), 1u);
  EXPECT_EQ(StepsInASecondAt(10.0), 1000u);
  EXPECT_EQ(StepsInASecondAt(1000.0), 100000u);
}

TEST_F(SimulationPaceTest, StepsThatTakeTimeDoNotSlowItDownUnlessTheyTakeAll) {
  fake_->before = [this](const std::string& call) {
    if (call == "Step") clock_->Take(milliseconds(4));
  };
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  EXPECT_EQ(StepsInASecondAt(1.0), 100u);
  EXPECT_EQ(StepsInASecondAt(2.0), 200u);
  EXPECT_EQ(StepsInASecondAt(100.0), 250u);
  EXPECT_EQ(StepsInASecondAt(0.0), 250u);
}

TEST_F(SimulationPaceTest, TimeThatWasLostLongAgoIsNotMadeUpFor) {
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  Pass(milliseconds(1000));
  bool slow = true;
  fake_->before = [&](const std::string&) {
    if (std::exchange(slow, false)) clock_->Take(milliseconds(5000));
  };
  const std::uint64_t before = fake_->episode_step();
  Pass(milliseconds(6000));
  EXPECT_EQ(fake_->episode_step() - before, 101u);  // the slow one and a second's
  // What was lost just now is.
  fake_->before = [&](const std::string&) {
    if (!std::exchange(slow, true)) clock_->Take(milliseconds(50));
  };
  Pass(milliseconds(1000));
  EXPECT_EQ(fake_->episode_step() - before, 201u);
}

TEST_F(SimulationPaceTest, PausedTimeStandsStill) {
  Pass(milliseconds(3000));
  EXPECT_EQ(fake_->episode_step(), 0u);
  const auto times = recorder_.times();
  EXPECT_EQ(times.back(), times[times.size() - 20]);
}

TEST_F(SimulationPaceTest, TheMeasuredFactorCountsStepsAndNotWhatIsShownBetweenThem) {
  fake_->before = [this](const std::string& call) {
    if (call == "Step") clock_->Take(milliseconds(2));
  };
  ASSERT_TRUE(loop_.SetRealTimeFactor(2.0).ok());
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  for (int i = 0; i < 100; ++i) {
    Pass(milliseconds(50));
    for (int j = 0; j < 5; ++j) ASSERT_TRUE(loop_.SetWeather({}).ok());
  }
  const auto told = recorder_.statistics();
  ASSERT_GE(told.size(), 4u);
  EXPECT_NEAR(told.back().real_time_factor, 2.0, 1e-9);
  EXPECT_NEAR(told.back().mean_step_s, 0.002, 1e-12);
  EXPECT_NEAR(told.back().max_step_s, 0.002, 1e-12);
}

class PaceWithoutAWorldTest : public SimulationPaceTest {
 protected:
  PaceWithoutAWorldTest() : SimulationPaceTest(/*with_world=*/false) {}
};

TEST_F(PaceWithoutAWorldTest, RunsAtMostInRealTime) {
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  ASSERT_TRUE(loop_.SetRealTimeFactor(0.0).ok());
  Pass(milliseconds(2000));
  const std::size_t before = recorder_.times().size();
  Pass(milliseconds(1000));
  EXPECT_EQ(recorder_.times().size() - before, 100u);
}

}  // namespace
}  // namespace latticeworld
