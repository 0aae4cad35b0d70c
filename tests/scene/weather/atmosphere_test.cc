#include "latticeworld/scene/weather/atmosphere.h"

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

void ExpectLegal(const Atmosphere& a, Weather weather) {
  const auto is_share = [](double value) { return value >= 0.0 && value <= 1.0; };
  EXPECT_EQ(a.weather, weather);
  EXPECT_NEAR(a.sun_direction.norm(), 1.0, 1e-12);
  EXPECT_TRUE(is_share(a.intensity) && is_share(a.cloud_cover) && is_share(a.sun_intensity) &&
              is_share(a.ambient_intensity) && is_share(a.direct_light) &&
              is_share(a.diffuse_light) && is_share(a.ground_wetness) && is_share(a.blown_sand));
  EXPECT_TRUE(a.hour >= 0.0 && a.hour < 24.0) << a.hour;
  EXPECT_GE(a.visibility_m, 40.0 - 1e-9);
  EXPECT_GE(a.snow_depth_m, 0.0);
  EXPECT_GE(a.gust_mps, 0.0);
  EXPECT_TRUE(a.wind_mps.allFinite());
  EXPECT_EQ(a.rain_mmph > 0.0, weather == Weather::kRain);
  EXPECT_EQ(a.snowfall_mmph > 0.0, weather == Weather::kSnow);
  if (weather != Weather::kSunny && weather != Weather::kCloudy) {
    EXPECT_LT(a.visibility_m, 15000.0);
  }
}

TEST(AtmosphereTest, NoonSunStandsInTheSouthAtTheHeightOfItsSeason) {
  EXPECT_NEAR(ElevationDeg(At(Season::kSummer, TimeOfDay::kNoon)), 90.0 - 45.0 + 23.44, 0.1);
  EXPECT_NEAR(ElevationDeg(At(Season::kSpring, TimeOfDay::kNoon)), 45.0, 0.5);
  EXPECT_NEAR(ElevationDeg(At(Season::kWinter, TimeOfDay::kNoon)), 90.0 - 45.0 - 23.44, 0.1);
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
  CoarseAttributes coarse;
  for (const auto& terrain : EnumNames(TerrainType{})) {
    for (const auto& weather : EnumNames(Weather{})) {
      for (const auto& season : EnumNames(Season{})) {
        for (const auto& time : EnumNames(TimeOfDay{})) {
          coarse.terrain_type = terrain.value;
          coarse.weather = weather.value;
          coarse.season = season.value;
          coarse.time_of_day = time.value;
          for (const double intensity : {0.0, 0.5, 1.0}) {
            ExpectLegal(DeriveAtmosphere(coarse, 20.0, 1.0, -33.0, intensity), weather.value);
          }
        }
      }
    }
  }
}

TEST(AtmosphereTest, StrongerWeatherIsThickerWetterAndWindier) {
  for (const Weather weather :
       {Weather::kRain, Weather::kSnow, Weather::kFog, Weather::kSandstorm, Weather::kCloudy}) {
    CoarseAttributes coarse;
    coarse.weather = weather;
    Atmosphere before = DeriveAtmosphere(coarse, 0.0, 0.0, 45.0, 0.0);
    for (int i = 1; i <= 20; ++i) {
      const Atmosphere now = DeriveAtmosphere(coarse, 0.0, 0.0, 45.0, i / 20.0);
      EXPECT_LE(now.visibility_m, before.visibility_m);
      EXPECT_GE(now.rain_mmph, before.rain_mmph);
      EXPECT_GE(now.snowfall_mmph, before.snowfall_mmph);
      EXPECT_GE(now.ground_wetness, before.ground_wetness);
      EXPECT_GE(now.snow_depth_m, before.snow_depth_m);
      EXPECT_GE(now.wind_mps.norm(), before.wind_mps.norm() - 1e-12);
      EXPECT_GE(now.cloud_cover, before.cloud_cover);
      EXPECT_LE(now.sun_intensity, before.sun_intensity);
      EXPECT_LE(
          Weathered(SurfaceClass::kRoad, DryPropertiesOf(SurfaceClass::kRoad), now.ground())
              .friction,
          Weathered(SurfaceClass::kRoad, DryPropertiesOf(SurfaceClass::kRoad), before.ground())
              .friction);
      before = now;
    }
  }
}

TEST(AtmosphereTest, GradesAreThoseOfTheWeatherServices) {
  CoarseAttributes coarse;
  const auto at = [&coarse](Weather weather, double intensity) {
    coarse.weather = weather;
    return DeriveAtmosphere(coarse, 0.0, 0.0, 45.0, intensity);
  };
  EXPECT_LT(at(Weather::kRain, 0.0).rain_mmph, 2.5);  // slight
  EXPECT_NEAR(at(Weather::kRain, 0.5).rain_mmph, 5.0, 1e-9);
  EXPECT_GT(at(Weather::kRain, 1.0).rain_mmph, 10.0);  // heavy
  EXPECT_NEAR(at(Weather::kRain, 0.5).visibility_m, 4000.0, 1000.0);
  EXPECT_GT(at(Weather::kSnow, 0.0).visibility_m, 1000.0);
  EXPECT_NEAR(at(Weather::kSnow, 0.5).visibility_m, 800.0, 200.0);
  EXPECT_LT(at(Weather::kSnow, 1.0).visibility_m, 500.0);
  EXPECT_NEAR(at(Weather::kFog, 1.0).visibility_m, 40.0, 1e-9);
}

TEST(AtmosphereTest, LatitudeMovesTheSun) {
  const CoarseAttributes coarse;
  const double low = DeriveAtmosphere(coarse, 0.0, 0.0, 60.0).sun_direction.z();
  EXPECT_GT(DeriveAtmosphere(coarse, 0.0, 0.0, 20.0).sun_direction.z(), low);
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
