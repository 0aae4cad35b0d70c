#include "latticeworld/geometry/region.h"

#include <gtest/gtest.h>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

TEST(RegionTest, UpperLeftIsNorthWest) {
  EXPECT_TRUE(BoxOf(Region::kUpperLeft).Contains(0.01, 0.01));
  EXPECT_TRUE(BoxOf(Region::kCenter).Contains(0.5, 0.5));
  EXPECT_TRUE(BoxOf(Region::kMiddleRight).Contains(0.99, 0.5));
  EXPECT_TRUE(BoxOf(Region::kLower).Contains(0.5, 0.99));
}

TEST(RegionTest, EachPointIsInExactlyOneNinthAndAnywhere) {
  RandomStream random(1, "points");
  for (int i = 0; i < 1000; ++i) {
    const double u = random.Uniform(), v = random.Uniform();
    int boxes = 0;
    for (const auto& entry : EnumNames(Region{})) boxes += BoxOf(entry.value).Contains(u, v);
    ASSERT_EQ(boxes, 2);  // its ninth and anywhere
  }
}

}  // namespace
}  // namespace latticeworld
