#include "latticeworld/terrain/ways/embankment.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace latticeworld::internal {
namespace {

constexpr int kCells = 101;
constexpr int kRoadCol = 50;
constexpr float kRise_m = 0.5f;

// The heights of a row across a road at height 0 in land of land_m.
Grid<float> AcrossRoad(float land_m) {
  Grid<unsigned char> mask(kCells, kCells);
  for (int r = 0; r < kCells; ++r) mask(r, kRoadCol) = 1;
  Grid<float> land(kCells, kCells, land_m), share(kCells, kCells);
  LayInto(mask, Grid<float>(kCells, kCells), kRise_m, &land, &share);
  return land;
}

TEST(EmbankmentTest, HighCutsGetSteeperAndLowOnesStayGentle) {
  for (const float sign : {1.0f, -1.0f}) {
    const Grid<float> land = AcrossRoad(sign * 20.0f);
    float steepest_m = 0.0f;
    for (int c = kRoadCol + 1; c < kCells; ++c) {
      const float rise_m = sign * (land(50, c) - land(50, c - 1));
      const bool low = sign * land(50, c) <= 3.0f;
      EXPECT_GE(rise_m, -1e-4f);
      EXPECT_LE(rise_m, (low ? 1.0f : 2.0f) * kRise_m + 1e-4f) << c;
      steepest_m = std::max(steepest_m, rise_m);
    }
    EXPECT_NEAR(steepest_m, 2.0f * kRise_m, 1e-4f);
    // 3 m at half a metre a cell and 17 m at one, not 20 m at half a metre.
    EXPECT_NE(land(50, kRoadCol + 20), sign * 20.0f);
    EXPECT_EQ(land(50, kRoadCol + 27), sign * 20.0f) << "the hill is left where it was";
  }
}

}  // namespace
}  // namespace latticeworld::internal
