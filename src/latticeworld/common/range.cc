#include "latticeworld/common/range.h"

#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {

void CheckRange(std::string pointer, double value, const Range& range, std::string_view unit,
                std::vector<Violation>* violations) {
  if (range.Contains(value)) return;
  std::string message = range.low_open ? "must be above " : "must be from ";
  message += FormatDouble(range.low);
  message += range.low_open ? " and " : " to ";
  if (range.low_open) message += range.high_open ? "below " : "at most ";
  if (!range.low_open && range.high_open) message += "below ";
  message += FormatDouble(range.high) + std::string(unit) + ", not " + FormatDouble(value);
  violations->push_back(
      {"out_of_range", std::move(pointer), std::move(message), FormatDouble(value)});
}

}  // namespace latticeworld
