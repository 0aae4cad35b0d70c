#include "latticeworld/terrain/forms/relief_saddles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace latticeworld::internal {
namespace {

ReliefPiece Round(WorldPoint at, double half_width_m) {
  ReliefPiece piece;
  piece.axis = {at};
  piece.half_width_m = half_width_m;
  piece.height_m = 20.0;
  return piece;
}

// Two cones of 20 m, 80 m apart, on a ridge that is so high in its middle, above land at 5 m.
Grid<float> TwoTops(const GridGeometry& geometry, double ridge_m) {
  Grid<float> height_m(geometry.rows(), geometry.cols());
  for (int r = 0; r < geometry.rows(); ++r) {
    for (int c = 0; c < geometry.cols(); ++c) {
      const WorldPoint at = geometry.CenterOf({r, c});
      const double west = 20.0 - 0.5 * std::hypot(at.x_m + 40.0, at.y_m);
      const double east = 20.0 - 0.5 * std::hypot(at.x_m - 40.0, at.y_m);
      const double ridge = std::abs(at.x_m) < 40.0
                               ? ridge_m + 0.05 * std::abs(at.x_m) - 0.5 * std::abs(at.y_m)
                               : 0.0;
      height_m(r, c) = static_cast<float>(5.0 + std::max({west, east, ridge, 0.0}));
    }
  }
  return height_m;
}

TEST(ReliefSaddlesTest, ThePassIsTheHighestLevelThatJoinsTheTops) {
  const GridGeometry geometry = GridGeometry::FromCells(128, 256.0);
  const ReliefPiece west = Round({-40.0, 0.0}, 30.0), east = Round({40.0, 0.0}, 30.0);
  const SaddleRelief saddle = MeasureSaddle(west, east, geometry, TwoTops(geometry, 10.0));
  EXPECT_NEAR(saddle.top_m, 25.0, 1.0);
  EXPECT_NEAR(saddle.pass_m, 15.0, 1.0);
  EXPECT_NEAR(saddle.side_m, 5.0, 0.5);
  EXPECT_LT(std::hypot(saddle.pass.x_m, saddle.pass.y_m), 4.0);
}

TEST(ReliefSaddlesTest, TopsThatOnlyThePlainJoinsHaveNoPassAboveTheirSides) {
  const GridGeometry geometry = GridGeometry::FromCells(128, 256.0);
  const ReliefPiece west = Round({-40.0, 0.0}, 30.0), east = Round({40.0, 0.0}, 30.0);
  const SaddleRelief saddle = MeasureSaddle(west, east, geometry, TwoTops(geometry, 0.0));
  EXPECT_NEAR(saddle.pass_m - saddle.side_m, 0.0, 0.5);
}

}  // namespace
}  // namespace latticeworld::internal
