#include "latticeworld/geomorphology/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

TEST(DistanceTest, LowerEnvelopeIsTheMinimumOverAllParabolas) {
  for (int seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "distance_test");
    const int rows = random.UniformInt(1, 23);
    const int cols = random.UniformInt(1, 23);
    const double curvature = random.Uniform(0.01, 2.0);
    Grid<float> given(rows, cols, kNoFeature);
    for (float& value : given) {
      if (random.Chance(0.2)) value = static_cast<float>(random.Uniform(-5.0, 5.0));
    }
    Grid<float> envelope = given;
    LowerEnvelope(curvature, &envelope);
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < cols; ++c) {
        double expected = kNoFeature;
        for (int y = 0; y < rows; ++y) {
          for (int x = 0; x < cols; ++x) {
            const double squared = (r - y) * (r - y) + (c - x) * (c - x);
            expected = std::min(expected, given(y, x) + curvature * squared);
          }
        }
        if (std::isinf(expected)) {
          EXPECT_EQ(envelope(r, c), kNoFeature);
        } else {
          EXPECT_NEAR(envelope(r, c), expected, 1e-3) << "seed " << seed;
        }
      }
    }
  }
}

TEST(DistanceTest, DistanceToIsEuclidean) {
  Grid<unsigned char> mask(5, 7);
  mask(1, 2) = 1;
  const Grid<float> distance = DistanceTo(true, mask);
  EXPECT_FLOAT_EQ(distance(1, 2), 0.0f);
  EXPECT_FLOAT_EQ(distance(4, 6), 5.0f);
  EXPECT_FLOAT_EQ(distance(0, 1), std::sqrt(2.0f));
  EXPECT_FLOAT_EQ(DistanceTo(false, mask)(1, 2), 1.0f);
}

TEST(DistanceTest, WithoutAFeatureNothingIsNear) {
  const Grid<float> distance = DistanceTo(true, Grid<unsigned char>(4, 4));
  for (const float value : distance) EXPECT_EQ(value, kNoFeature);
}

TEST(DistanceTest, IsTheSameWithAnyNumberOfThreads) {
  Grid<unsigned char> mask(61, 45);
  for (int i = 0; i < 61 * 45; i += 97) mask.data()[i] = 1;
  for (const int threads : {2, 3, 7}) {
    EXPECT_EQ(DistanceTo(true, mask, threads), DistanceTo(true, mask, 1));
  }
}

}  // namespace
}  // namespace latticeworld
