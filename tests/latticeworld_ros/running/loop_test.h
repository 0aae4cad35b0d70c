#ifndef LATTICEWORLD_TESTS_ROS_RUNNING_LOOP_TEST_H_
#define LATTICEWORLD_TESTS_ROS_RUNNING_LOOP_TEST_H_

#include <gtest/gtest.h>
#include <ros/time.h>

#include <chrono>
#include <memory>

#include "latticeworld_ros/running/fake_loop_clock.h"
#include "latticeworld_ros/running/fake_simulator.h"
#include "latticeworld_ros/running/loop_recorder.h"
#include "latticeworld_ros/running/simulation_loop.h"

namespace latticeworld {

// A paused loop on a clock that stands still but for what a test allows.
class LoopTest : public testing::Test {
 protected:
  explicit LoopTest(bool with_world = true)
      : clock_(new FakeLoopClock),
        loop_({0.01, 1.0, /*start_paused=*/true}, &recorder_, std::unique_ptr<LoopClock>(clock_)) {
    ros::Time::init();  // the log's throttle reads it
    loop_.Start();
    if (!with_world) return;
    LaunchedWorld world = FakeWorld("one", 3, &fake_);
    EXPECT_TRUE(loop_.Swap(&world).ok());
  }
  ~LoopTest() override { loop_.Stop(); }

  // Lets so much wall time pass.
  void Pass(std::chrono::milliseconds wall) {
    clock_->Allow(wall);
    (void)loop_.Inspect(false);
    ASSERT_TRUE(clock_->WaitUntilHolding());
  }

  FakeLoopClock* const clock_;  // the loop's
  LoopRecorder recorder_;
  SimulationLoop loop_;
  FakeSimulator* fake_ = nullptr;  // the first world's
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_ROS_RUNNING_LOOP_TEST_H_
