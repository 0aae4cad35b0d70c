#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/erosion.h"

namespace latticeworld {
namespace {

// A slope of 1 to 2 down to the south, with bumps.
Grid<float> RoughSlope(int rows, int cols, int seed) {
  Grid<float> height_m(rows, cols);
  RandomStream random(seed, "erosion_droplets_test");
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      height_m(r, c) = 0.5f * static_cast<float>(rows - r) + static_cast<float>(random.Uniform());
    }
  }
  return height_m;
}

double Mass(const Grid<float>& height_m) {
  return std::accumulate(height_m.begin(), height_m.end(), 0.0);
}

DropletOptions Drops(int count) {
  DropletOptions options;
  options.droplets = count;
  return options;
}

TEST(ErosionDropletsTest, ConservesMassInABasin) {
  for (int seed = 0; seed < 10; ++seed) {
    Grid<float> height_m(60, 70);
    for (int r = 0; r < 60; ++r) {
      for (int c = 0; c < 70; ++c) {
        height_m(r, c) = static_cast<float>(0.02 * ((r - 30) * (r - 30) + (c - 35) * (c - 35)));
      }
    }
    const Grid<float> before = height_m;
    ErodeByDroplets(1.0, Drops(1000), seed, 0, &height_m);
    EXPECT_NE(height_m, before);
    EXPECT_NEAR(Mass(height_m), Mass(before), 1e-4 * Mass(before));
    EXPECT_GT(height_m(30, 35), before(30, 35));  // soil gathers in the middle
  }
}

TEST(ErosionDropletsTest, LosesOnlyWhatLeavesTheGrid) {
  for (int seed = 0; seed < 10; ++seed) {
    Grid<float> height_m = RoughSlope(80, 60, seed);
    const double before = Mass(height_m);
    ErodeByDroplets(1.0, Drops(1000), seed, 0, &height_m);
    EXPECT_LT(Mass(height_m), before);
    EXPECT_GT(Mass(height_m), 0.9 * before);
  }
}

TEST(ErosionDropletsTest, CutsDownhill) {
  // Water that ran together makes the ground across the slope less even than it was.
  Grid<float> height_m(128, 128);
  RandomStream random(1, "bumps");
  for (int r = 0; r < 128; ++r) {
    for (int c = 0; c < 128; ++c) {
      height_m(r, c) =
          0.5f * static_cast<float>(128 - r) + 0.02f * static_cast<float>(random.Uniform());
    }
  }
  const auto roughness = [&height_m] {
    double sum = 0.0;
    for (int r = 40; r < 100; ++r) {
      for (int c = 8; c < 120; ++c) {
        const double mean = 0.5 * (height_m(r, c - 4) + height_m(r, c + 4));
        sum += std::pow(height_m(r, c) - mean, 2);
      }
    }
    return sum;
  };
  const double before = roughness();
  ErodeByDroplets(1.0, Drops(20000), 5, 0, &height_m);
  EXPECT_GT(roughness(), 20.0 * before);
}

TEST(ErosionDropletsTest, EveryDropFallsSomewhereElse) {
  // So small a grid takes its drops one by one: two are not the first twice.
  Grid<float> two = RoughSlope(16, 16, 6);
  Grid<float> first_twice = two;
  ErodeByDroplets(1.0, Drops(2), 3, 0, &two);
  for (int i = 0; i < 2; ++i) ErodeByDroplets(1.0, Drops(1), 3, 0, &first_twice);
  EXPECT_NE(two, first_twice);
}

TEST(ErosionDropletsTest, IsTheSameWithAnyNumberOfThreads) {
  const Grid<float> before = RoughSlope(120, 90, 3);
  Grid<float> one = before;
  ErodeByDroplets(0.5, Drops(5000), 9, 1, &one);
  for (const int threads : {2, 3, 7}) {
    Grid<float> more = before;
    ErodeByDroplets(0.5, Drops(5000), 9, threads, &more);
    EXPECT_EQ(one, more) << threads;
  }
  Grid<float> other = before;
  ErodeByDroplets(0.5, Drops(5000), 10, 1, &other);
  EXPECT_NE(one, other);
}

TEST(ErosionDropletsTest, IsTheSameAtEveryScale) {
  // Twice the size in metres: twice the heights.
  Grid<float> small = RoughSlope(64, 64, 4);
  Grid<float> large = small;
  for (float& h : large) h *= 2.0f;
  ErodeByDroplets(1.0, Drops(1000), 2, 0, &small);
  ErodeByDroplets(2.0, Drops(1000), 2, 0, &large);
  for (std::size_t i = 0; i < small.size(); ++i) EXPECT_EQ(2.0f * small.data()[i], large.data()[i]);
}

TEST(ErosionDropletsTest, StaysFiniteOnAnyLand) {
  for (int seed = 0; seed < 30; ++seed) {
    RandomStream random(seed, "any land");
    Grid<float> height_m(random.UniformInt(1, 30), random.UniformInt(1, 30));
    const double relief_m = std::pow(10.0, random.Uniform(-6.0, 6.0));
    for (float& h : height_m) h = static_cast<float>(random.Uniform(0.0, relief_m));
    ErodeByDroplets(random.Uniform(0.1, 10.0), Drops(150), seed, 0, &height_m);
    for (const float h : height_m) ASSERT_TRUE(std::isfinite(h)) << "seed " << seed;
  }
  Grid<float> flat(20, 20, 3.0f);
  ErodeByDroplets(1.0, Drops(100), 1, 0, &flat);
  EXPECT_EQ(flat, Grid<float>(20, 20, 3.0f));
  Grid<float> none;
  ErodeByDroplets(1.0, Drops(100), 1, 0, &none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace latticeworld
