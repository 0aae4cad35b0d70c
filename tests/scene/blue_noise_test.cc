#include "latticeworld/scene/blue_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace latticeworld {
namespace {

TEST(BlueNoiseTest, PointsKeepTheirSpacingAndStayInside) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "blue_noise_test");
    const double size_m = random.Uniform(16.0, 120.0), per_m2 = random.Uniform(0.005, 0.2);
    const auto points = BlueNoise(size_m, per_m2, &random);
    const double spacing_m = BlueNoiseSpacing(per_m2);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_LE(std::abs(points[i].x_m), 0.5 * size_m + 1e-4);
      ASSERT_LE(std::abs(points[i].y_m), 0.5 * size_m + 1e-4);
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_GE(std::hypot(points[i].x_m - points[j].x_m, points[i].y_m - points[j].y_m),
                  spacing_m - 1e-3);
      }
    }
  }
}

TEST(BlueNoiseTest, ThereAreAsManyAsAskedFor) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const double per_m2 : {0.006, 0.04, 0.11}) {
      RandomStream random(seed, "blue_noise_test");
      const double wanted = 400.0 * 400.0 * per_m2;
      EXPECT_NEAR(BlueNoise(400.0, per_m2, &random).size(), wanted, 0.05 * wanted);
    }
  }
}

TEST(BlueNoiseTest, NoLargeHoleIsLeft) {
  RandomStream random(5, "blue_noise_test");
  const double spacing_m = BlueNoiseSpacing(0.04);
  const auto points = BlueNoise(100.0, 0.04, &random);
  for (int i = 0; i < 2000; ++i) {
    const double x_m = random.Uniform(-50.0, 50.0), y_m = random.Uniform(-50.0, 50.0);
    double nearest_m = INFINITY;
    for (const WorldPoint& point : points) {
      nearest_m = std::min(nearest_m, std::hypot(point.x_m - x_m, point.y_m - y_m));
    }
    EXPECT_LT(nearest_m, 1.6 * spacing_m);
  }
}

}  // namespace
}  // namespace latticeworld
