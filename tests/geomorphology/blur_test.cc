#include "latticeworld/geomorphology/blur.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace latticeworld {
namespace {

TEST(GaussianBlurTest, SpreadsAPointWithTheAskedVarianceAndKeepsItsSum) {
  for (const double sigma : {1.0, 2.5, 6.0}) {
    Grid<float> grid(101, 99);
    grid(50, 49) = 1.0f;
    GaussianBlur(sigma, &grid);
    double sum = 0.0, row_moment = 0.0, col_moment = 0.0;
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); ++c) {
        sum += grid(r, c);
        row_moment += grid(r, c) * (r - 50) * (r - 50);
        col_moment += grid(r, c) * (c - 49) * (c - 49);
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-4);
    EXPECT_NEAR(std::sqrt(row_moment), sigma, 0.25) << sigma;
    EXPECT_NEAR(std::sqrt(col_moment), sigma, 0.25) << sigma;
  }
}

TEST(GaussianBlurTest, LeavesAConstantAloneUpToTheEdges) {
  Grid<float> grid(13, 37, 4.25f);
  GaussianBlur(9.0, &grid);  // boxes wider than the grid
  for (const float value : grid) EXPECT_NEAR(value, 4.25f, 1e-5);
}

TEST(GaussianBlurTest, LeavesAPlaneAloneAwayFromTheEdges) {
  Grid<float> grid(64, 70);
  for (int r = 0; r < 64; ++r) {
    for (int c = 0; c < 70; ++c) grid(r, c) = static_cast<float>(2 * r - 3 * c);
  }
  const Grid<float> plane = grid;
  GaussianBlur(3.0, &grid);
  for (int r = 16; r < 48; ++r) {
    for (int c = 16; c < 54; ++c) EXPECT_NEAR(grid(r, c), plane(r, c), 1e-3);
  }
}

TEST(GaussianBlurTest, IsTheSameWithAnyNumberOfThreads) {
  // More than two blocks of columns and a last group of rows that is not full.
  Grid<float> given(43, 150);
  for (int r = 0; r < 43; ++r) {
    for (int c = 0; c < 150; ++c) given(r, c) = static_cast<float>((r * 31 + c * c * 7) % 17);
  }
  for (const double sigma : {1.0, 6.3}) {
    Grid<float> one = given;
    GaussianBlur(sigma, &one, 1);
    for (const int threads : {2, 3, 7}) {
      Grid<float> more = given;
      GaussianBlur(sigma, &more, threads);
      EXPECT_EQ(more, one);
    }
  }
}

}  // namespace
}  // namespace latticeworld
