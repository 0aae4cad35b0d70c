#include "latticeworld/geomorphology/resample.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

Grid<float> Plane(int rows, int cols) {
  Grid<float> plane(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      plane(r, c) = static_cast<float>(10.0 * (r + 0.5) / rows - 7.0 * (c + 0.5) / cols);
    }
  }
  return plane;
}

TEST(ResampleTest, KeepsAPlaneFinerAndCoarserAndAcrossShapes) {
  const Grid<float> source = Plane(40, 61);
  for (const auto& [rows, cols] : {std::pair(40, 61), {160, 160}, {17, 19}, {33, 200}}) {
    const Grid<float> result = Resample(source, rows, cols);
    const Grid<float> expected = Plane(rows, cols);
    for (int r = rows / 8 + 1; r < rows - rows / 8 - 1; ++r) {
      for (int c = cols / 8 + 1; c < cols - cols / 8 - 1; ++c) {
        EXPECT_NEAR(result(r, c), expected(r, c), 0.05) << rows << " x " << cols;
      }
    }
  }
}

TEST(ResampleTest, GoesThroughTheSamplesWhenFiner) {
  Grid<float> source(5, 5, 1.0f);
  source(2, 2) = 3.0f;
  const Grid<float> result = Resample(source, 15, 15);  // every third centre is a source centre
  EXPECT_NEAR(result(7, 7), 3.0f, 1e-5);
  EXPECT_NEAR(result(4, 7), 1.0f, 1e-5);
  EXPECT_NEAR(result(0, 0), 1.0f, 1e-5);
}

TEST(ResampleTest, AveragesACheckerboardWhenCoarser) {
  Grid<float> source(128, 128);
  for (int r = 0; r < 128; ++r) {
    for (int c = 0; c < 128; ++c) source(r, c) = static_cast<float>((r + c) % 2);
  }
  for (const float value : Resample(source, 16, 16)) EXPECT_NEAR(value, 0.5f, 0.02f);
}

TEST(ResampleTest, IsTheSameWithAnyNumberOfThreads) {
  Grid<float> values(19, 31);
  for (int r = 0; r < 19; ++r) {
    for (int c = 0; c < 31; ++c) values(r, c) = static_cast<float>((r * 31 + c * c * 7) % 17);
  }
  for (const int threads : {2, 3, 7}) {
    EXPECT_EQ(Resample(values, 43, 57, threads), Resample(values, 43, 57, 1));
    EXPECT_EQ(Resample(values, 11, 9, threads), Resample(values, 11, 9, 1));
  }
}

}  // namespace
}  // namespace latticeworld
