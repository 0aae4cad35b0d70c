#ifndef LATTICEWORLD_TESTS_ENVIRONMENT_BOUNDS_TEXT_H_
#define LATTICEWORLD_TESTS_ENVIRONMENT_BOUNDS_TEXT_H_

#include <string>

#include "latticeworld/environment/rules.h"

namespace latticeworld {

// All that rules can change of bounds.
inline std::string ToText(const FineBounds& bounds) {
  std::string text;
  for (const auto* values : {&bounds.season_variants, &bounds.materials}) {
    for (const ValueBound& value : *values) {
      text += (value.legal() ? std::to_string(value.weight) : "-") + " ";
    }
  }
  for (const auto& number : bounds.numbers) {
    if (!number) continue;
    for (const double value : {number->range.low, number->range.high, number->typical,
                               number->draw_low, number->draw_high}) {
      text += std::to_string(value) + " ";
    }
    text += number->draw_evenly ? "evenly " : "";
  }
  return text;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_ENVIRONMENT_BOUNDS_TEXT_H_
