// What the ground holds: however strong a robot is, slopes are closed that slip away below it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/mapping/traversability.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

Scene Slope(double slope_rad, SurfaceClass surface) {
  const double gradient = std::tan(slope_rad);
  return WithSurfaces(MakeScene(16, 8.0, [gradient](double x_m, double) { return gradient * x_m; }),
                      [surface](double, double) { return surface; });
}

bool IsOpen(const Scene& scene, const RobotLimits& limits, const SceneChanges& changes = {}) {
  const Grid<float> ease = BuildTraversability(scene, limits, changes);
  return std::all_of(ease.begin(), ease.end(), [](float value) { return value > 0.0f; });
}

RobotLimits Strong(double grip, bool on_wheels) {
  RobotLimits limits;
  limits.max_slope_rad = 1.4;
  limits.grip = grip;
  limits.on_wheels = on_wheels;
  return limits;
}

// Balance along the slope: grip mu cos(s) = sin(s), and c cos(s) more of it for wheels.
TEST(GroundHoldTest, ASlopeIsOpenUpToWhereFeetSlipAndWheelsLoseToRolling) {
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    const SurfaceProperties ground = DryPropertiesOf(entry.value);
    for (const double grip : {0.6, 1.0, 1.3}) {
      const double feet_rad = std::atan(grip * ground.friction);
      const double wheels_rad = std::atan(grip * ground.friction - ground.rolling_resistance);
      SCOPED_TRACE(testing::Message() << entry.name << ", grip " << grip);
      EXPECT_TRUE(IsOpen(Slope(0.99 * feet_rad, entry.value), Strong(grip, false)));
      EXPECT_FALSE(IsOpen(Slope(1.01 * feet_rad, entry.value), Strong(grip, false)));
      EXPECT_TRUE(IsOpen(Slope(0.99 * wheels_rad, entry.value), Strong(grip, true)));
      EXPECT_FALSE(IsOpen(Slope(1.01 * wheels_rad, entry.value), Strong(grip, true)));
    }
  }
}

TEST(GroundHoldTest, WheelsDoNotStartWhereRollingTakesMoreThanTheyPushWith) {
  const Scene level = Slope(0.0, SurfaceClass::kWaterBed);  // friction 0.4, rolling 0.15
  EXPECT_TRUE(IsOpen(level, Strong(0.5, true)));
  EXPECT_FALSE(IsOpen(level, Strong(0.3, true)));
  EXPECT_TRUE(IsOpen(level, Strong(0.3, false)));
}

TEST(GroundHoldTest, SnowOfTheWeatherClosesGentleSlopesForWheels) {
  const Scene summer = Slope(0.1, SurfaceClass::kGrass);
  SceneChanges changes;
  changes.ground = GroundState{0.0, 0.3, 0.0};
  const RobotLimits rover, dog = Strong(1.0, false);
  EXPECT_TRUE(IsOpen(summer, rover));
  EXPECT_FALSE(IsOpen(summer, rover, changes));
  EXPECT_TRUE(IsOpen(summer, dog, changes));
  // A world that begins so is as one that came to it, and opens when the snow is gone.
  Scene winter = summer;
  winter.atmosphere.snow_depth_m = 0.3;
  EXPECT_FALSE(IsOpen(winter, rover));
  EXPECT_EQ(BuildOccupancy(winter, dog), BuildOccupancy(summer, dog, changes));
  changes.ground = GroundState();
  EXPECT_TRUE(IsOpen(winter, rover, changes));
}

TEST(GroundHoldTest, ASlopeCostsItsShareOfTheSteepestThatItsGroundHolds) {
  const RobotLimits limits = Strong(1.0, false);
  for (const SurfaceClass surface : {SurfaceClass::kRoad, SurfaceClass::kSnow}) {
    const double steepest_rad = std::atan(DryPropertiesOf(surface).friction);
    const auto ease = BuildTraversability(Slope(0.5 * steepest_rad, surface), limits);
    for (const float value : ease) EXPECT_NEAR(value, 0.5f, 1e-3f);
  }
}

}  // namespace
}  // namespace latticeworld
