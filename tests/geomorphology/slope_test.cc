#include "latticeworld/geomorphology/slope.h"

#include <gtest/gtest.h>

#include <cmath>

namespace latticeworld {
namespace {

// Rises toward the east by 0.3 and toward the north by 0.4 a metre.
Grid<float> Plane(double resolution_m) {
  Grid<float> plane(20, 24);
  for (int r = 0; r < 20; ++r) {
    for (int c = 0; c < 24; ++c) {
      plane(r, c) = static_cast<float>(resolution_m * (0.3 * c - 0.4 * r));
    }
  }
  return plane;
}

TEST(SlopeTest, GradientOfAPlaneIsItsSteepnessUpToTheEdges) {
  for (const float value : GradientMagnitude(Plane(2.0), 2.0)) EXPECT_NEAR(value, 0.5f, 1e-4);
}

TEST(SlopeTest, HillshadeIsBrightTowardTheLightAndDarkAway) {
  const double altitude = M_PI / 4;
  const double northeast = M_PI / 4;
  const Grid<float> flat = Hillshade(Grid<float>(8, 8, 3.0f), 1.0, northeast, altitude);
  EXPECT_NEAR(flat(4, 4), std::sin(altitude), 1e-5);
  // The plane rises toward the north-east: it faces south-west.
  EXPECT_LT(Hillshade(Plane(1.0), 1.0, northeast, altitude)(10, 10), flat(4, 4));
  EXPECT_GT(Hillshade(Plane(1.0), 1.0, northeast + M_PI, altitude)(10, 10), flat(4, 4));
}

TEST(SlopeTest, IsTheSameWithAnyNumberOfThreads) {
  Grid<float> height_m(37, 23);
  for (int r = 0; r < 37; ++r) {
    for (int c = 0; c < 23; ++c) height_m(r, c) = static_cast<float>((r * 31 + c * c * 7) % 17);
  }
  for (const int threads : {2, 3, 7}) {
    EXPECT_EQ(GradientMagnitude(height_m, 0.3, threads), GradientMagnitude(height_m, 0.3, 1));
    EXPECT_EQ(Hillshade(height_m, 0.3, 1.0, 0.7, threads), Hillshade(height_m, 0.3, 1.0, 0.7, 1));
  }
}

}  // namespace
}  // namespace latticeworld
