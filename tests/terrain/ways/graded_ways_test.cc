#include "latticeworld/terrain/ways/graded_ways.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace latticeworld::internal {
namespace {

constexpr int kCells = 128;  // of a metre

// A ramp that rises to the east by so much, and a way straight up it from its foot.
Grid<float> Ramp(double slope) {
  Grid<float> height_m(kCells, kCells);
  for (int r = 0; r < kCells; ++r) {
    for (int c = 0; c < kCells; ++c) height_m(r, c) = static_cast<float>(slope * c);
  }
  return height_m;
}

ClimbingWay WayUp(double slope) {
  ClimbingWay way;
  way.street.line = {{-50.0, 0.0}, {0.0, 0.0}, {50.0, 0.0}};
  way.slope = slope;
  return way;
}

double SteepestAlong(const Grid<float>& height_m) {
  double steepest = 0.0;
  for (int c = 18; c < 108; ++c) {
    steepest = std::max(steepest, std::abs(height_m(64, c + 5) - height_m(64, c)) / 5.0);
  }
  return steepest;
}

TEST(GradedWaysTest, AWayIsNoSteeperThanSaidThoughItsLandIs) {
  const GridGeometry lattice = GridGeometry::FromCells(kCells, kCells);
  for (const double slope : {0.1, 0.2, 0.3}) {
    Grid<float> land_m = Ramp(0.4);
    Grid<float> share(kCells, kCells, 0.0f);
    GradeWays(lattice, {WayUp(slope)}, Grid<unsigned char>(kCells, kCells, 0), 0.5, &land_m,
              &share);
    EXPECT_LE(SteepestAlong(land_m), slope) << slope;
    EXPECT_GE(SteepestAlong(land_m), 0.85 * slope) << slope;
    // Level across, and the land far beside it stays.
    EXPECT_NEAR(land_m(63, 64), land_m(66, 64), 0.05) << slope;
    EXPECT_EQ(land_m(2, 20), Ramp(0.4)(2, 20)) << slope;
    EXPECT_EQ(share(64, 64), 1.0f) << slope;
  }
}

TEST(GradedWaysTest, GentleLandStaysAsItIsBelowAWay) {
  const GridGeometry lattice = GridGeometry::FromCells(kCells, kCells);
  Grid<float> land_m = Ramp(0.05), share(kCells, kCells, 0.0f);
  GradeWays(lattice, {WayUp(0.2)}, Grid<unsigned char>(kCells, kCells, 0), 0.5, &land_m, &share);
  for (int c = 18; c < 108; ++c) EXPECT_NEAR(land_m(64, c), 0.05 * c, 0.1) << c;
}

TEST(GradedWaysTest, RoadsStayAsTheyAreAndAWayBeginsAsHighAsItsRoad) {
  const GridGeometry lattice = GridGeometry::FromCells(kCells, kCells);
  Grid<float> land_m = Ramp(0.4), share(kCells, kCells, 0.0f);
  Grid<unsigned char> road(kCells, kCells, 0);
  for (int r = 0; r < kCells; ++r) {
    for (int c = 10; c < 18; ++c) {
      road(r, c) = 1;
      land_m(r, c) = 3.0f;
    }
  }
  GradeWays(lattice, {WayUp(0.2)}, road, 0.5, &land_m, &share);
  for (int r = 0; r < kCells; ++r) EXPECT_EQ(land_m(r, 14), 3.0f);
  EXPECT_NEAR(land_m(64, 20), 3.0, 1.5);
}

TEST(GradedWaysTest, WaysWhoseSlopeNobodySaysAreLeftAlone) {
  const GridGeometry lattice = GridGeometry::FromCells(kCells, kCells);
  ClimbingWay way = WayUp(0.2);
  way.slope.reset();
  Grid<float> land_m = Ramp(0.4), share(kCells, kCells, 0.0f);
  GradeWays(lattice, {way}, Grid<unsigned char>(kCells, kCells, 0), 0.5, &land_m, &share);
  EXPECT_EQ(land_m, Ramp(0.4));
}

}  // namespace
}  // namespace latticeworld::internal
