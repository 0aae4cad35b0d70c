// What a call of Step does before its first and after its last step.

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "latticeworld_ros/running/loop_test.h"

namespace latticeworld {
namespace {

class LockstepCallTest : public LoopTest {
 protected:
  // Every step tells of one event.
  LockstepCallTest() {
    fake_->before = [this](const std::string& call) {
      if (call != "Step") return;
      Event event;
      event.step = fake_->episode_step() + 1;
      fake_->events.push_back(event);
    };
  }
  ~LockstepCallTest() override { loop_.Stop(); }

  SimulationLoop::StepCall Call(std::uint32_t steps) {
    SimulationLoop::StepCall call;
    call.steps = steps;
    call.begin = [this](Simulator*) {
      begun_at_.push_back(fake_->episode_step());
      shown_at_begin_ = recorder_.times().size();
      return Status();
    };
    call.end = [this] {
      ended_at_.push_back(fake_->episode_step());
      shown_at_end_ = recorder_.times().size();
    };
    return call;
  }

  std::vector<std::uint64_t> begun_at_, ended_at_;
  // Moments that listeners were told; a standing loop goes on telling them between two calls.
  std::size_t shown_at_begin_ = 0, shown_at_end_ = 0;
};

TEST_F(LockstepCallTest, BeginsBeforeTheFirstStepAndEndsOnceTheLastOneIsShown) {
  const auto moment = loop_.Step(Call(3));
  ASSERT_TRUE(moment.ok());
  EXPECT_EQ(begun_at_, std::vector<std::uint64_t>{0});
  EXPECT_EQ(ended_at_, std::vector<std::uint64_t>{3});
  EXPECT_EQ(shown_at_end_, shown_at_begin_ + 3);
}

TEST_F(LockstepCallTest, AnswersTheStateOfItsLastStep) {
  const auto moment = loop_.Step(Call(4));
  ASSERT_TRUE(moment.ok());
  ASSERT_NE(moment->state, nullptr);
  EXPECT_EQ(moment->state->episode_step, 4u);
  EXPECT_EQ(moment->episode_step, 4u);
}

TEST_F(LockstepCallTest, TellsTheEventsOfItsOwnStepsWithTheirStamps) {
  ASSERT_TRUE(loop_.Step(Call(2)).ok());
  const auto moment = loop_.Step(Call(3));
  ASSERT_TRUE(moment.ok());
  ASSERT_EQ(moment->events.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(moment->events[i].event.step, 3u + i);
    EXPECT_EQ(moment->now - moment->events[i].stamp,
              ros::Duration().fromNSec(10000000 * (2 - static_cast<int>(i))));
  }
  EXPECT_TRUE(loop_.Inspect(false)->events.empty());
}

TEST_F(LockstepCallTest, AnErrorAtTheBeginningRefusesIt) {
  SimulationLoop::StepCall call = Call(3);
  call.begin = [](Simulator*) { return NotFound("nobody"); };
  EXPECT_EQ(loop_.Step(call).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(fake_->episode_step(), 0u);
  EXPECT_TRUE(ended_at_.empty());
  EXPECT_TRUE(loop_.Step(Call(1)).ok());
}

TEST_F(LockstepCallTest, AnExceptionAtTheBeginningFailsTheSimulator) {
  SimulationLoop::StepCall call = Call(3);
  call.begin = [](Simulator*) -> Status { throw std::runtime_error("broken"); };
  EXPECT_EQ(loop_.Step(call).status().code(), StatusCode::kInternal);
  EXPECT_EQ(loop_.Step(Call(1)).status().code(), StatusCode::kFailedPrecondition);
}

TEST_F(LockstepCallTest, AnExceptionAtTheEndIsTheCallersAlone) {
  SimulationLoop::StepCall call = Call(1);
  call.end = [] { throw std::runtime_error("broken"); };
  EXPECT_EQ(loop_.Step(call).status().code(), StatusCode::kInternal);
  EXPECT_TRUE(loop_.Step(Call(1)).ok());
}

TEST_F(LockstepCallTest, BeginsNotWhileTimeRuns) {
  ASSERT_TRUE(loop_.SetPaused(false).ok());
  EXPECT_EQ(loop_.Step(Call(1)).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_TRUE(begun_at_.empty());
}

}  // namespace
}  // namespace latticeworld
