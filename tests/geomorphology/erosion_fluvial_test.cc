#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/flow.h"

namespace latticeworld {
namespace {

constexpr double kResolution_m = 50.0;

Grid<float> RoughLand(int rows, int cols, int seed, double relief_m) {
  Grid<float> height_m(rows, cols);
  RandomStream random(seed, "erosion_fluvial_test");
  for (float& h : height_m) h = static_cast<float>(random.Uniform(0.0, relief_m));
  return height_m;
}

// A plane that falls to the south, in balance with its uplift; water leaves over the southern edge.
struct SteadyLand {
  static constexpr int kSize = 64;
  static constexpr double kUplift_m_per_yr = 1e-3;
  SteadyLand(double area_exponent, int seed)
      : outlet(kSize, kSize), height_m(RoughLand(kSize, kSize, seed, 1.0)) {
    for (int r = 0; r < kSize; ++r) {
      for (int c = 0; c < kSize; ++c) height_m(r, c) += static_cast<float>(kSize - r);
    }
    std::fill(outlet.row(kSize - 1), outlet.row(kSize - 1) + kSize, 1);
    std::fill(height_m.row(kSize - 1), height_m.row(kSize - 1) + kSize, 0.0f);
    const Grid<float> uplift(kSize, kSize, static_cast<float>(kUplift_m_per_yr));
    options.area_exponent = area_exponent;
    // Such that all have about the same relief.
    options.erodibility = 1e-5 * std::pow(1e5, 0.5 - area_exponent);
    // Long steps reach the balance, short ones let the divides come to rest.
    for (const auto& [steps, time_step_yr] : {std::pair{200, 5e4}, {200, 5e3}, {400, 500.0}}) {
      options.steps = steps;
      options.time_step_yr = time_step_yr;
      ErodeFluvially(kResolution_m, options, &outlet, &uplift, nullptr, 0, &height_m);
    }
  }
  FluvialOptions options;
  Grid<unsigned char> outlet;
  Grid<float> height_m;
};

// Least squares of y on x.
double SlopeOf(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(ErosionFluvialTest, ReachesTheSteadyStateOfStreamPower) {
  for (const double m : {0.4, 0.5, 0.6}) {
    const SteadyLand land(m, 3);
    const FlowGraph flow = RouteFlow(land.height_m, &land.outlet);
    const Grid<float> area = FlowAccumulation(flow, nullptr);
    std::vector<double> log_area;
    std::vector<double> log_slope;
    std::size_t off_balance = 0;
    for (int cell = 0; cell < flow.rows * flow.cols; ++cell) {
      const int below = flow.receiver[cell];
      if (below == cell) continue;
      const int step = std::abs(cell - below);
      const double distance_m =
          kResolution_m * (step == 1 || step == flow.cols ? 1.0 : std::sqrt(2.0));
      const double slope = (land.height_m.data()[cell] - land.height_m.data()[below]) / distance_m;
      ASSERT_GT(slope, 0.0);
      const double area_m2 = area.data()[cell] * kResolution_m * kResolution_m;
      const double expected =
          SteadyLand::kUplift_m_per_yr / land.options.erodibility * std::pow(area_m2, -m);
      // A few divides keep moving to and fro; channels do not.
      const double error = std::abs(slope / expected - 1.0);
      if (area.data()[cell] >= 50.0f) {
        EXPECT_LT(error, 0.05) << "m " << m;
      }
      off_balance += error > 0.02;
      log_area.push_back(std::log(area_m2));
      log_slope.push_back(std::log(slope));
    }
    EXPECT_LT(off_balance, log_area.size() / 12) << "m " << m;
    EXPECT_NEAR(SlopeOf(log_area, log_slope), -m, 0.005);
  }
}

TEST(ErosionFluvialTest, WithoutUpliftNothingRisesAndOutletsStay) {
  for (int seed = 0; seed < 30; ++seed) {
    RandomStream random(seed, "sizes");
    const int rows = random.UniformInt(1, 50);
    const int cols = random.UniformInt(1, 50);
    const Grid<float> before = RoughLand(rows, cols, seed, 40.0);
    Grid<unsigned char> outlet(rows, cols);
    outlet(random.UniformInt(0, rows - 1), random.UniformInt(0, cols - 1)) = 1;
    const Grid<unsigned char>* given = random.Chance(0.5) ? &outlet : nullptr;
    Grid<float> after = before;
    FluvialOptions options;
    options.time_step_yr = random.Uniform(1.0, 1e7);
    options.area_exponent = random.Uniform(0.1, 1.0);
    ErodeFluvially(kResolution_m, options, given, nullptr, nullptr, 0, &after);
    const float lowest = *std::min_element(before.begin(), before.end());
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < cols; ++c) {
        EXPECT_LE(after(r, c), before(r, c)) << "seed " << seed;
        EXPECT_GE(after(r, c), lowest) << "seed " << seed;
        const bool leaves = given != nullptr ? outlet(r, c) != 0
                                             : r == 0 || c == 0 || r == rows - 1 || c == cols - 1;
        if (leaves) {
          EXPECT_EQ(after(r, c), before(r, c));
        }
      }
    }
  }
}

TEST(ErosionFluvialTest, DrainsDepressions) {
  Grid<float> height_m = RoughLand(64, 64, 5, 30.0);
  for (int i = 0; i < 64; ++i) {
    height_m(0, i) = height_m(63, i) = height_m(i, 0) = height_m(i, 63) = 0.0f;
  }
  ASSERT_NE(FillDepressions(height_m, nullptr), height_m);
  FluvialOptions options;
  options.steps = 60;
  options.time_step_yr = 1e5;
  ErodeFluvially(kResolution_m, options, nullptr, nullptr, nullptr, 0, &height_m);
  EXPECT_EQ(FillDepressions(height_m, nullptr), height_m);
}

TEST(ErosionFluvialTest, AStepOfAnyLengthIsStable) {
  const Grid<float> uplift(32, 32, 1e-3f);
  for (const double time_step_yr : {1e-3, 1.0, 1e4, 1e9, 1e15}) {
    Grid<float> height_m = RoughLand(32, 32, 9, 500.0);
    FluvialOptions options;
    options.time_step_yr = time_step_yr;
    ErodeFluvially(kResolution_m, options, nullptr, &uplift, nullptr, 0, &height_m);
    for (const float h : height_m) ASSERT_TRUE(std::isfinite(h)) << time_step_yr;
  }
}

TEST(ErosionFluvialTest, HardRockStandsOut) {
  Grid<float> height_m = RoughLand(64, 64, 2, 1.0);
  const Grid<float> uplift(64, 64, 1e-3f);
  Grid<float> factor(64, 64, 1.0f);
  for (int r = 0; r < 64; ++r) std::fill(factor.row(r), factor.row(r) + 32, 0.25f);
  FluvialOptions options;
  options.steps = 100;
  ErodeFluvially(kResolution_m, options, nullptr, &uplift, &factor, 0, &height_m);
  double hard_m = 0.0;
  double soft_m = 0.0;
  for (int r = 0; r < 64; ++r) {
    for (int c = 0; c < 32; ++c) hard_m += height_m(r, c), soft_m += height_m(r, 63 - c);
  }
  EXPECT_GT(hard_m, 2.0 * soft_m);
}

TEST(ErosionFluvialTest, CreepRaisesAParabolaBetweenTwoRivers) {
  // In balance, uplift between two outlets L apart stands U / (2 D) * x * (L - x) high.
  constexpr int kLength = 41;
  constexpr double kDiffusivity = 0.02;
  constexpr double kUplift_m_per_yr = 1e-4;
  for (const bool along_rows : {true, false}) {
    Grid<float> height_m(along_rows ? 9 : kLength, along_rows ? kLength : 9);
    Grid<unsigned char> outlet(height_m.rows(), height_m.cols());
    for (int i = 0; i < 9; ++i) {
      for (const int x : {0, kLength - 1}) outlet(along_rows ? i : x, along_rows ? x : i) = 1;
    }
    const Grid<float> uplift(height_m.rows(), height_m.cols(),
                             static_cast<float>(kUplift_m_per_yr));
    FluvialOptions options;
    options.steps = 400;
    options.time_step_yr = 2e4;
    options.erodibility = 1e-30;
    options.diffusivity_m2_per_yr = kDiffusivity;
    ErodeFluvially(5.0, options, &outlet, &uplift, nullptr, 0, &height_m);
    for (int x = 0; x < kLength; ++x) {
      const double expected_m =
          kUplift_m_per_yr / (2.0 * kDiffusivity) * (5.0 * x) * (5.0 * (kLength - 1 - x));
      EXPECT_NEAR(height_m(along_rows ? 4 : x, along_rows ? x : 4), expected_m,
                  0.01 * expected_m + 1e-3);
    }
  }
}

TEST(ErosionFluvialTest, TakesGridsOfOneCellAndOfNone) {
  Grid<float> one(1, 1, 4.0f);
  ErodeFluvially(1.0, {}, nullptr, nullptr, nullptr, 0, &one);
  EXPECT_EQ(one(0, 0), 4.0f);
  Grid<float> none;
  ErodeFluvially(1.0, {}, nullptr, nullptr, nullptr, 0, &none);
  EXPECT_TRUE(none.empty());
  Grid<float> flat(20, 30, 2.0f);
  ErodeFluvially(1.0, {}, nullptr, nullptr, nullptr, 0, &flat);
  EXPECT_EQ(flat, Grid<float>(20, 30, 2.0f));
}

TEST(ErosionFluvialTest, IsTheSameWithAnyNumberOfThreads) {
  const Grid<float> before = RoughLand(300, 431, 4, 80.0);
  Grid<float> factor = RoughLand(300, 431, 5, 2.0);
  const Grid<float> uplift(300, 431, 1e-3f);
  Grid<unsigned char> middle(300, 431);
  middle(140, 222) = 1;
  FluvialOptions options;
  options.steps = 4;
  options.diffusivity_m2_per_yr = 0.01;
  for (const Grid<unsigned char>* outlet : {static_cast<const Grid<unsigned char>*>(nullptr),
                                            static_cast<const Grid<unsigned char>*>(&middle)}) {
    Grid<float> one = before;
    ErodeFluvially(kResolution_m, options, outlet, &uplift, &factor, 1, &one);
    for (const int threads : {2, 3, 7}) {
      Grid<float> more = before;
      ErodeFluvially(kResolution_m, options, outlet, &uplift, &factor, threads, &more);
      EXPECT_EQ(one, more) << threads;
    }
  }
}

}  // namespace
}  // namespace latticeworld
