#include "latticeworld/terrain/surface.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(SurfaceTest, EveryFrictionIsPlausibleInEveryWeather) {
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    for (const auto& weather : EnumNames(Weather{})) {
      const SurfaceProperties properties = PropertiesOf(surface.value, weather.value);
      EXPECT_GE(properties.friction, 0.1) << surface.name << " in " << weather.name;
      EXPECT_LE(properties.friction, 0.9) << surface.name << " in " << weather.name;
      EXPECT_GT(properties.rolling_resistance, 0.0);
      EXPECT_LT(properties.rolling_resistance, 0.25);
    }
  }
}

TEST(SurfaceTest, RainAndSnowLowerFrictionWhereTheGroundIsDry) {
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    if (surface.value == SurfaceClass::kSnow || surface.value == SurfaceClass::kWaterBed) continue;
    const double dry = PropertiesOf(surface.value, Weather::kSunny).friction;
    const double wet = PropertiesOf(surface.value, Weather::kRain).friction;
    const double snowy = PropertiesOf(surface.value, Weather::kSnow).friction;
    EXPECT_LT(wet, dry) << surface.name;
    EXPECT_LT(snowy, wet) << surface.name;
  }
}

TEST(SurfaceTest, RoadsRollEasiestAndGripBest) {
  const SurfaceProperties road = PropertiesOf(SurfaceClass::kRoad, Weather::kSunny);
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    const SurfaceProperties other = PropertiesOf(surface.value, Weather::kSunny);
    EXPECT_LE(other.friction, road.friction) << surface.name;
    EXPECT_GE(other.rolling_resistance, road.rolling_resistance) << surface.name;
  }
}

TEST(SurfaceTest, SoilSoftensInRainAndPavingDoesNot) {
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    const double dry = PropertiesOf(surface.value, Weather::kSunny).cone_index_kpa;
    const double wet = PropertiesOf(surface.value, Weather::kRain).cone_index_kpa;
    EXPECT_GE(dry, 50.0) << surface.name;  // carries a light robot
    EXPECT_LE(dry, kHardConeIndex_kPa) << surface.name;
    const bool stays = dry == kHardConeIndex_kPa || surface.value == SurfaceClass::kSnow ||
                       surface.value == SurfaceClass::kWaterBed;
    EXPECT_EQ(wet == dry, stays) << surface.name;
    EXPECT_LE(wet, dry) << surface.name;
  }
}

}  // namespace
}  // namespace latticeworld
