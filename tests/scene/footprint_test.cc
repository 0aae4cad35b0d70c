#include "latticeworld/scene/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

TEST(FootprintTest, TheFrontLooksAlongYaw) {
  const Footprint house = {{10.0, 20.0}, M_PI / 2.0, 4.0, 6.0};
  EXPECT_NEAR(house.At(4.0, 0.0).y_m, 24.0, 1e-12);
  EXPECT_NEAR(house.At(0.0, 6.0).x_m, 4.0, 1e-12) << "left of north is west";
  EXPECT_NEAR(house.radius_m(), std::hypot(4.0, 6.0), 1e-12);
}

TEST(FootprintTest, GapsAreThoseBetweenTheWalls) {
  const Footprint a = {{0.0, 0.0}, 0.0, 5.0, 3.0};
  EXPECT_NEAR(GapBetween(a, {{13.0, 0.0}, 0.0, 5.0, 3.0}), 3.0, 1e-12);
  EXPECT_NEAR(GapBetween(a, {{0.0, 6.0}, 0.0, 5.0, 3.0}), 0.0, 1e-12) << "wall to wall";
  EXPECT_NEAR(GapBetween(a, {{13.0, 10.0}, 0.0, 5.0, 3.0}), 5.0, 1e-12) << "corner to corner";
  EXPECT_NEAR(GapBetween(a, {{9.0, 0.0}, 0.0, 5.0, 3.0}), -1.0, 1e-12) << "a metre too near";
  // A corner of the turned one points at the wall.
  EXPECT_NEAR(GapBetween(a, {{5.0 + 2.0 * M_SQRT2 + 1.5, 0.0}, M_PI / 4.0, 2.0, 2.0}), 1.5, 1e-9);
  // Across each other no corner lies in the other.
  EXPECT_LT(GapBetween({{0.0, 0.0}, 0.0, 10.0, 1.0}, {{0.0, 0.0}, M_PI / 2.0, 10.0, 1.0}), 0.0);
}

TEST(FootprintTest, GapsAgreeWithPointsOfTheWalls) {
  RandomStream random(3, "footprint_test");
  for (int round = 0; round < 300; ++round) {
    const auto draw = [&random]() {
      return Footprint{{random.Uniform(-12.0, 12.0), random.Uniform(-12.0, 12.0)},
                       random.Uniform(-M_PI, M_PI),
                       random.Uniform(1.0, 8.0),
                       random.Uniform(1.0, 8.0)};
    };
    const Footprint a = draw(), b = draw();
    double nearest_m = INFINITY;
    bool inside = false;
    for (double u = -1.0; u <= 1.001; u += 0.02) {
      for (double v = -1.0; v <= 1.001; v += 0.02) {
        const double gap_m = GapTo(a, b.At(u * b.half_length_m, v * b.half_width_m));
        nearest_m = std::min(nearest_m, gap_m);
        inside = inside || gap_m < -0.2;
      }
    }
    const double gap_m = GapBetween(a, b);
    EXPECT_EQ(gap_m, GapBetween(b, a));
    if (inside) EXPECT_LT(gap_m, 0.0);
    if (gap_m > 0.0) EXPECT_NEAR(gap_m, nearest_m, 0.05);
  }
}

}  // namespace
}  // namespace latticeworld
