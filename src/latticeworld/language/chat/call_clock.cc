#include "latticeworld/language/chat/call_clock.h"

#include <algorithm>
#include <thread>

namespace latticeworld {

void CallClock::Wait(double seconds) const {
  constexpr double kSliceS = 0.02;
  const double end_s = elapsed_s() + seconds;
  for (double left_s = seconds; left_s > 0 && !cancelled(); left_s = end_s - elapsed_s()) {
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left_s, kSliceS)));
  }
}

}  // namespace latticeworld
