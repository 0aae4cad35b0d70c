#include "latticeworld/relief/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

template <typename Height>
Grid<float> Make(int rows, int cols, Height height) {
  Grid<float> grid(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      grid(r, c) = static_cast<float>(height((r + 0.5) / rows, (c + 0.5) / cols));
    }
  }
  return grid;
}

TEST(ReliefTest, CaptionNamesHighAndLowGroundAndTheRelief) {
  const Relief slope =
      MakeRelief(Make(80, 120, [](double v, double u) { return 84.0 * (u + 1.0 - v) / 2.0; }));
  EXPECT_NE(slope.caption.find("high ground in the upper right"), std::string::npos)
      << slope.caption;
  EXPECT_NE(slope.caption.find("low ground in the lower left"), std::string::npos) << slope.caption;
  EXPECT_NE(slope.caption.find("relief 83 m"), std::string::npos) << slope.caption;

  const Relief hill = MakeRelief(Make(65, 65, [](double v, double u) {
    return 30.0 * std::exp(-20.0 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
  }));
  EXPECT_NE(hill.caption.find("high ground in the center falling"), std::string::npos)
      << hill.caption;

  const Relief flat = MakeRelief(Grid<float>(40, 40, 12.0f));
  EXPECT_EQ(flat.caption, "nearly flat land; relief 0 m, heights from 12 m to 12 m");
}

TEST(ReliefTest, SummaryIsTheMeanOfBlocksFromZeroToOne) {
  const Relief relief =
      MakeRelief(Make(64, 96, [](double v, double) { return v < 0.5 ? 20.0 : 5.0; }));
  ASSERT_EQ(relief.summary.rows(), kReliefSummarySize);
  ASSERT_EQ(relief.summary.cols(), kReliefSummarySize);
  EXPECT_FLOAT_EQ(relief.summary(0, 0), 1.0f);
  EXPECT_FLOAT_EQ(relief.summary(15, 31), 1.0f);
  EXPECT_FLOAT_EQ(relief.summary(16, 0), 0.0f);
  for (const float value : MakeRelief(Grid<float>(33, 33, 3.0f)).summary) EXPECT_EQ(value, 0.0f);
}

TEST(ProceduralReliefTest, IsGentleAndSpansItsAmplitude) {
  const auto geometry = GridGeometry::FromCells(256, 512.0);
  for (int seed = 1; seed <= 20; ++seed) {
    const Grid<float> land = ProceduralRelief(geometry, 6.0, seed);
    const auto [low, high] = std::minmax_element(land.begin(), land.end());
    EXPECT_NEAR(*low, 0.0f, 0.2f);
    EXPECT_NEAR(*high, 6.0f, 0.2f);
    for (int r = 0; r < 255; ++r) {
      for (int c = 0; c < 255; ++c) {
        const double rise = std::hypot(land(r, c + 1) - land(r, c), land(r + 1, c) - land(r, c));
        EXPECT_LT(rise / 2.0, 0.16);  // 9 degrees
      }
    }
  }
}

TEST(ProceduralReliefTest, IsTheSameLandAtEveryResolution) {
  const Grid<float> coarse = ProceduralRelief(GridGeometry::FromCells(100, 512.0), 6.0, 9);
  const Grid<float> fine = ProceduralRelief(GridGeometry::FromCells(300, 512.0), 6.0, 9);
  for (int r = 0; r < 100; ++r) {
    for (int c = 0; c < 100; ++c) EXPECT_NEAR(coarse(r, c), fine(3 * r + 1, 3 * c + 1), 0.05);
  }
  EXPECT_NE(fine, ProceduralRelief(GridGeometry::FromCells(300, 512.0), 6.0, 10));
}

}  // namespace
}  // namespace latticeworld
