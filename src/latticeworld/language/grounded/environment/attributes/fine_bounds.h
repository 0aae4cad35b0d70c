#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_BOUNDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_BOUNDS_H_

#include <cstddef>
#include <optional>

#include "latticeworld/language/grounded/environment/attributes/measure_reader.h"
#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// What the words around a measure make of it: "below 10 m/s", "between 5 and 8 m/s", "20 degrees or
// more", "should not exceed 25 degrees". Neither bound: the measure is meant as it stands.
struct MeasureBounds {
  std::optional<double> least;
  std::optional<double> most;
  std::size_t first = 0;  // the token where the measure begins, or the low end of its range
  std::size_t said = 0;   // where the words begin that say so
  bool IsSet() const { return least.has_value() || most.has_value(); }
};

MeasureBounds BoundsOf(const EnvironmentWords& words, const NotedTokens& noted,
                       const HeardMeasure& measure);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_FINE_BOUNDS_H_
