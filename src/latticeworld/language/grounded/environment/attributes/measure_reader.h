#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_MEASURE_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_MEASURE_READER_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

enum class MeasureKind {
  kHour,         // of the day, [0, 24)
  kVagueHour,    // the same, of a clock with twelve hours and nothing to tell which half
  kTemperature,  // [degrees Celsius]
  kDegrees,      // an angle, or a temperature without its unit
  kSpeed,        // [m/s]
  kLength,       // [m]
  kShare,        // 0.3 for "30 %"
  kDecimal,      // a number with a fraction
  kFactor        // "twice", "1.5 times"
};

// A number with what it is measured in.
struct HeardMeasure {
  MeasureKind kind = MeasureKind::kHour;
  double value = 0.0;
  std::size_t first = 0;  // tokens [first, last)
  std::size_t last = 0;
};

// Every measure of an instruction, in order; their tokens are noted.
std::vector<HeardMeasure> ReadMeasures(NotedTokens* noted);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_MEASURE_READER_H_
