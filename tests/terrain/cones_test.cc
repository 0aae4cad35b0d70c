#include "latticeworld/terrain/cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/common/random.h"

namespace latticeworld::internal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Grid<float> SomePoints(int rows, int cols, std::uint64_t seed) {
  RandomStream random(seed, "cones_test");
  Grid<float> values(rows, cols, kInfinity);
  for (int i = 0; i < 6; ++i) {
    values(random.UniformInt(0, rows - 1), random.UniformInt(0, cols - 1)) =
        static_cast<float>(random.Uniform(-3.0, 3.0));
  }
  return values;
}

TEST(ConesTest, AreEuclidsWithinThreePercent) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Grid<float> points = SomePoints(23, 31, seed);
    Grid<float> cones = points;
    LowerCones(0.5f, &cones);
    for (int r = 0; r < 23; ++r) {
      for (int c = 0; c < 31; ++c) {
        double exact = 1e9, longest = 1e9;
        for (int i = 0; i < 23; ++i) {
          for (int k = 0; k < 31; ++k) {
            const double distance = std::hypot(r - i, c - k);
            exact = std::min(exact, points(i, k) + 0.5 * distance);
            longest = std::min(longest, points(i, k) + 0.5 * 1.03 * distance);
          }
        }
        ASSERT_GE(cones(r, c), exact - 1e-4);
        ASSERT_LE(cones(r, c), longest + 1e-4);
      }
    }
  }
}

TEST(ConesTest, UpperConesAreLowerConesUpsideDown) {
  Grid<float> lower = SomePoints(20, 20, 4), upper = lower;
  for (float& value : upper) value = -value;
  LowerCones(0.3f, &lower);
  UpperCones(0.3f, &upper);
  for (std::size_t i = 0; i < lower.size(); ++i) ASSERT_EQ(lower.data()[i], -upper.data()[i]);
}

TEST(ConesTest, NearestIsNearest) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, "cones_test/nearest");
    Grid<unsigned char> mask(25, 25, 0);
    for (int i = 0; i < 7; ++i) mask(random.UniformInt(0, 24), random.UniformInt(0, 24)) = 1;
    const Grid<std::int32_t> nearest = NearestOf(mask);
    for (int r = 0; r < 25; ++r) {
      for (int c = 0; c < 25; ++c) {
        double exact = 1e9;
        for (int i = 0; i < 25; ++i) {
          for (int k = 0; k < 25; ++k) {
            if (mask(i, k) != 0) exact = std::min(exact, std::hypot(r - i, c - k));
          }
        }
        ASSERT_GE(nearest(r, c), 0);
        const double found = std::hypot(r - nearest(r, c) / 25, c - nearest(r, c) % 25);
        ASSERT_EQ(mask.data()[nearest(r, c)], 1);
        ASSERT_LE(found, 1.03 * exact + 1e-6);
      }
    }
  }
  EXPECT_EQ(NearestOf(Grid<unsigned char>(4, 4, 0))(2, 2), -1);
}

TEST(ConesTest, WithinAMaskWaysGoAroundWhatIsOutside) {
  // A wall with a gap at the right end.
  Grid<unsigned char> mask(3, 5, 1);
  for (int c = 0; c < 4; ++c) mask(1, c) = 0;
  Grid<float> values(3, 5, kInfinity);
  values(0, 0) = 0.0f;
  LowerConesWithin(mask, 1.0f, &values);
  EXPECT_NEAR(values(0, 3), 3.0, 1e-5);
  EXPECT_NEAR(values(2, 0), 6.0 + 2.0 * std::sqrt(2.0), 1e-4);
  EXPECT_EQ(values(1, 1), kInfinity);
}

}  // namespace
}  // namespace latticeworld::internal
