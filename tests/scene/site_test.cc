#include "latticeworld/scene/site.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/test_world.h"

namespace latticeworld {
namespace {

TestGround Ground(std::function<double(WorldPoint)> height_at_m) {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'G'; };
  ground.height_at_m = std::move(height_at_m);
  return ground;
}

TEST(SiteTest, AltitudeGoesFromTheLowestToTheHighestGround) {
  const auto terrain = MakeTerrain(Ground([](WorldPoint point) { return 50.0 + 0.5 * point.x_m; }));
  const SiteMap sites(*terrain, 0);
  EXPECT_NEAR(sites.At({-127.5, 0.0}).altitude, 0.0, 1e-3);
  EXPECT_NEAR(sites.At({0.0, 40.0}).altitude, 0.5, 0.01);
  EXPECT_NEAR(sites.At({127.5, 0.0}).altitude, 1.0, 1e-3);
  // Three metres do not make a mountain.
  const auto plain =
      MakeTerrain(Ground([](WorldPoint point) { return point.x_m > 0.0 ? 3.0 : 0.0; }));
  EXPECT_NEAR(SiteMap(*plain, 0).At({100.0, 0.0}).altitude, 0.1, 1e-3);
}

TEST(SiteTest, SlopesThatFallToTheNorthAreShady) {
  const double tangent = std::tan(20.0 * M_PI / 180.0);
  const auto roof = MakeTerrain(
      Ground([tangent](WorldPoint point) { return 60.0 - tangent * std::abs(point.y_m); }));
  const SiteMap sites(*roof, 0);
  EXPECT_NEAR(sites.At({10.0, 60.0}).slope_deg, 20.0, 0.1);
  EXPECT_NEAR(sites.At({10.0, 60.0}).northness, std::sin(20.0 * M_PI / 180.0) / 0.6, 0.01);
  EXPECT_NEAR(sites.At({10.0, -60.0}).northness, -std::sin(20.0 * M_PI / 180.0) / 0.6, 0.01);
  const auto level = MakeTerrain(Ground([](WorldPoint) { return 7.0; }));
  EXPECT_EQ(SiteMap(*level, 0).At({10.0, 60.0}).northness, 0.0);
}

TEST(SiteTest, WaterMakesItsEdgeWetAndOnlyThat) {
  TestGround ground = Ground([](WorldPoint point) { return point.x_m < 0.0 ? -2.0 : 0.0; });
  ground.water_at_m = [](WorldPoint point) { return point.x_m < 0.0 ? -0.2 : double{NAN}; };
  const auto terrain = MakeTerrain(ground);
  const SiteMap sites(*terrain, 0);
  double before = 1.0;
  for (double x_m = 3.5; x_m < 30.0; x_m += 1.0) {
    const Site site = sites.At({x_m, 10.0});
    EXPECT_NEAR(site.to_water_m, x_m + 0.5, 0.51);
    EXPECT_LE(site.wetness, before + 1e-9);
    if (x_m > 7.0) EXPECT_LE(site.wetness, 0.75);
    before = site.wetness;
  }
  EXPECT_GT(sites.At({3.5, 10.0}).wetness, 0.8);
  EXPECT_NEAR(sites.ShoreArea_m2(6.0), 256.0 * 6.0, 256.0);
  // A dry world has no water to be far from.
  const SiteMap dry(*MakeTerrain(Ground([](WorldPoint) { return 1.0; })), 0);
  EXPECT_TRUE(std::isinf(dry.At({0.0, 0.0}).to_water_m));
  EXPECT_LE(dry.At({0.0, 0.0}).wetness, 0.75);
  EXPECT_EQ(dry.ShoreArea_m2(6.0), 0.0);
}

TEST(SiteTest, ValleysAreWetterThanRidges) {
  const auto terrain = MakeTerrain(Ground([](WorldPoint point) {
    return 20.0 + 10.0 * std::cos(point.x_m * 2.0 * M_PI / 64.0) - 0.1 * point.y_m;
  }));
  const SiteMap sites(*terrain, 0);
  for (double y_m = -40.0; y_m <= 40.0; y_m += 8.0) {
    EXPECT_GT(sites.At({32.0, y_m}).wetness, sites.At({0.0, y_m}).wetness + 0.2);
  }
}

TEST(SiteTest, TalusLiesBelowCliffsAndNotAboveThem) {
  // A plateau in the west, a cliff of 60 degrees, gentle ground below it.
  const auto terrain = MakeTerrain(Ground([](WorldPoint point) {
    const double cliff_m = std::tan(60.0 * M_PI / 180.0) * 12.0;
    if (point.x_m < 0.0) return cliff_m - 0.02 * point.x_m;
    if (point.x_m < 12.0) return cliff_m - std::tan(60.0 * M_PI / 180.0) * point.x_m;
    return -0.05 * (point.x_m - 12.0);
  }));
  const SiteMap sites(*terrain, 0);
  double below = 0.0, above = 0.0, far = 0.0;
  for (double y_m = -80.0; y_m <= 80.0; y_m += 2.0) {
    below += sites.At({18.0, y_m}).talus;
    above += sites.At({-10.0, y_m}).talus;
    far += sites.At({110.0, y_m}).talus;
  }
  EXPECT_GT(below, 20.0);
  EXPECT_LT(above, 0.05 * below);
  EXPECT_LT(far, 0.05 * below);
}

}  // namespace
}  // namespace latticeworld
