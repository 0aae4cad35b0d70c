#include "latticeworld/scene/atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>

namespace latticeworld {
namespace {

double ElevationDeg(const Atmosphere& atmosphere) {
  return std::asin(atmosphere.sun_direction.z()) * 180.0 / M_PI;
}

Atmosphere At(Season season, TimeOfDay time, Weather weather = Weather::kSunny) {
  CoarseAttributes coarse;
  coarse.season = season;
  coarse.time_of_day = time;
  coarse.weather = weather;
  return DeriveAtmosphere(coarse, 0.0, 0.0);
}

TEST(AtmosphereTest, NoonSunStandsInTheSouthAtTheHeightOfItsSeason) {
  EXPECT_NEAR(ElevationDeg(At(Season::kSummer, TimeOfDay::kNoon)), 90.0 - 45.0 + 23.44, 1e-6);
  EXPECT_NEAR(ElevationDeg(At(Season::kSpring, TimeOfDay::kNoon)), 45.0, 1e-6);
  EXPECT_NEAR(ElevationDeg(At(Season::kWinter, TimeOfDay::kNoon)), 90.0 - 45.0 - 23.44, 1e-6);
  const Eigen::Vector3d noon = At(Season::kWinter, TimeOfDay::kNoon).sun_direction;
  EXPECT_NEAR(noon.x(), 0.0, 1e-9);
  EXPECT_LT(noon.y(), 0.0);
}

TEST(AtmosphereTest, TheSunRisesInTheEastAndSetsInTheWest) {
  for (const auto& season : EnumNames(Season{})) {
    const Atmosphere dawn = At(season.value, TimeOfDay::kDawn);
    const Atmosphere dusk = At(season.value, TimeOfDay::kDusk);
    EXPECT_GT(dawn.sun_direction.x(), 0.5);
    EXPECT_LT(dusk.sun_direction.x(), -0.5);
    EXPECT_NEAR(ElevationDeg(dawn), 3.0, 1e-6);
    EXPECT_NEAR(ElevationDeg(dusk), 3.0, 1e-6);
    EXPECT_GT(At(season.value, TimeOfDay::kMorning).sun_direction.x(), 0.0);
    EXPECT_LT(At(season.value, TimeOfDay::kAfternoon).sun_direction.x(), 0.0);
  }
}

TEST(AtmosphereTest, LightFollowsTheSunAndTheWeather) {
  for (const auto& season : EnumNames(Season{})) {
    const Atmosphere night = At(season.value, TimeOfDay::kNight);
    EXPECT_LT(night.sun_direction.z(), 0.0);
    EXPECT_EQ(night.sun_intensity, 0.0);
    EXPECT_GT(night.ambient_intensity, 0.0);
    const double noon = At(season.value, TimeOfDay::kNoon).sun_intensity;
    EXPECT_GT(noon, At(season.value, TimeOfDay::kDusk).sun_intensity);
    EXPECT_GT(noon, At(season.value, TimeOfDay::kNoon, Weather::kFog).sun_intensity);
  }
}

TEST(AtmosphereTest, EveryCombinationIsInRange) {
  for (const auto& weather : EnumNames(Weather{})) {
    for (const auto& season : EnumNames(Season{})) {
      for (const auto& time : EnumNames(TimeOfDay{})) {
        const Atmosphere a = At(season.value, time.value, weather.value);
        EXPECT_EQ(a.weather, weather.value);
        EXPECT_NEAR(a.sun_direction.norm(), 1.0, 1e-12);
        EXPECT_TRUE(a.sun_intensity >= 0.0 && a.sun_intensity <= 1.0);
        EXPECT_TRUE(a.ambient_intensity >= 0.0 && a.ambient_intensity <= 1.0);
        EXPECT_GT(a.visibility_m, 0.0);
        EXPECT_GE(a.snow_depth_m, 0.0);
        EXPECT_EQ(a.rain_mmph > 0.0, weather.value == Weather::kRain);
      }
    }
  }
}

TEST(AtmosphereTest, FogAndSandstormsHideWhatIsAKilometreAway) {
  EXPECT_LT(At(Season::kSummer, TimeOfDay::kDay, Weather::kFog).visibility_m, 1000.0);
  EXPECT_LT(At(Season::kSummer, TimeOfDay::kDay, Weather::kSandstorm).visibility_m, 1000.0);
  EXPECT_GE(At(Season::kSummer, TimeOfDay::kDay, Weather::kSunny).visibility_m, 10000.0);
}

TEST(AtmosphereTest, SnowLiesInWinterAndWhereItFalls) {
  EXPECT_EQ(At(Season::kSummer, TimeOfDay::kDay).snow_depth_m, 0.0);
  EXPECT_GT(At(Season::kWinter, TimeOfDay::kDay).snow_depth_m, 0.0);
  EXPECT_GT(At(Season::kWinter, TimeOfDay::kDay, Weather::kSnow).snow_depth_m,
            At(Season::kAutumn, TimeOfDay::kDay, Weather::kSnow).snow_depth_m);
}

TEST(AtmosphereTest, DesertWindBlowsInDesertsAlongItsHeading) {
  CoarseAttributes coarse;
  coarse.terrain_type = TerrainType::kDesert;
  const Eigen::Vector3d wind_mps = DeriveAtmosphere(coarse, 30.0, M_PI / 2.0).wind_mps;
  EXPECT_NEAR(wind_mps.y(), 30.0, 1e-9);
  EXPECT_NEAR(wind_mps.x(), 0.0, 1e-9);
  coarse.terrain_type = TerrainType::kForest;
  EXPECT_LT(DeriveAtmosphere(coarse, 30.0, 0.0).wind_mps.norm(), 10.0);
}

}  // namespace
}  // namespace latticeworld
