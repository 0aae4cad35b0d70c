// What each limit of a robot closes, against the plain definition cell by cell.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/common/random.h"
#include "latticeworld/mapping/traversability.h"
#include "mapping/scene_of_everything.h"

namespace latticeworld {
namespace {

Scene WetHills(std::uint64_t seed) {
  RandomStream random(seed, "robot_limits_test");
  const double a = random.Uniform(0.5, 2.5), b = random.Uniform(2.0, 9.0);
  const Scene dry = MakeScene(random.UniformInt(32, 150), 40.0, [&](double x_m, double y_m) {
    return a * std::sin(x_m / b) * std::cos(y_m / 4.0) + random.Uniform(0.0, 0.05);
  });
  std::vector<Asset> assets;
  for (int i = 0; i < 20; ++i)
    assets.push_back(MakeTree(static_cast<float>(random.Uniform(-20, 20)),
                              static_cast<float>(random.Uniform(-20, 20)),
                              static_cast<float>(random.Uniform(1.0, 6.0)), 2.0f, 0.2f));
  assets.push_back(MakeBuilding(3.0f, 2.0f, 4.0f, 5.0f, 3.0f, 0.4f));
  return WithSurfaces(WithWater(WithAssets(dry, assets), -0.5f), [&](double, double) {
    return static_cast<SurfaceClass>(random.UniformInt(0, kSurfaceClassCount - 1));
  });
}

RobotLimits SomeLimits(RandomStream* random) {
  RobotLimits limits;
  limits.radius_m = random->Uniform(0.0, 1.5);
  limits.max_slope_rad = random->Uniform(0.05, 1.2);
  limits.max_step_m = random->Uniform(0.0, 0.6);
  limits.max_fording_depth_m = random->Chance(0.2) ? 0.0 : random->Uniform(0.0, 1.0);
  limits.clearance_m = random->Chance(0.2) ? 0.0 : random->Uniform(0.0, 3.0);
  limits.grip = random->Uniform(0.2, 3.0);
  limits.on_wheels = random->Chance(0.5);
  return limits;
}

// The cost as the header describes it, in doubles; -1 within rounding of a limit.
double ReferenceCost(const Scene& scene, const RobotLimits& limits, int row, int col) {
  const Grid<float>& z = scene.terrain->ground.height_m();
  const double resolution_m = scene.geometry().resolution_m();
  const int north = std::max(row - 1, 0), south = std::min(row + 1, z.rows() - 1);
  const int west = std::max(col - 1, 0), east = std::min(col + 1, z.cols() - 1);
  const double here = z(row, col);
  const double gradient =
      std::hypot((z(row, east) - z(row, west)) / (resolution_m * (east - west)),
                 (z(north, col) - z(south, col)) / (resolution_m * (south - north)));
  const double step_m = std::max({std::abs(z(north, col) - here), std::abs(z(south, col) - here),
                                  std::abs(z(row, west) - here), std::abs(z(row, east) - here)});
  const double level_m = scene.terrain->water_level_m(row, col);
  const double depth_m = level_m > here ? level_m - here : 0.0;
  const double slope_rad = std::atan(gradient);
  const double max_step_m =
      std::max(limits.max_step_m, std::tan(limits.max_slope_rad) * resolution_m);
  const SurfaceProperties ground =
      Weathered(scene.terrain->surface(row, col), DryPropertiesOf(scene.terrain->surface(row, col)),
                scene.atmosphere.ground());
  const double steepest_rad = std::min(
      limits.max_slope_rad, std::atan(limits.grip * ground.friction -
                                      (limits.on_wheels ? ground.rolling_resistance : 0.0)));
  const auto near = [](double value, double limit) { return std::abs(value - limit) < 1e-4; };
  if (near(slope_rad, steepest_rad) || near(step_m, max_step_m) ||
      near(depth_m, limits.max_fording_depth_m))
    return -1.0;
  double cost = 100.0;
  if (slope_rad < steepest_rad && step_m < max_step_m && depth_m < limits.max_fording_depth_m) {
    const double share = std::max(slope_rad / steepest_rad, depth_m / limits.max_fording_depth_m);
    cost = 49.0 * std::min(share, 1.0);
  }
  return cost;
}

TEST(RobotLimitsTest, OpenGroundCostsWhatItsDefinitionSays) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Scene scene = WetHills(seed);
    scene.assets.clear();
    RandomStream random(seed, "limits");
    const RobotLimits limits = SomeLimits(&random);
    const auto occupancy = BuildOccupancy(scene, limits);
    const auto traversability = BuildTraversability(scene, limits);
    const auto slope_rad = BuildSlope(scene);
    for (int row = 0; row < occupancy.rows(); ++row) {
      for (int col = 0; col < occupancy.cols(); ++col) {
        const double cost = ReferenceCost(scene, limits, row, col);
        if (cost < 0.0) continue;
        ASSERT_NEAR(occupancy(row, col), cost, 0.51) << seed << " " << row << " " << col;
        const double expected = cost == 100.0 ? 0.0 : std::max(1.0 - cost / 49.0, 0.02);
        ASSERT_NEAR(traversability(row, col), expected, 1e-4);
        if (cost < 49.0) {
          ASSERT_LE(slope_rad(row, col), limits.max_slope_rad);
        }
      }
    }
  }
}

TEST(RobotLimitsTest, AnyNumberOfThreadsMakesTheSameMaps) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scene scene = WetHills(seed);
    const auto occupancy = BuildOccupancy(scene, {}, {}, 1);
    const auto traversability = BuildTraversability(scene, {}, {}, 1);
    const auto slope_rad = BuildSlope(scene, 1);
    for (const int threads : {2, 3, 16}) {
      EXPECT_EQ(BuildOccupancy(scene, {}, {}, threads), occupancy);
      EXPECT_EQ(BuildTraversability(scene, {}, {}, threads), traversability);
      EXPECT_EQ(BuildSlope(scene, threads), slope_rad);
    }
  }
}

// A more able robot can go wherever a less able one can.
TEST(RobotLimitsTest, EveryLimitOnlyCloses) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = WetHills(seed);
    RandomStream random(seed, "monotonous");
    const RobotLimits able = SomeLimits(&random);
    for (int limit = 0; limit < 7; ++limit) {
      RobotLimits less = able;
      if (limit == 0) less.radius_m += 0.4;
      if (limit == 1) less.max_slope_rad *= 0.7;
      if (limit == 2) less.max_step_m *= 0.7;
      if (limit == 3) less.max_fording_depth_m *= 0.7;
      if (limit == 4) less.clearance_m += 0.7;
      if (limit == 5) less.grip *= 0.7;
      if (limit == 6) less.on_wheels = true;
      const auto more = BuildOccupancy(scene, able), fewer = BuildOccupancy(scene, less);
      for (std::size_t i = 0; i < more.size(); ++i) {
        if (more.data()[i] == 100) {
          ASSERT_EQ(fewer.data()[i], 100) << seed << " limit " << limit;
        }
      }
    }
  }
}

// A tree of 4 m: its crown of 2 m radius has its underside at 1.2 m beside the trunk and at 2.6 m
// at its rim.
TEST(RobotLimitsTest, ACrownBlocksWhereItHangsLowerThanTheRobotIsHigh) {
  const Scene scene = WithAssets(MakeScene(80, 16.0, [](double, double) { return 2.0; }),
                                 {MakeTree(0.1f, 0.1f, 4.0f, 2.0f, 0.2f)});
  const auto reach_m = [&](double clearance_m, double radius_m) {
    RobotLimits limits;
    limits.radius_m = radius_m;
    limits.clearance_m = clearance_m;
    const auto occupancy = BuildOccupancy(scene, limits);
    double largest_m = 0.0;
    for (int row = 0; row < occupancy.rows(); ++row) {
      for (int col = 0; col < occupancy.cols(); ++col) {
        const WorldPoint p = scene.geometry().CenterOf({row, col});
        if (occupancy(row, col) == 100)
          largest_m = std::max(largest_m, std::hypot(p.x_m - 0.1, p.y_m - 0.1));
      }
    }
    return largest_m;
  };
  const double cell_m = scene.geometry().resolution_m();
  EXPECT_NEAR(reach_m(0.0, 0.0), 0.2, cell_m);
  EXPECT_NEAR(reach_m(1.0, 0.0), 0.2, cell_m);
  // Half axes 2 m and 1.4 m around 2.6 m above the ground: 1.9 m is reached at 2 sqrt(3) / 2.
  EXPECT_NEAR(reach_m(1.9, 0.0), 2.0 * std::sqrt(0.75), cell_m);
  EXPECT_NEAR(reach_m(1.9, 0.5), 0.5 + 2.0 * std::sqrt(0.75), cell_m);
  EXPECT_NEAR(reach_m(2.7, 0.0), 2.0, cell_m);
  EXPECT_NEAR(reach_m(9.0, 0.0), 2.0, cell_m);
}

TEST(RobotLimitsTest, OnASlopeACrownHangsLowestUphill) {
  const Scene scene = WithAssets(MakeScene(80, 16.0, [](double x_m, double) { return 0.4 * x_m; }),
                                 {MakeTree(0.1f, 0.1f, 4.0f, 2.0f, 0.2f)});
  RobotLimits limits;
  limits.radius_m = 0.0;
  limits.clearance_m = 1.2;
  const auto occupancy = BuildOccupancy(scene, limits);
  EXPECT_EQ(occupancy[scene.geometry().CellAt({1.1, 0.1})], 100);
  EXPECT_LT(occupancy[scene.geometry().CellAt({-0.9, 0.1})], 100);
}

TEST(RobotLimitsTest, TheDistanceFieldIsTheDistanceToTheNearestOccupiedCell) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    RandomStream random(seed, "distance_field");
    Grid<std::int8_t> occupancy(23, 31, 40);
    for (std::int8_t& value : occupancy)
      if (random.Chance(0.02)) value = 100;
    occupancy(3, 4) = 100;
    const auto distance_m = BuildDistanceField(occupancy, 0.25);
    for (int row = 0; row < occupancy.rows(); ++row) {
      for (int col = 0; col < occupancy.cols(); ++col) {
        double nearest = 1e9;
        for (int r = 0; r < occupancy.rows(); ++r) {
          for (int c = 0; c < occupancy.cols(); ++c) {
            if (occupancy(r, c) == 100) nearest = std::min(nearest, std::hypot(r - row, c - col));
          }
        }
        ASSERT_NEAR(distance_m(row, col), 0.25 * nearest, 1e-4);
      }
    }
  }
}

TEST(RobotLimitsTest, WithoutObstaclesEverythingIsFarAway) {
  for (const float distance_m : BuildDistanceField(Grid<std::int8_t>(5, 5, 30), 0.5))
    EXPECT_EQ(distance_m, std::numeric_limits<float>::infinity());
}

}  // namespace
}  // namespace latticeworld
