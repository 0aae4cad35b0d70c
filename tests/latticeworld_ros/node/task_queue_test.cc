#include "latticeworld_ros/node/task_queue.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <thread>

namespace latticeworld {
namespace {

// A thread that owns something runs what is asked for until the queue stops.
class TaskQueueTest : public testing::Test {
 protected:
  TaskQueueTest()
      : queue_(&clock_, Unavailable("closed")), owner_([this] {
          while (queue_.WaitUntil(clock_.Now() + std::chrono::hours(1), [] { return false; })) {
          }
          queue_.Drop();
        }) {}
  ~TaskQueueTest() override {
    queue_.Stop();
    if (owner_.joinable()) owner_.join();
  }

  SteadyLoopClock clock_;
  TaskQueue queue_;
  std::thread owner_;
};

TEST_F(TaskQueueTest, ACallGivesBackWhatItsTaskAnswers) {
  EXPECT_EQ(*queue_.Call<int>([]() -> Result<int> { return 7; }), 7);
  EXPECT_EQ(queue_.Call<int>([]() -> Result<int> { return NotFound("none"); }).status().code(),
            StatusCode::kNotFound);
}

TEST_F(TaskQueueTest, AnExceptionIsTheCallersAndTheOwnerGoesOn) {
  const Status told =
      queue_.Call<int>([]() -> Result<int> { throw std::runtime_error("too much"); }).status();
  EXPECT_EQ(told.code(), StatusCode::kInternal);
  EXPECT_NE(told.message().find("too much"), std::string::npos);
  EXPECT_EQ(queue_.Call<int>([]() -> Result<int> { throw 3; }).status().code(),
            StatusCode::kInternal);
  using Promise = std::shared_ptr<std::promise<Result<int>>>;
  EXPECT_EQ(queue_.CallLater<int>([](Promise) { throw std::bad_alloc(); }).status().code(),
            StatusCode::kInternal);
  // An answer that was given counts.
  EXPECT_EQ(*queue_.CallLater<int>([](Promise promise) {
    promise->set_value(5);
    throw std::bad_alloc();
  }),
            5);
  EXPECT_EQ(*queue_.Call<int>([]() -> Result<int> { return 7; }), 7);
}

TEST_F(TaskQueueTest, WhoAsksAStoppedQueueHearsSo) {
  queue_.Stop();
  EXPECT_EQ(queue_.Call<int>([]() -> Result<int> { return 7; }).status().code(),
            StatusCode::kUnavailable);
  EXPECT_FALSE(queue_.Post([] {}));
}

}  // namespace
}  // namespace latticeworld
