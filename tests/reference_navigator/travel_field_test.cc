#include "latticeworld/reference_navigator/travel_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr int kCells = 40;

Grid<float> RandomPrices(std::uint64_t seed) {
  RandomStream random(seed, "prices");
  Grid<float> prices(kCells, kCells);
  for (float& price : prices)
    price = random.Chance(0.3) ? kClosedCell : static_cast<float>(random.Uniform(1.0, 4.0));
  prices(0, 0) = 1.0f;
  return prices;
}

// Bellman's and Ford's sweeps, written from the definition.
Grid<float> Costs(const Grid<float>& prices) {
  Grid<float> cost(kCells, kCells, std::numeric_limits<float>::infinity());
  cost(0, 0) = 0.0f;
  const auto open = [&](int row, int col) {
    return prices.Contains({row, col}) && prices(row, col) != kClosedCell;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int row = 0; row < kCells; ++row) {
      for (int col = 0; col < kCells; ++col) {
        if (!open(row, col)) continue;
        for (int r = -1; r <= 1; ++r) {
          for (int c = -1; c <= 1; ++c) {
            if ((r == 0 && c == 0) || !open(row + r, col + c)) continue;
            if (r != 0 && c != 0 && (!open(row + r, col) || !open(row, col + c))) continue;
            const float step = 0.25f * std::hypot(static_cast<float>(r), static_cast<float>(c)) *
                               (prices(row, col) + prices(row + r, col + c));
            if (cost(row + r, col + c) + step < cost(row, col) - 1e-5f) {
              cost(row, col) = cost(row + r, col + c) + step;
              changed = true;
            }
          }
        }
      }
    }
  }
  return cost;
}

TEST(TravelFieldTest, IsWhatEveryStepTogetherCosts) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Grid<float> prices = RandomPrices(seed);
    const TravelField field = SpreadFrom({{{0, 0}, 0.0f}}, prices, 0.5);
    const Grid<float> wanted = Costs(prices);
    for (int row = 0; row < kCells; ++row) {
      for (int col = 0; col < kCells; ++col) {
        if (std::isinf(wanted(row, col))) {
          EXPECT_TRUE(std::isinf(field.cost_m(row, col)));
        } else {
          EXPECT_NEAR(field.cost_m(row, col), wanted(row, col), 1e-2);
        }
      }
    }
  }
}

TEST(TravelFieldTest, WaysGoDownOverOpenCellsToTheSeed) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Grid<float> prices = RandomPrices(seed);
    const TravelField field = SpreadFrom({{{0, 0}, 0.0f}}, prices, 0.5);
    for (int cell = 0; cell < kCells * kCells; cell += 7) {
      const CellIndex start{cell / kCells, cell % kCells};
      const std::vector<CellIndex> way = Descend(field, prices, start);
      EXPECT_EQ(way.empty(), std::isinf(field.cost_m[start]));
      if (way.empty()) continue;
      EXPECT_EQ(way.back(), (CellIndex{0, 0}));
      for (std::size_t i = 1; i < way.size(); ++i) {
        EXPECT_NE(prices[way[i]], kClosedCell);
        EXPECT_LT(field.cost_m[way[i]], field.cost_m[way[i - 1]]);
      }
    }
  }
}

TEST(TravelFieldTest, PulledStraightAWayStaysOpenAndGetsNoLonger) {
  const auto length = [](const std::vector<CellIndex>& way) {
    double sum = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i)
      sum += std::hypot(way[i].row - way[i - 1].row, way[i].col - way[i - 1].col);
    return sum;
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Grid<float> prices = RandomPrices(seed);
    for (float& price : prices) price = price == kClosedCell ? kClosedCell : 1.0f;
    const TravelField field = SpreadFrom({{{0, 0}, 0.0f}}, prices, 0.5);
    for (int cell = 0; cell < kCells * kCells; cell += 41) {
      const CellIndex start{cell / kCells, cell % kCells};
      const std::vector<CellIndex> way = Descend(field, prices, start);
      const std::vector<CellIndex> pulled = PulledStraight(way, prices);
      if (way.empty()) continue;
      EXPECT_EQ(pulled.front(), way.front());
      EXPECT_EQ(pulled.back(), way.back());
      EXPECT_LE(length(pulled), length(way) + 1e-9);
      for (std::size_t i = 1; i < pulled.size(); ++i)
        EXPECT_TRUE(IsStraightOpen(prices, pulled[i - 1], pulled[i], 1.0f));
    }
  }
}

TEST(TravelFieldTest, ALineTouchesNoClosedCellAtACorner) {
  Grid<float> prices(4, 4, 1.0f);
  EXPECT_TRUE(IsStraightOpen(prices, {0, 0}, {3, 3}, 1.0f));
  prices(1, 0) = kClosedCell;
  EXPECT_FALSE(IsStraightOpen(prices, {0, 0}, {3, 3}, 1.0f));
  EXPECT_TRUE(IsStraightOpen(prices, {0, 0}, {0, 3}, 1.0f));
  prices(0, 2) = 3.0f;
  EXPECT_FALSE(IsStraightOpen(prices, {0, 0}, {0, 3}, 2.0f));
}

}  // namespace
}  // namespace latticeworld
