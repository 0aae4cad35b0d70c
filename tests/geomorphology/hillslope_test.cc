#include "latticeworld/geomorphology/hillslope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/drainage.h"

namespace latticeworld::internal {
namespace {

struct Land {
  explicit Land(int seed) : random(seed, "hillslope_test") {
    height_m = Grid<float>(random.UniformInt(1, 50), random.UniformInt(1, 50));
    for (float& h : height_m) h = static_cast<float>(random.Uniform(10.0, 50.0));
    directions.assign(height_m.size(), 0);
    number = std::pow(10.0, random.Uniform(-3.0, 6.0));
  }
  RandomStream random;
  Grid<float> height_m;
  std::vector<std::uint8_t> directions;
  double number = 0.0;
};

TEST(HillslopeTest, ConservesSoilAndNeverOvershoots) {
  for (int seed = 0; seed < 50; ++seed) {
    Land land(seed);
    const auto [low, high] = std::minmax_element(land.height_m.begin(), land.height_m.end());
    const float lowest = *low;
    const float highest = *high;
    const double before = std::accumulate(land.height_m.begin(), land.height_m.end(), 0.0);
    Diffuse(land.number, land.directions, seed % 2 == 0, 0, &land.height_m);
    const double after = std::accumulate(land.height_m.begin(), land.height_m.end(), 0.0);
    EXPECT_NEAR(after, before, 1e-4 * before) << "seed " << seed << " number " << land.number;
    for (const float h : land.height_m) {
      EXPECT_GE(h, lowest * 0.9999f);
      EXPECT_LE(h, highest * 1.0001f);
    }
  }
}

TEST(HillslopeTest, SpreadsAHeapAsDiffusionDoes) {
  // The variance of a heap along each axis grows by 2 * number a step.
  Grid<float> height_m(101, 101);
  height_m(50, 50) = 1000.0f;
  const std::vector<std::uint8_t> directions(height_m.size(), 0);
  for (int step = 0; step < 50; ++step) Diffuse(0.5, directions, step % 2 == 0, 0, &height_m);
  double mass = 0.0;
  double along_rows = 0.0;
  double along_cols = 0.0;
  for (int r = 0; r < 101; ++r) {
    for (int c = 0; c < 101; ++c) {
      mass += height_m(r, c);
      along_rows += height_m(r, c) * (c - 50) * (c - 50);
      along_cols += height_m(r, c) * (r - 50) * (r - 50);
    }
  }
  EXPECT_NEAR(along_rows / mass, 50.0, 0.1);
  EXPECT_NEAR(along_cols / mass, 50.0, 0.1);
}

TEST(HillslopeTest, OutletsStayAndHoldWhatIsAroundThem) {
  for (int seed = 0; seed < 20; ++seed) {
    Land land(seed);
    const Grid<float> before = land.height_m;
    for (auto& direction : land.directions) {
      if (land.random.Chance(0.1)) direction = kOutlet;
    }
    Diffuse(land.number, land.directions, true, 0, &land.height_m);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (land.directions[i] == kOutlet) {
        EXPECT_EQ(land.height_m.data()[i], before.data()[i]);
      }
    }
  }
  // With a step without end, land between two outlets is the straight line between them.
  Grid<float> line(1, 11, 77.0f);
  std::vector<std::uint8_t> directions(11, 0);
  directions.front() = directions.back() = kOutlet;
  line(0, 0) = 0.0f;
  line(0, 10) = 20.0f;
  Diffuse(1e9, directions, true, 0, &line);
  for (int c = 0; c < 11; ++c) EXPECT_NEAR(line(0, c), 2.0f * static_cast<float>(c), 1e-3);
}

TEST(HillslopeTest, IsTheSameWithAnyNumberOfThreads) {
  for (int seed = 0; seed < 20; ++seed) {
    const Land land(seed);
    Grid<float> one = land.height_m;
    Diffuse(land.number, land.directions, true, 1, &one);
    for (const int threads : {2, 3, 7}) {
      Grid<float> more = land.height_m;
      Diffuse(land.number, land.directions, true, threads, &more);
      EXPECT_EQ(one, more);
    }
  }
}

}  // namespace
}  // namespace latticeworld::internal
