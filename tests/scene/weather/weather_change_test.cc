#include "latticeworld/scene/weather/weather_change.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

Atmosphere Of(const CoarseAttributes& coarse) { return DeriveAtmosphere(coarse, 0.0, 0.5); }

TEST(WeatherChangeTest, EveryIllegalFieldIsNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  WeatherChange change;
  change.intensity = -0.1;
  change.wind_speed_mps = 61.0;
  change.wind_heading_rad = std::numeric_limits<double>::infinity();
  change.gust_mps = kNan;
  change.visibility_m = 1.0;
  change.ground_wetness = 2.0;
  change.snow_depth_m = -1.0;
  change.water_rise_m = 6.0;
  change.hour = 24.0;
  change.transition_s = kNan;
  EXPECT_EQ(Validate(change).size(), 10u);
  EXPECT_TRUE(Validate(WeatherChange()).empty());
  EXPECT_TRUE(IsEmpty(WeatherChange()));
  EXPECT_FALSE(IsEmpty(change));
}

TEST(WeatherChangeTest, WhatIsNotSaidFollowsFromTheWeatherOrStays) {
  CoarseAttributes coarse;
  const Atmosphere sunny = Of(coarse);
  WeatherChange change;
  change.weather = Weather::kRain;
  const Atmosphere rain = TargetOf(sunny, change, coarse, 0.0);
  coarse.weather = Weather::kRain;
  EXPECT_EQ(rain.ground_wetness, Of(coarse).ground_wetness);
  EXPECT_EQ(rain.rain_mmph, Of(coarse).rain_mmph);
  EXPECT_EQ(rain.hour, sunny.hour);
  EXPECT_GT(rain.wind_mps.norm(), sunny.wind_mps.norm());
  EXPECT_NEAR(std::atan2(rain.wind_mps.y(), rain.wind_mps.x()), 0.5, 1e-9);

  WeatherChange hour;
  hour.hour = 22.0;
  const Atmosphere night = TargetOf(rain, hour, coarse, 0.0);
  EXPECT_EQ(night.rain_mmph, rain.rain_mmph);
  EXPECT_EQ(night.ground_wetness, rain.ground_wetness);
  EXPECT_LT(night.sun_direction.z(), 0.0);

  WeatherChange stronger;
  stronger.intensity = 1.0;
  const Atmosphere heavy = TargetOf(rain, stronger, coarse, 0.0);
  EXPECT_EQ(heavy.weather, Weather::kRain);
  EXPECT_GT(heavy.rain_mmph, rain.rain_mmph);
}

TEST(WeatherChangeTest, WhatIsSaidIsKept) {
  CoarseAttributes coarse;
  WeatherChange change;
  change.weather = Weather::kSnow;
  change.wind_speed_mps = 12.0;
  change.wind_heading_rad = M_PI / 2.0;
  change.visibility_m = 77.0;
  change.ground_wetness = 0.4;
  change.snow_depth_m = 0.7;
  change.water_rise_m = -1.5;
  const Atmosphere target = TargetOf(Of(coarse), change, coarse, 0.0);
  EXPECT_NEAR(target.wind_mps.y(), 12.0, 1e-9);
  EXPECT_NEAR(target.gust_mps, 12.0 * kGustsOverMean, 1e-9);
  EXPECT_EQ(target.visibility_m, 77.0);
  EXPECT_EQ(target.ground_wetness, 0.4);
  EXPECT_EQ(target.snow_depth_m, 0.7);
  EXPECT_EQ(target.water_rise_m, -1.5);
  change.gust_mps = 1.0;
  EXPECT_EQ(TargetOf(Of(coarse), change, coarse, 0.0).gust_mps, 1.0);
}

TEST(WeatherChangeTest, ACalmHasTheHeadingThatItIsGiven) {
  CoarseAttributes coarse;
  WeatherChange change;
  change.wind_speed_mps = 5.0;
  Atmosphere calm = Of(coarse);
  calm.wind_mps = {-0.0, -0.0, 0.0};
  EXPECT_EQ(WindHeading(calm, 1.2), 1.2);
  EXPECT_NEAR(WindHeading(TargetOf(calm, change, coarse, 0.0, 1.2), 0.0), 1.2, 1e-12);
  // A wind that blows has its own, and what is said counts before both.
  EXPECT_NEAR(WindHeading(TargetOf(Of(coarse), change, coarse, 0.0, 1.2), 0.0), 0.5, 1e-12);
  change.wind_heading_rad = -2.0;
  EXPECT_NEAR(WindHeading(TargetOf(calm, change, coarse, 0.0, 1.2), 0.0), -2.0, 1e-12);
}

TEST(WeatherChangeTest, AlikeIsWhatDiffersByRoundingAlone) {
  CoarseAttributes coarse;
  const Atmosphere one = Of(coarse);
  Atmosphere other = one;
  other.hour += 1e-12;
  other.visibility_m *= 1.0 + 1e-12;
  other.wind_mps.x() += 1e-12;
  EXPECT_TRUE(AreAlike(one, other));
  for (double Atmosphere::*const field :
       {&Atmosphere::intensity, &Atmosphere::visibility_m, &Atmosphere::rain_mmph,
        &Atmosphere::snowfall_mmph, &Atmosphere::cloud_cover, &Atmosphere::gust_mps,
        &Atmosphere::hour, &Atmosphere::direct_light, &Atmosphere::diffuse_light,
        &Atmosphere::ground_wetness, &Atmosphere::snow_depth_m, &Atmosphere::blown_sand,
        &Atmosphere::water_rise_m}) {
    Atmosphere changed = one;
    changed.*field += 0.01;
    EXPECT_FALSE(AreAlike(one, changed));
    EXPECT_FALSE(AreAlike(changed, one));
  }
  other = one;
  other.weather = Weather::kFog;
  EXPECT_FALSE(AreAlike(one, other));
  other = one;
  other.wind_mps.y() += 0.01;
  EXPECT_FALSE(AreAlike(one, other));
}

TEST(WeatherChangeTest, EveryWayBetweenTwoWeathersIsSmoothAndStaysBetween) {
  for (const auto& first : EnumNames(Weather{})) {
    for (const auto& second : EnumNames(Weather{})) {
      CoarseAttributes one, two;
      one.weather = first.value;
      two.weather = second.value;
      const Atmosphere from = Of(one), to = Of(two);
      Atmosphere before = from;
      for (int i = 0; i <= 200; ++i) {
        const Atmosphere now = Between(from, to, i / 200.0);
        EXPECT_LE(now.visibility_m, std::max(from.visibility_m, to.visibility_m) * (1 + 1e-12));
        EXPECT_GE(now.visibility_m, std::min(from.visibility_m, to.visibility_m) * (1 - 1e-12));
        EXPECT_NEAR(1.0 / now.visibility_m, 1.0 / before.visibility_m, 1e-3);
        EXPECT_NEAR(now.snow_depth_m, before.snow_depth_m, 0.01);
        EXPECT_NEAR(now.sun_intensity, before.sun_intensity, 0.02);
        EXPECT_LT((now.wind_mps - before.wind_mps).norm(), 0.2);
        before = now;
      }
      EXPECT_EQ(before.visibility_m, to.visibility_m);
      EXPECT_EQ(before.weather, to.weather);
    }
  }
}

TEST(WeatherChangeTest, TheHourGoesOnOverMidnightAndNeverBack) {
  CoarseAttributes coarse;
  Atmosphere from = Of(coarse), to = from;
  from.hour = 22.0;
  to.hour = 4.0;
  EXPECT_NEAR(Between(from, to, 0.25).hour, 23.5, 1e-9);
  EXPECT_NEAR(Between(from, to, 0.5).hour, 1.0, 1e-9);
  to.hour = 22.0;
  EXPECT_EQ(Between(from, to, 0.5).hour, 22.0);
}

}  // namespace
}  // namespace latticeworld
