#include "latticeworld/sensing/weather_effects.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {
namespace {

// -ln(0.05): optical depth over the meteorological optical range.
constexpr double kOpticalRangeDepth = 2.996;
// Extinction of the clearest air that a world has; it alone costs no echoes.
constexpr double kClearExtinction_per_m = kOpticalRangeDepth / 40000.0;
// Length of the beam near the sensor in which one drop or flake hides the rest.
constexpr double kBlindingLength_m = 10.0;
// Half the length of a pulse of 5 ns, by which mixed echoes lie wrong.
constexpr double kEchoSpread_m = 0.375;

}  // namespace

SensorConditions ConditionsIn(const Atmosphere& atmosphere) {
  SensorConditions conditions;
  conditions.extinction_per_m = kOpticalRangeDepth / atmosphere.visibility_m;
  const double laden_per_m = std::max(0.0, conditions.extinction_per_m - kClearExtinction_per_m);
  conditions.dropout_probability = -std::expm1(-laden_per_m * kBlindingLength_m);
  conditions.range_noise_m = kEchoSpread_m * conditions.dropout_probability;
  return conditions;
}

double SightRange(const Atmosphere& atmosphere) { return atmosphere.visibility_m; }

}  // namespace latticeworld
