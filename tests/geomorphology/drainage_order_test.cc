#include "latticeworld/geomorphology/drainage_order.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld::internal {
namespace {

// Rough land, on every second seed tilted, so that water goes far through many bands.
Grid<float> RoughLand(int seed) {
  RandomStream random(seed, "drainage_order_test");
  Grid<float> height_m(random.UniformInt(1, 40), random.UniformInt(1, 40));
  const double tilt = seed % 2 == 0 ? 0.0 : random.Uniform(-2.0, 2.0);
  for (int r = 0; r < height_m.rows(); ++r) {
    for (int c = 0; c < height_m.cols(); ++c) {
      height_m(r, c) = static_cast<float>(random.Uniform() + tilt * r);
    }
  }
  return height_m;
}

// By walking from every cell all the way down.
std::vector<std::int32_t> CountByWalking(const Drainage& drainage) {
  std::vector<std::int32_t> area(drainage.directions().size(), 0);
  for (std::size_t i = 0; i < area.size(); ++i) {
    auto cell = static_cast<std::int32_t>(i);
    ++area[cell];
    while (drainage.directions()[cell] != kOutlet) {
      cell += drainage.steps()[drainage.directions()[cell]];
      ++area[cell];
    }
  }
  return area;
}

TEST(DrainageOrderTest, CountsWhatDrainsThroughEveryCellForAnyBands) {
  for (int seed = 0; seed < 100; ++seed) {
    const Grid<float> height_m = RoughLand(seed);
    Drainage drainage(height_m.rows(), height_m.cols());
    drainage.Route(height_m, nullptr, 1);
    const std::vector<std::int32_t> expected = CountByWalking(drainage);
    for (const int band_rows : {1, 2, 3, 7, 100}) {
      DrainageOrder order(height_m.rows(), height_m.cols(), band_rows);
      order.Sort(drainage, 1);
      EXPECT_EQ(order.area_cells(), expected) << "seed " << seed << ", bands of " << band_rows;
      order.Sort(drainage, 3);  // again, with what the first left behind
      EXPECT_EQ(order.area_cells(), expected) << "seed " << seed << ", bands of " << band_rows;
    }
  }
}

TEST(DrainageOrderTest, VisitsEveryCellOnceAndItsReceiverBefore) {
  for (int seed = 0; seed < 100; ++seed) {
    const Grid<float> height_m = RoughLand(seed);
    Drainage drainage(height_m.rows(), height_m.cols());
    drainage.Route(height_m, nullptr, 1);
    for (const int band_rows : {1, 2, 3, 7, 100}) {
      DrainageOrder order(height_m.rows(), height_m.cols(), band_rows);
      order.Sort(drainage, 1);
      for (const int threads : {1, 3}) {
        std::vector<int> visits(height_m.size(), 0);
        std::vector<char> came_too_early(height_m.size(), 0);
        order.ForEachDownstreamFirst(threads, [&](std::int32_t cell) {
          ++visits[cell];
          const std::uint8_t direction = drainage.directions()[cell];
          if (direction == kOutlet) return;
          came_too_early[cell] = visits[cell + drainage.steps()[direction]] != 1;
        });
        EXPECT_EQ(visits, std::vector<int>(height_m.size(), 1));
        EXPECT_EQ(came_too_early, std::vector<char>(height_m.size(), 0));
      }
    }
  }
}

TEST(DrainageOrderTest, TakesEmptyGrids) {
  const Drainage drainage(0, 0);
  DrainageOrder order(0, 0);
  order.Sort(drainage, 2);
  order.ForEachDownstreamFirst(2, [](std::int32_t) { FAIL() << "no cells to visit"; });
}

}  // namespace
}  // namespace latticeworld::internal
