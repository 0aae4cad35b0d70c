#include "latticeworld/geomorphology/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

TEST(NoiseTest, StaysInItsRangeAndVaries) {
  const auto geometry = GridGeometry::FromCells(200, 400.0);
  for (int seed = 0; seed < 10; ++seed) {
    const Grid<float> fractal = FractalNoise(geometry, {80.0, 5, 0.5}, seed);
    const auto [low, high] = std::minmax_element(fractal.begin(), fractal.end());
    EXPECT_GE(*low, -1.0f);
    EXPECT_LE(*high, 1.0f);
    EXPECT_GT(*high - *low, 0.5f);
    for (const float value : RidgedNoise(geometry, {80.0, 5, 0.5}, seed)) {
      EXPECT_GE(value, 0.0f);
      EXPECT_LE(value, 1.0f);
    }
  }
}

TEST(NoiseTest, IsOneFieldInMetresAtEveryResolution) {
  // Every third cell centre of the finer grid is a cell centre of the coarser one.
  const auto coarse = GridGeometry::FromCells(50, 150.0);
  const auto fine = GridGeometry::FromCells(150, 150.0);
  const Grid<float> a = FractalNoise(coarse, {60.0, 3, 0.5}, 5);
  const Grid<float> b = FractalNoise(fine, {60.0, 3, 0.5}, 5);
  for (int r = 0; r < 50; ++r) {
    for (int c = 0; c < 50; ++c) EXPECT_NEAR(a(r, c), b(3 * r + 1, 3 * c + 1), 1e-4);
  }
}

TEST(NoiseTest, IsContinuous) {
  const auto geometry = GridGeometry::FromCells(400, 100.0);  // 0.25 m
  const Grid<float> noise = FractalNoise(geometry, {20.0, 1, 0.5}, 3);
  for (int r = 0; r < 399; ++r) {
    for (int c = 0; c < 399; ++c) {
      EXPECT_LT(std::abs(noise(r, c + 1) - noise(r, c)), 0.06f);
      EXPECT_LT(std::abs(noise(r + 1, c) - noise(r, c)), 0.06f);
    }
  }
}

TEST(NoiseTest, FollowsItsSeed) {
  const auto geometry = GridGeometry::FromCells(64, 64.0);
  EXPECT_EQ(FractalNoise(geometry, {}, 1), FractalNoise(geometry, {}, 1));
  EXPECT_NE(FractalNoise(geometry, {}, 1), FractalNoise(geometry, {}, 2));
}

TEST(NoiseTest, IsTheSameWithAnyNumberOfThreads) {
  const auto geometry = GridGeometry::FromCells(101, 70.0);
  const NoiseOptions options{30.0, 7, 0.5};
  const Grid<float> fractal = FractalNoise(geometry, options, 4, 1);
  const Grid<float> ridged = RidgedNoise(geometry, options, 4, 1);
  for (const int threads : {2, 3, 7}) {
    EXPECT_EQ(FractalNoise(geometry, options, 4, threads), fractal);
    EXPECT_EQ(RidgedNoise(geometry, options, 4, threads), ridged);
  }
}

}  // namespace
}  // namespace latticeworld
