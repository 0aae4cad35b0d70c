#ifndef LATTICEWORLD_LANGUAGE_CHAT_CALL_CLOCK_H_
#define LATTICEWORLD_LANGUAGE_CHAT_CALL_CLOCK_H_

#include <chrono>

#include "latticeworld/common/progress.h"

namespace latticeworld {

// CallClock bounds one call in time by its total timeout and by its caller's wish to end it. Real
// time bounds waiting for others here and nothing else; no result depends on it.
class CallClock {
 public:
  // `progress` must outlive the clock.
  CallClock(double total_s, const Progress& progress)
      : begin_(Clock::now()), total_s_(total_s), progress_(progress) {}

  double elapsed_s() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  double total_s() const { return total_s_; }
  double left_s() const { return total_s_ - elapsed_s(); }
  bool cancelled() const { return progress_.cancelled(); }

  // Waits so long, and ends within 20 ms once the caller cancels.
  void Wait(double seconds) const;

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point begin_;
  double total_s_;
  const Progress& progress_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_CALL_CLOCK_H_
