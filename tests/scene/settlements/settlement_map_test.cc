#include "latticeworld/scene/settlements/settlement_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/test_world.h"

namespace latticeworld {
namespace {

TEST(SettlementMapTest, MeasuresWhatIsBuiltUp) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    if (std::hypot(point.x_m + 60.0, point.y_m) < 40.0) return 'B';
    if (std::abs(point.x_m - 80.0) < 10.0 && std::abs(point.y_m) < 60.0) return 'B';
    return point.y_m < -90.0 ? 'A' : 'G';
  };
  const SettlementMap map(*MakeTerrain(ground));
  ASSERT_EQ(map.settlements().size(), 2u);
  const Settlement& disc = map.settlements()[map.At({-60.0, 0.0})];
  EXPECT_NEAR(disc.area_m2, M_PI * 40.0 * 40.0, 500.0);
  EXPECT_NEAR(disc.heart.x_m, -60.0, 8.0);
  EXPECT_NEAR(disc.heart.y_m, 0.0, 8.0);
  EXPECT_NEAR(disc.inner_m, 40.0, 6.0);
  const Settlement& strip = map.settlements()[map.At({80.0, 0.0})];
  EXPECT_NEAR(std::abs(strip.axis_rad), M_PI / 2.0, 0.1);
  EXPECT_NEAR(strip.reach_m, 60.0, 10.0);
  EXPECT_EQ(map.At({20.0, 0.0}), -1);
  EXPECT_NEAR(map.ToBorder_m({-60.0, 20.0}), 20.0, 6.0);
  EXPECT_NEAR(map.ToField_m({80.0, 0.0}), 90.0, 6.0);
}

TEST(SettlementMapTest, ARoadThroughAVillageDoesNotDivideIt) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    if (std::abs(point.y_m) < 7.0) return 'R';
    return std::abs(point.x_m) < 50.0 && std::abs(point.y_m) < 40.0 ? 'B' : 'G';
  };
  const SettlementMap map(*MakeTerrain(ground));
  EXPECT_EQ(map.settlements().size(), 1u);
  EXPECT_EQ(map.At({0.0, 20.0}), map.At({0.0, -20.0}));
}

TEST(SettlementMapTest, BuiltUpLandAllOverHasNoBorder) {
  const SettlementMap map(*MakeUniform(Vocabulary::kSuburb, 'B'));
  ASSERT_EQ(map.settlements().size(), 1u);
  EXPECT_TRUE(std::isfinite(map.settlements()[0].inner_m));
  EXPECT_FALSE(std::isfinite(map.ToField_m({0.0, 0.0})));
}

}  // namespace
}  // namespace latticeworld
