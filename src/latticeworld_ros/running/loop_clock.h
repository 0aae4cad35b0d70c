#ifndef LATTICEWORLD_ROS_RUNNING_LOOP_CLOCK_H_
#define LATTICEWORLD_ROS_RUNNING_LOOP_CLOCK_H_

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace latticeworld {

// Wall time of the simulation loop, given from outside so that tests need not wait for it.
class LoopClock {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  virtual ~LoopClock() = default;
  virtual TimePoint Now() = 0;
  // Blocks until woken() is true or `due` is reached. lock: held by the caller before and after,
  // and by nobody meanwhile; who changes what woken() reads holds it and notifies `wake`.
  virtual void Wait(std::condition_variable* wake, std::unique_lock<std::mutex>* lock,
                    TimePoint due, const std::function<bool()>& woken) = 0;
};

// The time that passes; it never jumps.
class SteadyLoopClock final : public LoopClock {
 public:
  TimePoint Now() override { return std::chrono::steady_clock::now(); }
  void Wait(std::condition_variable* wake, std::unique_lock<std::mutex>* lock, TimePoint due,
            const std::function<bool()>& woken) override {
    wake->wait_until(*lock, due, woken);
  }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_LOOP_CLOCK_H_
