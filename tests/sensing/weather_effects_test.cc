#include "latticeworld/sensing/weather_effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {
namespace {

Atmosphere Seen(double visibility_m) {
  Atmosphere atmosphere;
  atmosphere.visibility_m = visibility_m;
  return atmosphere;
}

TEST(WeatherEffectsTest, FivePercentAreLeftOverTheOpticalRange) {
  for (const double visibility_m : {5.0, 200.0, 20000.0}) {
    const SensorConditions conditions = ConditionsIn(Seen(visibility_m));
    EXPECT_NEAR(std::exp(-conditions.extinction_per_m * visibility_m), 0.05, 1e-4);
    EXPECT_EQ(SightRange(Seen(visibility_m)), visibility_m);
  }
}

TEST(WeatherEffectsTest, ThickerAirIsWorseForEverySensor) {
  SensorConditions clear = ConditionsIn(Seen(100000.0));
  for (double visibility_m = 50000.0; visibility_m > 5.0; visibility_m *= 0.7) {
    const SensorConditions thick = ConditionsIn(Seen(visibility_m));
    EXPECT_GT(thick.extinction_per_m, clear.extinction_per_m);
    EXPECT_GE(thick.dropout_probability, clear.dropout_probability);
    EXPECT_GE(thick.range_noise_m, clear.range_noise_m);
    EXPECT_LT(thick.dropout_probability, 1.0);
    clear = thick;
  }
}

TEST(WeatherEffectsTest, ClearAirCostsNothing) {
  const SensorConditions conditions = ConditionsIn(Seen(40000.0));
  EXPECT_EQ(conditions.dropout_probability, 0.0);
  EXPECT_EQ(conditions.range_noise_m, 0.0);
}

}  // namespace
}  // namespace latticeworld
