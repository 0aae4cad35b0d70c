#include "latticeworld/geometry/grid_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

TEST(GridGeometryTest, NorthWestCellIsRowZeroColumnZero) {
  const GridGeometry geometry = *GridGeometry::Create(512.0, 0.5);
  EXPECT_EQ(geometry.rows(), 1024);
  const WorldPoint corner = geometry.CenterOf({0, 0});
  EXPECT_DOUBLE_EQ(corner.x_m, -255.75);
  EXPECT_DOUBLE_EQ(corner.y_m, 255.75);
  EXPECT_EQ(geometry.CellAt({-256.0, 256.0}), (CellIndex{0, 0}));
  EXPECT_EQ(geometry.CellAt({256.0, -256.0}), (CellIndex{1023, 1023}));
}

TEST(GridGeometryTest, CellAtIsTheInverseOfCenterOf) {
  const GridGeometry geometry = *GridGeometry::Create(33.3, 0.9);
  for (int row = 0; row < geometry.rows(); ++row) {
    for (int col = 0; col < geometry.cols(); ++col) {
      const WorldPoint center = geometry.CenterOf({row, col});
      ASSERT_EQ(geometry.CellAt(center), (CellIndex{row, col}));
      ASSERT_NEAR(geometry.RowOf(center.y_m), row, 1e-9);
      ASSERT_NEAR(geometry.ColOf(center.x_m), col, 1e-9);
    }
  }
}

TEST(GridGeometryTest, PointsOutsideGiveTheNearestCell) {
  const GridGeometry geometry = GridGeometry::FromCells(32, 32.0);
  EXPECT_EQ(geometry.CellAt({-1e300, 0.5}), (CellIndex{15, 0}));
  EXPECT_EQ(geometry.CellAt({std::numeric_limits<double>::infinity(), -1e9}), (CellIndex{31, 31}));
  EXPECT_FALSE(geometry.Contains({16.1, 0.0}));
  EXPECT_FALSE(geometry.Contains({std::nan(""), 0.0}));
  EXPECT_TRUE(geometry.Contains({16.0, -16.0}));
}

TEST(GridGeometryTest, EveryIllegalNumberIsRefused) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinity, -infinity, 1e-9, 1e9}) {
    EXPECT_FALSE(GridGeometry::Create(bad, 0.5).ok()) << bad;
    EXPECT_FALSE(GridGeometry::Create(512.0, bad).ok()) << bad;
    EXPECT_EQ(GridGeometry::Create(bad, bad).status().violations().size(), 2u) << bad;
  }
  EXPECT_FALSE(GridGeometry::Create(8192.0, 0.05).ok());  // 163840 cells a side
  EXPECT_FALSE(GridGeometry::Create(16.0, 16.0).ok());    // one cell
}

}  // namespace
}  // namespace latticeworld
