#ifndef LATTICEWORLD_TESTS_ROS_RUNNING_FAKE_LOOP_CLOCK_H_
#define LATTICEWORLD_TESTS_ROS_RUNNING_FAKE_LOOP_CLOCK_H_

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "latticeworld_ros/running/loop_clock.h"

namespace latticeworld {

// Wall time that passes at once, but no further than a test allows: there who waits holds on, until
// something is asked of it.
class FakeLoopClock : public LoopClock {
 public:
  using Duration = TimePoint::duration;

  TimePoint Now() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return now_;
  }
  void Wait(std::condition_variable* wake, std::unique_lock<std::mutex>* lock, TimePoint due,
            const std::function<bool()>& woken) override {
    wake->wait(*lock, [&] { return woken() || !Holds(due); });
    const std::lock_guard<std::mutex> own(mutex_);
    holds_ = false;
    if (!woken()) now_ = std::max(now_, due);
  }

  // Of the thread that waits: something takes that long.
  void Take(Duration duration) {
    const std::lock_guard<std::mutex> lock(mutex_);
    now_ += duration;
  }
  // Who waits holds on from the next time on, if only for no time.
  void Hold() {
    const std::lock_guard<std::mutex> lock(mutex_);
    limit_ = now_ - Duration(1);
  }
  // So much more time may pass. Who holds on sees it once something is asked of it.
  void Allow(Duration duration) {
    const std::lock_guard<std::mutex> lock(mutex_);
    limit_ += duration;
  }
  // False: nobody held on for a minute.
  bool WaitUntilHolding() {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::minutes(1), [this] { return holds_; });
  }

 private:
  bool Holds(TimePoint due) {
    const std::lock_guard<std::mutex> lock(mutex_);
    holds_ = due > limit_;
    if (holds_) changed_.notify_all();
    return holds_;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  TimePoint now_ = TimePoint() + std::chrono::hours(1), limit_ = now_;
  bool holds_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_ROS_RUNNING_FAKE_LOOP_CLOCK_H_
