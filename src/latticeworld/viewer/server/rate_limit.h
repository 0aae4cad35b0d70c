#ifndef LATTICEWORLD_VIEWER_SERVER_RATE_LIMIT_H_
#define LATTICEWORLD_VIEWER_SERVER_RATE_LIMIT_H_

#include <algorithm>

namespace latticeworld {

// A token bucket: so many things a second, over a burst.
class RateLimit {
 public:
  RateLimit(double rate_hz, double burst) : rate_hz_(rate_hz), burst_(burst), left_(burst) {}

  // Whether one more may pass now; now_s never falls.
  bool Take(double now_s) {
    left_ = std::min(burst_, left_ + rate_hz_ * std::max(0.0, now_s - last_s_));
    last_s_ = now_s;
    if (left_ < 1.0) return false;
    left_ -= 1.0;
    return true;
  }

 private:
  double rate_hz_;
  double burst_;
  double left_;
  double last_s_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_RATE_LIMIT_H_
