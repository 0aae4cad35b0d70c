#include "latticeworld/geometry/region.h"

#include <gtest/gtest.h>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

TEST(RegionTest, UpperLeftIsNorthWest) {
  const GridGeometry geometry = GridGeometry::FromCells(30, 300.0);
  EXPECT_EQ(RegionAt(geometry, {-149.0, 149.0}), Region::kUpperLeft);
  EXPECT_EQ(RegionAt(geometry, {0.0, 0.0}), Region::kCenter);
  EXPECT_EQ(RegionAt(geometry, {149.0, 0.0}), Region::kMiddleRight);
  EXPECT_EQ(RegionAt(geometry, {0.0, -149.0}), Region::kLower);
  EXPECT_EQ(RegionAt(geometry, {1e6, -1e6}), Region::kLowerRight);
}

TEST(RegionTest, EachPointIsInExactlyOneNinthAndAnywhere) {
  const GridGeometry geometry = GridGeometry::FromCells(32, 64.0);
  RandomStream random(1, "points");
  for (int i = 0; i < 1000; ++i) {
    const WorldPoint p = {random.Uniform(-32.0, 32.0), random.Uniform(-32.0, 32.0)};
    int ninths = 0;
    for (const auto& entry : EnumNames(Region{})) ninths += IsIn(entry.value, geometry, p);
    ASSERT_EQ(ninths, 2);  // its own and anywhere
    const UnitBox box = BoxOf(RegionAt(geometry, p));
    ASSERT_TRUE(box.Contains((p.x_m + 32.0) / 64.0, (32.0 - p.y_m) / 64.0));
  }
}

}  // namespace
}  // namespace latticeworld
