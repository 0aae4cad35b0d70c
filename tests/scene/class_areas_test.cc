#include "latticeworld/scene/class_areas.h"

#include <gtest/gtest.h>

#include <cmath>

namespace latticeworld {
namespace {

TEST(ClassAreasTest, SeparateAreasHaveTheirOwnDirection) {
  const GridGeometry geometry = GridGeometry::FromCells(128, 256.0);
  Grid<float> weight(128, 128, 0.0f);
  // A strip that runs from south-west to north-east, and a strip north-south far east of it.
  for (int row = 0; row < 128; ++row) {
    for (int col = 0; col < 128; ++col) {
      const WorldPoint point = geometry.CenterOf({row, col});
      const bool diagonal = std::abs(point.x_m - point.y_m) < 20.0 && point.x_m < 40.0;
      const bool upright = point.x_m > 90.0 && point.x_m < 115.0;
      if (diagonal || upright) weight(row, col) = 0.9f;
    }
  }
  const ClassAreas areas(geometry, weight);
  ASSERT_EQ(areas.areas().size(), 2u);
  const int diagonal = areas.AreaAt({0.0, 0.0}), upright = areas.AreaAt({100.0, 50.0});
  ASSERT_GE(diagonal, 0);
  ASSERT_GE(upright, 0);
  EXPECT_NE(diagonal, upright);
  EXPECT_NEAR(areas.areas()[diagonal].direction_rad, M_PI / 4.0, 0.1);
  EXPECT_NEAR(std::abs(areas.areas()[upright].direction_rad), M_PI / 2.0, 0.05);
  EXPECT_EQ(areas.AreaAt({60.0, -60.0}), -1);
}

TEST(ClassAreasTest, EveryPointOfAnAreaIsWithinItsReach) {
  const GridGeometry geometry = GridGeometry::FromCells(100, 50.0);
  Grid<float> weight(100, 100, 0.0f);
  for (int row = 20; row < 50; ++row) {
    for (int col = 10; col < 90; ++col) weight(row, col) = 1.0f;
  }
  const ClassAreas areas(geometry, weight);
  ASSERT_EQ(areas.areas().size(), 1u);
  for (int row = 0; row < 100; ++row) {
    for (int col = 0; col < 100; ++col) {
      const WorldPoint point = geometry.CenterOf({row, col});
      if (weight(row, col) > 0.5f) {
        EXPECT_EQ(areas.AreaAt(point), 0);
      }
      if (areas.AreaAt(point) != 0) continue;
      EXPECT_LE(std::hypot(point.x_m - areas.areas()[0].centre.x_m,
                           point.y_m - areas.areas()[0].centre.y_m),
                areas.areas()[0].reach_m);
    }
  }
}

}  // namespace
}  // namespace latticeworld
