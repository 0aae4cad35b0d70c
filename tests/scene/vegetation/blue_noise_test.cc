#include "latticeworld/scene/vegetation/blue_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "scene/vegetation/even_points.h"

namespace latticeworld {
namespace {

double LeastDistance(const std::vector<RankedBlueNoise::Point>& points) {
  double least_m = INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least_m = std::min<double>(
          least_m, std::hypot(points[i].x_m - points[j].x_m, points[i].y_m - points[j].y_m));
    }
  }
  return least_m;
}

std::vector<RankedBlueNoise::Point> PointsOf(const RankedBlueNoise& noise, double below_rank) {
  std::vector<RankedBlueNoise::Point> points;
  for (int tile = 0; tile < noise.tiles(); ++tile) {
    noise.ForEachIn(tile, [&](const RankedBlueNoise::Point& point) {
      if (point.rank < below_rank) points.push_back(point);
    });
  }
  return points;
}

double All(WorldPoint, WorldPoint) { return 1.0; }

TEST(BlueNoiseTest, PointsKeepTheirSpacingAndStayInside) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "blue_noise_test");
    const double size_m = random.Uniform(16.0, 120.0), per_m2 = random.Uniform(0.005, 0.2);
    const auto points = EvenPoints(size_m, per_m2, random.NextBits());
    const double spacing_m = BlueNoiseSpacing(per_m2);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_LE(std::abs(points[i].x_m), 0.5 * size_m + 1e-4);
      ASSERT_LE(std::abs(points[i].y_m), 0.5 * size_m + 1e-4);
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_GE(std::hypot(points[i].x_m - points[j].x_m, points[i].y_m - points[j].y_m),
                  spacing_m - 1e-3);
      }
    }
  }
}

TEST(BlueNoiseTest, ThereAreAsManyAsAskedFor) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const double per_m2 : {0.006, 0.04, 0.11}) {
      RandomStream random(seed, "blue_noise_test");
      const double wanted = 400.0 * 400.0 * per_m2;
      EXPECT_NEAR(EvenPoints(400.0, per_m2, random.NextBits()).size(), wanted, 0.05 * wanted);
    }
  }
}

TEST(BlueNoiseTest, NoLargeHoleIsLeft) {
  RandomStream random(5, "blue_noise_test");
  const double spacing_m = BlueNoiseSpacing(0.04);
  const auto points = EvenPoints(100.0, 0.04, random.NextBits());
  for (int i = 0; i < 2000; ++i) {
    const double x_m = random.Uniform(-50.0, 50.0), y_m = random.Uniform(-50.0, 50.0);
    double nearest_m = INFINITY;
    for (const WorldPoint& point : points) {
      nearest_m = std::min(nearest_m, std::hypot(point.x_m - x_m, point.y_m - y_m));
    }
    EXPECT_LT(nearest_m, 1.6 * spacing_m);
  }
}

TEST(BlueNoiseTest, ARankBelowPIsTheShareP) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const RankedBlueNoise noise(300.0, 0.2, seed, All, 0);
    const double all = static_cast<double>(PointsOf(noise, 1.0).size());
    for (const double share : {0.05, 0.125, 0.25, 0.4, 0.5, 0.75, 0.9}) {
      EXPECT_NEAR(static_cast<double>(PointsOf(noise, share).size()) / all, share, 0.02);
    }
  }
}

// What a random choice of a quarter could not: it keeps no more distance than the whole set.
TEST(BlueNoiseTest, FewRanksKeepMoreDistance) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const RankedBlueNoise noise(120.0, 0.2, seed, All, 0);
    const double spacing_m = BlueNoiseSpacing(0.2);
    EXPECT_GE(LeastDistance(PointsOf(noise, 1.0)), spacing_m - 1e-3);
    EXPECT_GE(LeastDistance(PointsOf(noise, 0.5)), std::sqrt(2.0) * spacing_m - 1e-3);
    EXPECT_GE(LeastDistance(PointsOf(noise, 0.25)), 2.0 * spacing_m - 1e-3);
    EXPECT_GE(LeastDistance(PointsOf(noise, 0.14)), std::sqrt(8.0) * spacing_m - 1e-3);
  }
}

TEST(BlueNoiseTest, AnyNumberOfThreadsGivesTheSamePoints) {
  const auto one = PointsOf(RankedBlueNoise(500.0, 0.1, 3, All, 1), 1.0);
  for (const int threads : {2, 3, 7}) {
    const auto many = PointsOf(RankedBlueNoise(500.0, 0.1, 3, All, threads), 1.0);
    ASSERT_EQ(one.size(), many.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(one[i].id, many[i].id);
      ASSERT_EQ(one[i].x_m, many[i].x_m);
      ASSERT_EQ(one[i].y_m, many[i].y_m);
      ASSERT_EQ(one[i].rank, many[i].rank);
    }
  }
}

TEST(BlueNoiseTest, PointsStandWhereTheyAreNeededAsOftenAsNeeded) {
  // Nothing in the west, everything in the east.
  const RankedBlueNoise noise(
      400.0, 0.1, 9, [](WorldPoint, WorldPoint high) { return high.x_m > 0.0 ? 1.0 : 0.0; }, 0);
  std::set<std::uint64_t> ids;
  int east = 0;
  for (const RankedBlueNoise::Point& point : PointsOf(noise, 1.0)) {
    EXPECT_GT(point.x_m, -50.0f);
    east += point.x_m > 0.0f ? 1 : 0;
    EXPECT_TRUE(ids.insert(point.id).second);
  }
  EXPECT_NEAR(east, 8000, 400);
  // A tenth everywhere: no fewer of the low ranks, none of the high ones.
  const RankedBlueNoise sparse(
      400.0, 0.1, 9, [](WorldPoint, WorldPoint) { return 0.1; }, 0);
  EXPECT_NEAR(static_cast<double>(PointsOf(sparse, 0.1).size()), 1600.0, 80.0);
  EXPECT_LT(PointsOf(sparse, 1.0).size(), 2600u);
}

// The pair correlation of a random set is 1 at every distance.
TEST(BlueNoiseTest, PairsAreMissingBelowTheSpacingAndCommonJustBeyondIt) {
  const double per_m2 = 0.1, size_m = 200.0, spacing_m = BlueNoiseSpacing(per_m2);
  const auto points = PointsOf(RankedBlueNoise(size_m, per_m2, 4, All, 0), 1.0);
  const auto correlation = [&](double low_m, double high_m) {
    double pairs = 0.0, centres = 0.0;
    for (const auto& a : points) {
      if (std::abs(a.x_m) > 80.0f || std::abs(a.y_m) > 80.0f) continue;
      centres += 1.0;
      for (const auto& b : points) {
        const double distance_m = std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
        pairs += a.id != b.id && distance_m >= low_m && distance_m < high_m ? 1.0 : 0.0;
      }
    }
    return pairs / (centres * per_m2 * M_PI * (high_m * high_m - low_m * low_m));
  };
  EXPECT_EQ(correlation(0.0, spacing_m - 1e-3), 0.0);
  EXPECT_GT(correlation(spacing_m, 1.1 * spacing_m), 1.5);
  EXPECT_NEAR(correlation(5.0 * spacing_m, 6.0 * spacing_m), 1.0, 0.05);
}

}  // namespace
}  // namespace latticeworld
