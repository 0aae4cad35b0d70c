#include <gtest/gtest.h>

#include <memory>

#include "latticeworld/sensing/motion/gnss.h"
#include "latticeworld_ros/conversion/sensor_conversion.h"
#include "latticeworld_ros/running/sensor_thread.h"

namespace latticeworld {
namespace {

// Of a receiver without noise that stands 3 m above the world's origin.
sensor_msgs::NavSatFix FixAt(const GeoOrigin& origin) {
  GnssReceiver receiver({}, origin, 5.0, 1);
  return ToNavSatFix(receiver.Read({0.0, 0.0, 3.0}, false, 0), "robot/fix", ros::Time(1, 0));
}

TEST(SensorOriginTest, TheGeoidUndulationIsAddedToTheAltitudeOfAFixOnRealLand) {
  World world;
  world.geo = GeoOrigin{48.0, 11.0, 500.0};
  SensorThreadOptions options;
  EXPECT_NEAR(FixAt(OriginForSensors(world, options)).altitude, 503.0, 1e-6);
  options.geoid_undulation_m = 46.25;
  const sensor_msgs::NavSatFix fix = FixAt(OriginForSensors(world, options));
  EXPECT_NEAR(fix.altitude, 549.25, 1e-6);
  EXPECT_NEAR(fix.latitude, 48.0, 1e-9);
  EXPECT_NEAR(fix.longitude, 11.0, 1e-9);
}

TEST(SensorOriginTest, TheGeoidUndulationIsAddedWhereAWorldLiesNowhereToo) {
  auto scene = std::make_shared<Scene>();
  scene->atmosphere.latitude_deg = 51.0;
  World world;
  world.scene = scene;
  SensorThreadOptions options;
  options.longitude_deg = 7.0;
  options.altitude_m = 120.0;
  options.geoid_undulation_m = -30.0;
  const sensor_msgs::NavSatFix fix = FixAt(OriginForSensors(world, options));
  EXPECT_NEAR(fix.altitude, 93.0, 1e-6);
  EXPECT_NEAR(fix.latitude, 51.0, 1e-9);
  EXPECT_NEAR(fix.longitude, 7.0, 1e-9);
}

}  // namespace
}  // namespace latticeworld
