#ifndef LATTICEWORLD_SIMULATION_ODE_SEARCH_CLOCK_H_
#define LATTICEWORLD_SIMULATION_ODE_SEARCH_CLOCK_H_

#include <chrono>

namespace latticeworld {

// How long a step looked for contacts, timed from the first time on that this is asked: virtual
// machines take up to a microsecond to tell the time, and who does not ask does not pay.
class SearchClock {
 public:
  using Clock = std::chrono::steady_clock;

  Clock::time_point Now() const { return is_asked_ ? Clock::now() : Clock::time_point(); }

  void Set(std::chrono::nanoseconds time) { time_ = time; }
  // All threads taken together, of the last step.
  std::chrono::nanoseconds Ask() const {
    is_asked_ = true;
    return time_;
  }

 private:
  mutable bool is_asked_ = false;
  std::chrono::nanoseconds time_{};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_SEARCH_CLOCK_H_
