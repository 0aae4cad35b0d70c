#include "latticeworld_ros/server/progress_estimate.h"

#include <algorithm>

namespace latticeworld {
namespace {

struct StageShare {
  std::string_view name;
  double share;
};
// The shares of the wall time of a default world with the grounded back end, in order; the sum is
// 1.
constexpr StageShare kShares[] = {{"relief", 0.02},  {"layout", 0.03}, {"environment", 0.01},
                                  {"terrain", 0.34}, {"scene", 0.2},   {"maps", 0.4}};
constexpr double kTooLittleDone = 0.02;

}  // namespace

double EstimateTimeLeft(std::string_view stage, double fraction, double elapsed_s) {
  double done = 0.0;
  for (const StageShare& entry : kShares) {
    if (entry.name != stage) {
      done += entry.share;
      continue;
    }
    done += entry.share * std::clamp(fraction, 0.0, 1.0);
    if (done < kTooLittleDone) return -1.0;
    return elapsed_s * std::max(0.0, 1.0 - done) / done;
  }
  return -1.0;
}

}  // namespace latticeworld
