#include "latticeworld/scene/road_finder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

TEST(RoadFinderTest, HeadsSquareToAStraightRoad) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) { return std::abs(point.y_m) < 4.0 ? 'R' : 'G'; };
  const auto terrain = MakeTerrain(ground);
  const RoadFinder roads(*terrain);
  for (double x_m = -100.0; x_m <= 100.0; x_m += 7.3) {
    const auto north = roads.Nearest({x_m, 20.0});
    ASSERT_TRUE(north.has_value());
    EXPECT_NEAR(north->heading_rad, -M_PI / 2.0, 0.1);
    EXPECT_NEAR(north->distance_m, 16.5, 0.6);
    const auto south = roads.Nearest({x_m, -30.0});
    ASSERT_TRUE(south.has_value());
    EXPECT_NEAR(south->heading_rad, M_PI / 2.0, 0.1);
  }
  EXPECT_FALSE(roads.Nearest({0.0, 0.5}).has_value()) << "on the road";
  EXPECT_FALSE(roads.Nearest({0.0, 60.0}).has_value()) << "beyond reach";
}

TEST(RoadFinderTest, DistanceIsThatOfBruteForce) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto terrain = MakePatchwork(Vocabulary::kSuburb, seed);
    const GridGeometry& geometry = terrain->geometry();
    const RoadFinder roads(*terrain);
    RandomStream random(seed, "road_finder_test");
    for (int i = 0; i < 10; ++i) {
      const WorldPoint point = {random.Uniform(-128.0, 128.0), random.Uniform(-128.0, 128.0)};
      double nearest_m = INFINITY;
      for (int row = 0; row < geometry.rows(); ++row) {
        for (int col = 0; col < geometry.cols(); ++col) {
          if (terrain->surface(row, col) != SurfaceClass::kRoad) continue;
          const WorldPoint cell = geometry.CenterOf({row, col});
          nearest_m = std::min(nearest_m, std::hypot(cell.x_m - point.x_m, cell.y_m - point.y_m));
        }
      }
      const auto road = roads.Nearest(point);
      ASSERT_EQ(road.has_value(), nearest_m <= RoadFinder::kReach_m && nearest_m >= 1.0);
      if (road) {
        EXPECT_NEAR(road->distance_m, nearest_m, 1e-9);
      }
    }
  }
}

TEST(RoadFinderTest, NoRoadNoAnswer) {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'G'; };
  EXPECT_FALSE(RoadFinder(*MakeTerrain(ground)).Nearest({0.0, 0.0}).has_value());
}

}  // namespace
}  // namespace latticeworld
