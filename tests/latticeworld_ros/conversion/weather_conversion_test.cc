#include "latticeworld_ros/conversion/weather_conversion.h"

#include <gtest/gtest.h>

#include <limits>

namespace latticeworld {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(WeatherConversionTest, AnEmptyRequestAsksForNothing) {
  const auto change = ToWeatherChange(latticeworld_msgs::SetWeather::Request());
  ASSERT_TRUE(change.ok()) << change.status().ToString();
  EXPECT_TRUE(IsEmpty(*change));
  EXPECT_EQ(change->transition_s, 0.0);
}

TEST(WeatherConversionTest, NanAsksForNothingAsWell) {
  latticeworld_msgs::SetWeather::Request request;
  request.intensity = request.wind_speed = request.wind_heading = request.gust = {kNan};
  request.visibility = request.ground_wetness = request.snow_depth = {kNan};
  request.water_rise = request.hour = {kNan};
  request.transition = kNan;
  const auto change = ToWeatherChange(request);
  ASSERT_TRUE(change.ok()) << change.status().ToString();
  EXPECT_TRUE(IsEmpty(*change));
  EXPECT_EQ(change->transition_s, 0.0);
}

TEST(WeatherConversionTest, EveryFieldReachesItsValue) {
  latticeworld_msgs::SetWeather::Request request;
  request.weather = "sandstorm";
  request.intensity = {0.125};
  request.wind_speed = {11.0};
  request.wind_heading = {-2.0};
  request.gust = {3.0};
  request.visibility = {400.0};
  request.ground_wetness = {0.25};
  request.snow_depth = {0.0};
  request.water_rise = {-0.5};
  request.hour = {0.0};
  request.transition = 12.0;
  const auto change = ToWeatherChange(request);
  ASSERT_TRUE(change.ok()) << change.status().ToString();
  EXPECT_EQ(change->weather, Weather::kSandstorm);
  EXPECT_EQ(change->intensity, 0.125);
  EXPECT_EQ(change->wind_speed_mps, 11.0);
  EXPECT_EQ(change->wind_heading_rad, -2.0);
  EXPECT_EQ(change->gust_mps, 3.0);
  EXPECT_EQ(change->visibility_m, 400.0);
  EXPECT_EQ(change->ground_wetness, 0.25);
  EXPECT_EQ(change->snow_depth_m, 0.0);
  EXPECT_EQ(change->water_rise_m, -0.5);
  EXPECT_EQ(change->hour, 0.0);
  EXPECT_EQ(change->transition_s, 12.0);
}

TEST(WeatherConversionTest, WhatIsIllegalIsCarriedForTheSimulatorToJudge) {
  latticeworld_msgs::SetWeather::Request request;
  request.intensity = {2.0};
  request.hour = {24.0};
  request.transition = -1.0;
  const auto change = ToWeatherChange(request);
  ASSERT_TRUE(change.ok()) << change.status().ToString();
  EXPECT_EQ(change->intensity, 2.0);
  EXPECT_EQ(change->hour, 24.0);
  EXPECT_EQ(change->transition_s, -1.0);
}

TEST(WeatherConversionTest, WhatCannotBeReadIsRefusedWithAllElseThatIsIllegal) {
  latticeworld_msgs::SetWeather::Request request;
  request.weather = "hail";
  request.intensity = {0.1, 0.2};
  request.hour = {24.0};
  request.transition = std::numeric_limits<double>::infinity();
  const auto change = ToWeatherChange(request);
  ASSERT_FALSE(change.ok());
  EXPECT_EQ(change.status().violations().size(), 4u);
  for (const char* word : {"hail", "sandstorm", "intensity", "2 numbers", "hour", "transition"}) {
    EXPECT_NE(change.status().message().find(word), std::string::npos) << word;
  }
}

TEST(WeatherConversionTest, TheMessageSaysWhatTheAtmosphereIs) {
  Atmosphere atmosphere;
  atmosphere.weather = Weather::kSnow;
  atmosphere.wind_mps = {1.0, 2.0, 0.0};
  atmosphere.snow_depth_m = 0.3;
  atmosphere.water_rise_m = -0.1;
  const latticeworld_msgs::Weather message =
      ToWeatherMessage(atmosphere, 1.5, ros::Time(4.0), "world-1");
  EXPECT_EQ(message.header.stamp, ros::Time(4.0));
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.world_id, "world-1");
  EXPECT_EQ(message.weather, "snow");
  EXPECT_EQ(message.wind.y, 2.0);
  EXPECT_EQ(message.snow_depth, 0.3);
  EXPECT_EQ(message.water_rise, -0.1);
  EXPECT_EQ(message.remaining, 1.5);
}

}  // namespace
}  // namespace latticeworld
