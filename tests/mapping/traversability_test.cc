#include "latticeworld/mapping/traversability.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

Scene Plane(double gradient) {
  return MakeScene(64, 32.0, [gradient](double x_m, double) { return gradient * x_m; });
}

// No ground is too slippery for it.
RobotLimits Clinging() {
  RobotLimits limits;
  limits.grip = 10.0;
  return limits;
}

TEST(TraversabilityTest, LevelOpenGroundIsFree) {
  const Scene scene = Plane(0.0);
  EXPECT_EQ(BuildTraversability(scene, {}), Grid<float>(64, 64, 1.0f));
  EXPECT_EQ(BuildOccupancy(scene, {}), Grid<std::int8_t>(64, 64, 0));
  EXPECT_EQ(BuildSlope(scene), Grid<float>(64, 64, 0.0f));
}

TEST(TraversabilityTest, SlopeOfAPlaneIsItsAngleUpToTheEdge) {
  for (const double gradient : {0.1, 0.5, 2.0}) {
    for (const float slope_rad : BuildSlope(Plane(gradient)))
      EXPECT_NEAR(slope_rad, std::atan(gradient), 1e-4);
  }
}

TEST(TraversabilityTest, ASlopeThatTheRobotCanClimbStaysBelowFiftyAndCostsItsShare) {
  for (const double share : {0.1, 0.5, 0.95}) {
    const RobotLimits limits = Clinging();
    const Scene scene = Plane(std::tan(share * limits.max_slope_rad));
    const auto occupancy = BuildOccupancy(scene, limits);
    const auto traversability = BuildTraversability(scene, limits);
    EXPECT_NEAR(occupancy(30, 30), 49.0 * share, 1.0);
    EXPECT_LT(occupancy(30, 30), 50);
    EXPECT_NEAR(traversability(30, 30), 1.0 - share, 0.02);
  }
}

TEST(TraversabilityTest, TooSteepGroundIsOccupied) {
  const RobotLimits limits = Clinging();
  const Scene scene = Plane(std::tan(1.02 * limits.max_slope_rad));
  EXPECT_EQ(BuildOccupancy(scene, limits), Grid<std::int8_t>(64, 64, 100));
  EXPECT_EQ(BuildTraversability(scene, limits), Grid<float>(64, 64, 0.0f));
}

TEST(TraversabilityTest, AStepBlocksBothOfItsSidesAndALowerOneDoesNot) {
  RobotLimits limits = Clinging();  // a climber, so that only the step counts
  limits.radius_m = 0.0;
  limits.max_slope_rad = 1.2;
  const auto occupancy_of = [&](double step_m) {
    // Cells of 0.1 m: 72 degrees make 0.257 m over one.
    return BuildOccupancy(
        MakeScene(64, 6.4, [&](double x_m, double) { return x_m < 0.0 ? 0.0 : step_m; }), limits);
  };
  const auto high = occupancy_of(0.3);
  EXPECT_LT(high(10, 30), 100);
  EXPECT_EQ(high(10, 31), 100);
  EXPECT_EQ(high(10, 32), 100);
  EXPECT_LT(high(10, 33), 100);
  const auto low = occupancy_of(0.2);
  EXPECT_LT(low(10, 31), 50);
}

TEST(TraversabilityTest, DeepWaterIsOccupiedAndShallowWaterCosts) {
  const Scene scene = WithWater(Plane(0.1), 0.0f);  // depth grows westward by 0.1 m a metre
  const auto occupancy = BuildOccupancy(scene, {});
  const auto traversability = BuildTraversability(scene, {});
  for (int col = 0; col < 64; ++col) {
    const double depth_m = -0.1 * scene.geometry().CenterOf({5, col}).x_m;
    if (depth_m > 0.21) {
      EXPECT_EQ(occupancy(5, col), 100) << col;
    } else if (depth_m < 0.19) {
      EXPECT_LT(occupancy(5, col), 50) << col;
    }
  }
  EXPECT_LT(traversability(5, 29), traversability(5, 40));  // 0.125 m deep against dry
  EXPECT_GT(traversability(5, 29), 0.0f);
}

TEST(TraversabilityTest, SolidAssetsBlockExactlyTheDiscsAndBoxesGrownByTheRadius) {
  const RobotLimits limits = {0.7, 0.5, 0.25, 0.2};
  const Asset tree = MakeTree(3.3f, 4.1f, 6.0f, 3.0f, 0.3f);
  const Asset house = MakeBuilding(-6.2f, -5.1f, 6.0f, 4.0f, 2.0f, 0.6f);
  const Asset flower = MakeRound(AssetKind::kFlower, 10.0f, 10.0f, 1.0f, 2.0f);
  const Scene scene = WithAssets(Plane(0.0), {tree, house, flower});
  const auto occupancy = BuildOccupancy(scene, limits);
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col) {
      const WorldPoint point = scene.geometry().CenterOf({row, col});
      const bool at_tree = std::hypot(point.x_m - tree.x_m, point.y_m - tree.y_m) < 0.3 + 0.7;
      const double dx = point.x_m - house.x_m, dy = point.y_m - house.y_m;
      const double along = std::abs(std::cos(0.6) * dx + std::sin(0.6) * dy) - 4.0;
      const double across = std::abs(std::cos(0.6) * dy - std::sin(0.6) * dx) - 2.0;
      const bool at_house = std::hypot(std::max(along, 0.0), std::max(across, 0.0)) < 0.7 ||
                            (along < 0 && across < 0);
      EXPECT_EQ(occupancy(row, col), at_tree || at_house ? 100 : 0) << row << " " << col;
    }
  }
}

TEST(TraversabilityTest, AThinTrunkShowsWithoutInflation) {
  const Scene scene = WithAssets(Plane(0.0), {MakeTree(3.2f, 4.2f, 6.0f, 3.0f, 0.05f)});
  const auto occupancy = BuildOccupancy(scene, {0.0, 0.5, 0.25, 0.2});
  EXPECT_EQ(occupancy[scene.geometry().CellAt({3.2, 4.2})], 100);
  EXPECT_EQ(std::count(occupancy.begin(), occupancy.end(), 100), 1);
}

TEST(TraversabilityTest, IsZeroExactlyWhereTheOccupancyIsFull) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    RandomStream random(seed, "traversability_test");
    std::vector<Asset> assets;
    for (int i = 0; i < 20; ++i)
      assets.push_back(MakeTree(static_cast<float>(random.Uniform(-16, 16)),
                                static_cast<float>(random.Uniform(-16, 16)), 5.0f, 2.0f, 0.4f));
    const double a = random.Uniform(0.5, 2.5);
    const Scene scene =
        WithWater(WithAssets(MakeScene(64, 32.0,
                                       [a](double x_m, double y_m) {
                                         return a * std::sin(x_m / 3.0) * std::cos(y_m / 4.0);
                                       }),
                             assets),
                  -0.5f);
    const auto occupancy = BuildOccupancy(scene, {});
    const auto traversability = BuildTraversability(scene, {});
    int blocked = 0;
    for (int row = 0; row < 64; ++row) {
      for (int col = 0; col < 64; ++col) {
        EXPECT_EQ(occupancy(row, col) == 100, traversability(row, col) == 0.0f);
        EXPECT_TRUE(occupancy(row, col) == 100 || occupancy(row, col) < 50);
        blocked += occupancy(row, col) == 100;
      }
    }
    EXPECT_GT(blocked, 0);
    EXPECT_LT(blocked, 64 * 64);
  }
}

}  // namespace
}  // namespace latticeworld
