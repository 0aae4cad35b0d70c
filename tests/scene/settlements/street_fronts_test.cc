#include "latticeworld/scene/settlements/street_fronts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/test_world.h"

namespace latticeworld {
namespace {

TEST(StreetFrontsTest, AStreetHasTwoWithTheLandOnTheirLeft) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    return std::abs(point.y_m) < 3.0 && std::abs(point.x_m) < 100.0 ? 'R' : 'B';
  };
  const std::vector<StreetFront> fronts = StreetFrontsOf(*MakeTerrain(ground));
  // The street ends on both sides: one outline around it.
  ASSERT_EQ(fronts.size(), 1u);
  EXPECT_NEAR(fronts[0].length_m, 2.0 * (200.0 + 6.0), 12.0);
  for (double along_m = 5.0; along_m < fronts[0].length_m - 5.0; along_m += 3.0) {
    const StreetFront::Place place = fronts[0].At(along_m);
    if (std::abs(place.at.x_m) > 90.0) continue;
    EXPECT_NEAR(std::abs(place.at.y_m), 3.0, 0.6);
    const double to_the_left_m = std::sin(place.heading_rad + M_PI / 2.0);
    EXPECT_GT(to_the_left_m * place.at.y_m, 2.0) << "away from the street";
  }
}

TEST(StreetFrontsTest, ThereAreNoneWhereNothingIsBuiltUp) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) {
    if (std::abs(point.y_m) < 3.0) return 'R';
    return point.x_m > 0.0 && point.y_m > 0.0 ? 'B' : 'G';
  };
  const std::vector<StreetFront> fronts = StreetFrontsOf(*MakeTerrain(ground));
  ASSERT_EQ(fronts.size(), 1u);
  for (const WorldPoint point : fronts[0].line) {
    EXPECT_GT(point.x_m, -4.0);
    EXPECT_GT(point.y_m, 0.0);
  }
}

TEST(StreetFrontsTest, EveryBlockHasItsOwn) {
  TestGround ground;
  // A grid of streets: 3 x 3 blocks, which the world's edge leaves open outside.
  ground.letter_at = [](WorldPoint point) {
    const auto on_street = [](double at_m) {
      return std::abs(std::remainder(at_m, 64.0)) < 2.0 && std::abs(at_m) < 100.0;
    };
    const bool inside = std::abs(point.x_m) < 66.0 && std::abs(point.y_m) < 66.0;
    return inside && (on_street(point.x_m) || on_street(point.y_m)) ? 'R' : 'B';
  };
  const std::vector<StreetFront> fronts = StreetFrontsOf(*MakeTerrain(ground));
  // Four blocks and the outside.
  EXPECT_EQ(fronts.size(), 5u);
}

TEST(StreetFrontsTest, AreTheSameAtAFinerResolution) {
  const auto length_m = [](int cells) {
    TestGround ground;
    ground.cells = cells;
    ground.letter_at = [](WorldPoint point) {
      return std::abs(point.y_m - 20.0 * std::sin(point.x_m / 30.0)) < 4.0 ? 'R' : 'B';
    };
    double sum_m = 0.0;
    for (const StreetFront& front : StreetFrontsOf(*MakeTerrain(ground))) sum_m += front.length_m;
    return sum_m;
  };
  EXPECT_NEAR(length_m(256), length_m(1024), 0.05 * length_m(256));
}

}  // namespace
}  // namespace latticeworld
