#ifndef LATTICEWORLD_COMMON_RANGE_H_
#define LATTICEWORLD_COMMON_RANGE_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// The legal values of a continuous parameter. NaN and infinity are never among them.
struct Range {
  double low;
  double high;
  bool low_open = false;   // low itself is excluded
  bool high_open = false;  // high itself is excluded

  bool Contains(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
};

// Adds an out_of_range violation that names the value and what is legal. unit: " m" and the like,
// or empty.
void CheckRange(std::string pointer, double value, const Range& range, std::string_view unit,
                std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_RANGE_H_
