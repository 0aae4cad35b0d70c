#include "latticeworld/scene/weather/sun.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;

TEST(SunTest, DeclinationIsRightAtSolsticesAndEquinoxes) {
  EXPECT_NEAR(SunDeclination(172.0) / kDegree, 23.44, 0.05);
  EXPECT_NEAR(SunDeclination(355.0) / kDegree, -23.44, 0.05);
  EXPECT_NEAR(SunDeclination(80.0) / kDegree, 0.0, 0.5);
  EXPECT_NEAR(SunDeclination(266.0) / kDegree, 0.0, 0.5);
}

TEST(SunTest, SeasonsOfTheSouthLieHalfAYearLater) {
  for (const auto& season : EnumNames(Season{})) {
    const double north = DayOfYear(season.value, 45.0), south = DayOfYear(season.value, -45.0);
    EXPECT_GE(south, 1.0);
    EXPECT_LT(south, 366.0);
    EXPECT_NEAR(std::abs(north - south), 182.5, 1e-9);
    // The noon sun is as high, and stands in the north there.
    const Eigen::Vector3d here = SunDirection(north, 12.0, 45.0);
    const Eigen::Vector3d there = SunDirection(south, 12.0, -45.0);
    EXPECT_NEAR(here.z(), there.z(), 0.02);
    EXPECT_LT(here.y(), 0.0);
    EXPECT_GT(there.y(), 0.0);
  }
}

TEST(SunTest, DawnAndDuskAreAroundNoonEverywhereOnEarth) {
  for (double latitude_deg = -90.0; latitude_deg <= 90.0; latitude_deg += 5.0) {
    for (const auto& season : EnumNames(Season{})) {
      const double day = DayOfYear(season.value, latitude_deg);
      for (const auto& time : EnumNames(TimeOfDay{})) {
        const double hour = HourOf(time.value, day, latitude_deg);
        EXPECT_GE(hour, 0.0) << latitude_deg << " " << time.name;
        EXPECT_LT(hour, 24.0) << latitude_deg << " " << time.name;
      }
      EXPECT_LE(HourOf(TimeOfDay::kDawn, day, latitude_deg), 12.0);
      EXPECT_GE(HourOf(TimeOfDay::kDusk, day, latitude_deg), 12.0);
    }
  }
}

TEST(SunTest, TheSunNeverSetsInSummerBeyondThePolarCircle) {
  for (double hour = 0.0; hour < 24.0; hour += 0.5) {
    EXPECT_GT(SunDirection(172.0, hour, 75.0).z(), 0.0);
    EXPECT_LT(SunDirection(355.0, hour, 75.0).z(), 0.0);
  }
}

TEST(SunTest, LightIsContinuousAllDay) {
  Atmosphere before;
  before.hour = 0.0;
  SetSun(&before);
  for (int minute = 1; minute <= 24 * 60; ++minute) {
    Atmosphere now = before;
    now.hour = minute / 60.0;
    SetSun(&now);
    EXPECT_NEAR(now.sun_direction.norm(), 1.0, 1e-12);
    EXPECT_NEAR(now.sun_intensity, before.sun_intensity, 0.02);
    EXPECT_NEAR(now.ambient_intensity, before.ambient_intensity, 0.03);
    before = now;
  }
}

}  // namespace
}  // namespace latticeworld
