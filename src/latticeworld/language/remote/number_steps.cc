#include "latticeworld/language/remote/number_steps.h"

#include <cmath>

namespace latticeworld {
namespace {

struct Step {
  int units;
  int per;
};
constexpr Step kSteps[] = {{1, 10}, {1, 4}, {1, 2}, {1, 1}, {2, 1}, {5, 1}, {10, 1}, {15, 1}};
constexpr int kMostValues = 24;

}  // namespace

NumberSteps::NumberSteps(const Range& range) {
  for (const Step& step : kSteps) {
    units_ = step.units;
    per_ = step.per;
    Count(range);
    if (count_ <= kMostValues) return;
  }
}

double NumberSteps::At(int i) const { return static_cast<double>(first_ + i) * units_ / per_; }

void NumberSteps::Count(const Range& range) {
  first_ = static_cast<int>(std::ceil(range.low * per_ / units_));
  count_ = 0;
  while (range.Contains(At(count_))) ++count_;
}

}  // namespace latticeworld
