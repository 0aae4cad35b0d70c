#include "latticeworld/navigation/distance_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/common/random.h"
#include "latticeworld/navigation/surface_path.h"
#include "navigation/made_map.h"

namespace latticeworld {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
double Flat(double, double) { return 0.0; }

WorldPoint Draw(RandomStream* random, double half_m) {
  return {random->Uniform(-half_m, half_m), random->Uniform(-half_m, half_m)};
}

TEST(DistanceField, IsTheStraightLineOnAPlaneWhateverItsSlope) {
  for (const double slope : {0.0, 0.3, 0.55}) {
    const NavigableMap map =
        MadeMap(200, 100.0, [&](double x, double y) { return slope * (0.6 * x + 0.8 * y); });
    const WorldPoint goal{-20.0, 13.0};
    const DistanceField field = DistancesTo(map, goal).value();
    RandomStream random(7, "places");
    for (int i = 0; i < 300; ++i) {
      const WorldPoint place = Draw(&random, 49.0);
      const double rise = slope * (0.6 * (place.x_m - goal.x_m) + 0.8 * (place.y_m - goal.y_m));
      const double straight =
          std::hypot(std::hypot(place.x_m - goal.x_m, place.y_m - goal.y_m), rise);
      if (straight < 10.0) continue;
      EXPECT_NEAR(field.At(place) / straight, 1.0, 0.01)
          << slope << " " << place.x_m << " " << place.y_m;
    }
  }
}

TEST(DistanceField, GoesRoundTheEndOfAWall) {
  // A wall along x = 0 from the south up to y = 10.
  const NavigableMap map =
      MadeMap(200, 100.0, Flat, [](double x, double y) { return std::abs(x) < 0.5 && y < 10.0; });
  const WorldPoint goal{-20.0, -10.0}, start{25.0, -20.0};
  const DistanceField field = DistancesTo(map, goal).value();
  // By the two corners of its end.
  const double exact = std::hypot(19.5, 20.0) + 1.0 + std::hypot(24.5, 30.0);
  EXPECT_NEAR(field.At(start), exact, 0.015 * exact);
  const SurfacePath path = PathDown(map, field, start).value();
  EXPECT_NEAR(path.length_m, exact, 0.02 * exact);
  EXPECT_GE(path.length_m, exact - 0.5);
}

TEST(DistanceField, GoesAlongTheGeodesicOfACone) {
  // On a cone the way between two places unrolls to a straight line of a flat sector.
  const double slope = 0.5;
  const NavigableMap map =
      MadeMap(400, 100.0, [&](double x, double y) { return 30.0 - slope * std::hypot(x, y); });
  const double stretch = std::sqrt(1.0 + slope * slope);
  const WorldPoint goal{-30.0, 0.0};
  const DistanceField field = DistancesTo(map, goal).value();
  for (const double angle : {0.6, 1.2, 2.0, 2.6}) {
    const double r = 35.0;
    const WorldPoint place{r * std::cos(M_PI - angle), r * std::sin(M_PI - angle)};
    const double unrolled = angle / stretch;
    const double a = 30.0 * stretch, b = r * stretch;
    const double exact = std::sqrt(a * a + b * b - 2.0 * a * b * std::cos(unrolled));
    EXPECT_NEAR(field.At(place) / exact, 1.0, 0.012) << angle;
  }
}

TEST(DistanceField, IsTheSameBothWays) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomStream random(seed, "bumps");
    const double a = random.Uniform(0.5, 3.0), b = random.Uniform(8.0, 20.0);
    const NavigableMap map = MadeMap(
        120, 60.0,
        [&](double x, double y) { return a * std::sin(x / b * 6.0) * std::cos(y / b * 5.0); },
        [&](double x, double y) {
          return std::hypot(std::fmod(x + 90.0, 9.0) - 4.5, std::fmod(y + 90.0, 9.0) - 4.5) < 1.5;
        });
    WorldPoint from = Draw(&random, 28.0), to = Draw(&random, 28.0);
    if (!map.IsFree(from) || !map.IsFree(to)) continue;
    const double there = DistancesTo(map, to).value().At(from);
    const double back = DistancesTo(map, from).value().At(to);
    EXPECT_NEAR(there, back, 0.01 * there + 0.3) << seed;
  }
}

TEST(DistanceField, PathsStayFreeAndAreNoShorterThanTheFieldSays) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    RandomStream random(seed, "forest");
    std::vector<WorldPoint> trees;
    for (int i = 0; i < 120; ++i) trees.push_back(Draw(&random, 38.0));
    const NavigableMap map = MadeMap(
        160, 80.0, [](double x, double y) { return 2.0 * std::sin(0.1 * x) + 0.05 * y; },
        [&](double x, double y) {
          return std::any_of(trees.begin(), trees.end(), [&](WorldPoint tree) {
            return std::hypot(x - tree.x_m, y - tree.y_m) < 1.6;
          });
        });
    const WorldPoint goal = Draw(&random, 39.0);
    if (!map.IsFree(goal)) continue;
    const DistanceField field = DistancesTo(map, goal).value();
    for (int i = 0; i < 10; ++i) {
      const WorldPoint start = Draw(&random, 39.0);
      const Result<SurfacePath> path = PathDown(map, field, start);
      if (!map.IsFree(start) || field.At(start) == kInfinity) {
        continue;
      }
      ASSERT_TRUE(path.ok()) << path.status().ToString();
      EXPECT_DOUBLE_EQ(path.value().points_m.front().x(), start.x_m);
      EXPECT_DOUBLE_EQ(path.value().points_m.back().y(), goal.y_m);
      for (std::size_t leg = 1; leg < path.value().points_m.size(); ++leg) {
        const Eigen::Vector3d& a = path.value().points_m[leg - 1];
        const Eigen::Vector3d& b = path.value().points_m[leg];
        EXPECT_TRUE(MeasureLine(map, {a.x(), a.y()}, {b.x(), b.y()}).is_free);
      }
      EXPECT_LE(path.value().length_m, 1.05 * field.At(start) + 0.5) << seed;
      EXPECT_GE(path.value().length_m, 0.985 * field.At(start) - 0.5) << seed;
    }
  }
}

TEST(DistanceField, DiagonalsDoNotCutCorners) {
  // Two blocks that touch at a corner only: nobody passes between them.
  const NavigableMap map = MadeMap(64, 64.0, Flat, [](double x, double y) {
    return (x < 0.0 && y > 0.0 && y < 1.0) || (x > 0.0 && y > -1.0 && y < 0.0);
  });
  const DistanceField field = DistancesTo(map, {0.5, 20.0}).value();
  EXPECT_EQ(field.At({0.5, -20.0}), kInfinity);
  EXPECT_EQ(PathDown(map, field, {0.5, -20.0}).status().code(), StatusCode::kNotFound);
}

TEST(DistanceField, EndsWhereItIsToldTo) {
  const NavigableMap map = MadeMap(100, 100.0, Flat);
  const DistanceField field = DistancesTo(map, {0.0, 0.0}, 20.0).value();
  EXPECT_LT(field.At({15.0, 0.0}), 16.0);
  EXPECT_EQ(field.At({25.0, 0.0}), kInfinity);
}

TEST(DistanceField, RefusesGoalsThatAreNone) {
  const NavigableMap map = MadeMap(64, 64.0, Flat, [](double x, double) { return x > 10.0; });
  EXPECT_EQ(DistancesTo(map, {20.0, 0.0}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(DistancesTo(map, {200.0, 0.0}).status().code(), StatusCode::kOutOfRange);
  EXPECT_EQ(DistancesTo(map, {std::nan(""), 0.0}).status().code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
