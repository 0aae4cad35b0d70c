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

// Principal branch of Lambert's W for x >= 0 by Halley's iteration (Corless et al. 1996).
double LambertW(double x) {
  double w = x < 1.0 ? x / (1.0 + x) : std::log1p(x) * (1.0 - std::log1p(std::log1p(x)) / 4.0);
  for (int i = 0; i < 8; ++i) {
    const double e = std::exp(w);
    const double error = w * e - x;
    w -= error / (e * (w + 1.0) - (w + 2.0) * error / (2.0 * w + 2.0));
  }
  return w;
}

}  // namespace

SensorConditions ConditionsIn(const Atmosphere& atmosphere) {
  SensorConditions conditions;
  conditions.extinction_per_m = kOpticalRangeDepth / atmosphere.visibility_m;
  const double laden_per_m = std::max(0.0, conditions.extinction_per_m - kClearExtinction_per_m);
  conditions.dropout_probability = -std::expm1(-laden_per_m * kBlindingLength_m);
  conditions.range_noise_m = kEchoSpread_m * conditions.dropout_probability;
  return conditions;
}

double LidarRange(const SensorConditions& conditions, double nominal_m) {
  const double depth = conditions.extinction_per_m * nominal_m;
  // The limit for clear air, where W(x) / x loses its digits.
  if (depth < 1e-9) return nominal_m;
  return nominal_m * std::min(1.0, LambertW(depth) / depth);
}

double SightRange(const Atmosphere& atmosphere) { return atmosphere.visibility_m; }

}  // namespace latticeworld
