#include "latticeworld/terrain/forms/relief_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace latticeworld::internal {
namespace {

const GridGeometry kGeometry = GridGeometry::FromCells(256, 256.0);

// A ridge of 20 m from west to east through the middle, or a trench, that falls off evenly over
// 25 m to all sides.
Grid<float> Ridge(double length_m, double sign) {
  Grid<float> height_m(256, 256);
  for (int r = 0; r < 256; ++r) {
    for (int c = 0; c < 256; ++c) {
      const WorldPoint at = kGeometry.CenterOf({r, c});
      const double beyond_m = std::max(0.0, std::abs(at.x_m) - length_m / 2.0);
      const double off_m = std::hypot(beyond_m, at.y_m);
      height_m(r, c) = static_cast<float>(40.0 + sign * 20.0 * std::max(0.0, 1.0 - off_m / 25.0));
    }
  }
  return height_m;
}

ReliefPiece Course(ReliefKind kind, double length_m) {
  ReliefPiece piece;
  piece.kind = kind;
  piece.axis = {{-length_m / 2.0, 0.0}, {length_m / 2.0, 0.0}};
  piece.half_width_m = 25.0;
  piece.height_m = 20.0;
  return piece;
}

TEST(ReliefMeasuresTest, WidthIsWhereNineTenthsOfTheHeightArePassedOnEitherSide) {
  EXPECT_NEAR(Width_m(Course(ReliefKind::kRidge, 120.0), kGeometry, Ridge(120.0, 1.0)), 45.0, 3.0);
  EXPECT_NEAR(Width_m(Course(ReliefKind::kValley, 120.0), kGeometry, Ridge(120.0, -1.0)), 45.0,
              3.0);
}

TEST(ReliefMeasuresTest, LengthIsThatOfSectionsAtLeastHalfAsHigh) {
  // By half its half width beyond either end the ridge is half as high.
  EXPECT_NEAR(Length_m(Course(ReliefKind::kRidge, 120.0), kGeometry, Ridge(120.0, 1.0)), 145.0,
              8.0);
  EXPECT_NEAR(Length_m(Course(ReliefKind::kGorge, 120.0), kGeometry, Ridge(120.0, -1.0)), 145.0,
              8.0);
}

TEST(ReliefMeasuresTest, OfALongAxisOnlyThePartCountsWhereTheLandIsHigh) {
  EXPECT_NEAR(Length_m(Course(ReliefKind::kRidge, 180.0), kGeometry, Ridge(80.0, 1.0)), 105.0,
              10.0);
}

TEST(ReliefMeasuresTest, FlatLandHasNeitherWidthNorLength) {
  const Grid<float> flat(256, 256, 7.0f);
  ReliefPiece piece = Course(ReliefKind::kRidge, 120.0);
  EXPECT_EQ(Amplitude_m(piece, kGeometry, flat), 0.0);
  EXPECT_LT(Width_m(piece, kGeometry, flat), 3.0);
}

TEST(ReliefMeasuresTest, TheMiddleOfAHillIsItsTopAndOfABasinItsFloor) {
  ReliefPiece round;
  round.axis = {{6.0, 0.0}};
  round.half_width_m = 40.0;
  round.kind = ReliefKind::kHill;
  const WorldPoint top = MiddleOf(round, kGeometry, Ridge(0.0, 1.0));
  EXPECT_LT(std::hypot(top.x_m, top.y_m), 2.0);
  round.kind = ReliefKind::kBasin;
  const WorldPoint floor = MiddleOf(round, kGeometry, Ridge(0.0, -1.0));
  EXPECT_LT(std::hypot(floor.x_m, floor.y_m), 2.0);
}

}  // namespace
}  // namespace latticeworld::internal
