// What comes between the steps of one call of Step.

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <thread>

#include "latticeworld_ros/running/loop_test.h"

namespace latticeworld {
namespace {

// A call of a hundred steps that holds on after the fifth until something is asked of the loop.
class StepCallTest : public LoopTest {
 protected:
  StepCallTest() {
    EXPECT_TRUE(loop_.SaveSnapshot("start").ok());
    std::promise<void> fifth;
    fake_->before = [&](const std::string& call) {
      if (call != "Step" || fake_->episode_step() != 4) return;
      clock_->Hold();
      fifth.set_value();
    };
    call_ = std::async(std::launch::async, [this] { return loop_.Step(100, false).status(); });
    EXPECT_EQ(fifth.get_future().wait_for(std::chrono::minutes(1)), std::future_status::ready);
    EXPECT_TRUE(clock_->WaitUntilHolding());
    fake_->before = nullptr;
  }
  ~StepCallTest() override { loop_.Stop(); }  // lets the call go

  StatusCode HowItEnds() { return call_.get().code(); }

  std::future<Status> call_;
};

TEST_F(StepCallTest, AnotherWorldEndsIt) {
  LaunchedWorld world = FakeWorld("two", 4);
  ASSERT_TRUE(loop_.Swap(&world).ok());
  EXPECT_EQ(HowItEnds(), StatusCode::kAborted);
  EXPECT_EQ(fake_->episode_step(), 5u);
  EXPECT_EQ(loop_.Inspect(false)->episode_step, 0u);
}

TEST_F(StepCallTest, APauseEndsItAndShowsWhereItEnded) {
  const std::size_t shown = recorder_.times().size();
  ASSERT_TRUE(loop_.SetPaused(true).ok());
  EXPECT_EQ(HowItEnds(), StatusCode::kAborted);
  EXPECT_EQ(loop_.Inspect(false)->episode_step, 5u);
  EXPECT_TRUE(loop_.Inspect(false)->paused);
  EXPECT_GT(recorder_.times().size(), shown);
}

TEST_F(StepCallTest, AnEndOfThePauseEndsIt) {
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  EXPECT_EQ(HowItEnds(), StatusCode::kAborted);
  EXPECT_FALSE(loop_.Inspect(false)->paused);
}

TEST_F(StepCallTest, AResetEndsIt) {
  EXPECT_EQ(loop_.Reset(0)->episode_step, 0u);
  EXPECT_EQ(HowItEnds(), StatusCode::kAborted);
  EXPECT_EQ(loop_.Inspect(false)->episode_step, 0u);
}

TEST_F(StepCallTest, ASnapshotThatIsRestoredEndsIt) {
  EXPECT_EQ(loop_.RestoreSnapshot("start")->episode_step, 0u);
  EXPECT_EQ(HowItEnds(), StatusCode::kAborted);
  EXPECT_EQ(loop_.Inspect(false)->episode_step, 0u);
}

TEST_F(StepCallTest, ASnapshotThatThereIsNotLeavesItBe) {
  EXPECT_EQ(loop_.RestoreSnapshot("absent").status().code(), StatusCode::kNotFound);
  clock_->Allow(std::chrono::seconds(1));
  EXPECT_EQ(loop_.Step(1, false).status().code(), StatusCode::kResourceExhausted);
  EXPECT_EQ(HowItEnds(), StatusCode::kOk);
  EXPECT_EQ(loop_.Inspect(false)->episode_step, 100u);
}

TEST_F(StepCallTest, TheEndOfTheLoopEndsIt) {
  loop_.Stop();
  EXPECT_EQ(HowItEnds(), StatusCode::kUnavailable);
}

}  // namespace
}  // namespace latticeworld
