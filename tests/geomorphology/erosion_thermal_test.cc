#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/erosion.h"

namespace latticeworld {
namespace {

Grid<float> RoughLand(int rows, int cols, int seed, double relief_m) {
  Grid<float> height_m(rows, cols);
  RandomStream random(seed, "erosion_thermal_test");
  for (float& h : height_m) h = static_cast<float>(random.Uniform(0.0, relief_m));
  return height_m;
}

double Mass(const Grid<float>& height_m) {
  return std::accumulate(height_m.begin(), height_m.end(), 0.0);
}

// The steepest slope between two neighbours [m/m].
double Steepest(const Grid<float>& height_m, double resolution_m) {
  double steepest = 0.0;
  for (int r = 0; r < height_m.rows(); ++r) {
    for (int c = 0; c < height_m.cols(); ++c) {
      for (const auto& [dr, dc] : {std::pair{0, 1}, {1, -1}, {1, 0}, {1, 1}}) {
        if (!height_m.Contains({r + dr, c + dc})) continue;
        const double rise_m = std::abs(height_m(r, c) - height_m(r + dr, c + dc));
        steepest = std::max(steepest, rise_m / (resolution_m * std::hypot(dr, dc)));
      }
    }
  }
  return steepest;
}

TEST(ErosionThermalTest, ConservesMass) {
  for (int seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "sizes");
    const int rows = random.UniformInt(1, 60);
    const int cols = random.UniformInt(1, 60);
    const Grid<float> before = RoughLand(rows, cols, seed, 50.0);
    Grid<float> after = before;
    const Grid<float> talus_of = RoughLand(rows, cols, seed + 1000, 1.5);
    ErodeThermally(2.0, {50, 0.6}, seed % 2 == 0 ? nullptr : &talus_of, 0, &after);
    EXPECT_NEAR(Mass(after), Mass(before), 1e-6 * Mass(before)) << "seed " << seed;
    if (rows * cols > 1) {
      EXPECT_NE(after, before);
    }
  }
}

TEST(ErosionThermalTest, EndsBelowTheTalusAngle) {
  for (const double talus : {0.3, 0.7, 1.2}) {
    Grid<float> height_m = RoughLand(24, 24, 7, 20.0);
    ASSERT_GT(Steepest(height_m, 2.0), 3.0);
    ErodeThermally(2.0, {1500, talus}, nullptr, 0, &height_m);
    EXPECT_LT(Steepest(height_m, 2.0), talus * 1.01);
  }
}

TEST(ErosionThermalTest, LeavesSlopesBelowTheTalusAngle) {
  Grid<float> before(40, 40);
  for (int r = 0; r < 40; ++r) {
    for (int c = 0; c < 40; ++c) before(r, c) = 0.4f * static_cast<float>(c);
  }
  Grid<float> after = before;
  ErodeThermally(1.0, {50, 0.5}, nullptr, 0, &after);
  EXPECT_EQ(after, before);
}

TEST(ErosionThermalTest, AMoundFallsApartAlikeInEveryDirection) {
  Grid<float> height_m(41, 41);
  height_m(20, 20) = 200.0f;
  ErodeThermally(1.0, {400, 0.5}, nullptr, 0, &height_m);
  for (int r = 0; r < 41; ++r) {
    for (int c = 0; c < 41; ++c) {
      EXPECT_NEAR(height_m(r, c), height_m(40 - r, c), 1e-4);
      EXPECT_NEAR(height_m(r, c), height_m(r, 40 - c), 1e-4);
      EXPECT_NEAR(height_m(r, c), height_m(c, r), 1e-4);
    }
  }
}

TEST(ErosionThermalTest, AColumnGivesEachNeighbourItsShareOfTheExcess) {
  Grid<float> height_m(5, 5);
  height_m(2, 2) = 100.0f;
  ErodeThermally(2.0, {1, 0.5}, nullptr, 0, &height_m);
  const double beside = 0.125 * (100.0 - 0.5 * 2.0);
  const double across = 0.0625 * (100.0 - 0.5 * 2.0 * std::sqrt(2.0));
  EXPECT_NEAR(height_m(1, 2), beside, 1e-4);
  EXPECT_NEAR(height_m(2, 3), beside, 1e-4);
  EXPECT_NEAR(height_m(1, 1), across, 1e-4);
  EXPECT_NEAR(height_m(3, 1), across, 1e-4);
  EXPECT_NEAR(height_m(2, 2), 100.0 - 4.0 * beside - 4.0 * across, 1e-4);
  EXPECT_EQ(height_m(0, 2), 0.0f);
}

TEST(ErosionThermalTest, NeverOvershoots) {
  for (int seed = 0; seed < 20; ++seed) {
    Grid<float> height_m = RoughLand(30, 30, seed, 100.0);
    const auto [low, high] = std::minmax_element(height_m.begin(), height_m.end());
    const float lowest = *low;
    const float highest = *high;
    ErodeThermally(1.0, {20, 1e-6}, nullptr, 0, &height_m);
    for (const float h : height_m) {
      EXPECT_GE(h, lowest - 1e-4f);
      EXPECT_LE(h, highest + 1e-4f);
    }
  }
}

TEST(ErosionThermalTest, TheHigherCellsTalusHolds) {
  // A cliff of rock stands over sand; the same cliff of sand slides.
  Grid<float> cliff(10, 20);
  for (int r = 0; r < 10; ++r) std::fill(cliff.row(r), cliff.row(r) + 10, 5.0f);
  Grid<float> talus_of(10, 20, 0.1f);
  for (int r = 0; r < 10; ++r) std::fill(talus_of.row(r), talus_of.row(r) + 10, 6.0f);
  Grid<float> rock = cliff;
  ErodeThermally(1.0, {10, 0.1}, &talus_of, 0, &rock);
  EXPECT_EQ(rock, cliff);
  Grid<float> sand = cliff;
  ErodeThermally(1.0, {10, 0.1}, nullptr, 0, &sand);
  EXPECT_LT(sand(5, 9), 4.0f);
}

TEST(ErosionThermalTest, IsTheSameWithAnyNumberOfThreads) {
  const Grid<float> before = RoughLand(70, 53, 4, 30.0);
  const Grid<float> talus_of = RoughLand(70, 53, 5, 1.0);
  for (const Grid<float>* given : {static_cast<const Grid<float>*>(nullptr), &talus_of}) {
    Grid<float> one = before;
    ErodeThermally(1.0, {15, 0.5}, given, 1, &one);
    for (const int threads : {2, 3, 7, 100}) {
      Grid<float> more = before;
      ErodeThermally(1.0, {15, 0.5}, given, threads, &more);
      EXPECT_EQ(one, more) << threads;
    }
  }
}

TEST(ErosionThermalTest, TakesGridsOfOneCellAndOfNone) {
  Grid<float> one(1, 1, 4.0f);
  ErodeThermally(1.0, {}, nullptr, 0, &one);
  EXPECT_EQ(one(0, 0), 4.0f);
  Grid<float> none;
  ErodeThermally(1.0, {}, nullptr, 0, &none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace latticeworld
