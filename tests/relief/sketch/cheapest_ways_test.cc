#include "latticeworld/relief/sketch/cheapest_ways.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld::internal {
namespace {

constexpr int kSide = 24;

Grid<std::int32_t> RandomCosts(std::uint64_t seed) {
  RandomStream random(seed, "costs");
  Grid<std::int32_t> cost(kSide, kSide);
  for (std::int32_t& value : cost) value = random.Chance(0.1) ? 8000 : random.UniformInt(1, 400);
  return cost;
}

std::int32_t StepPrice(const Grid<std::int32_t>& cost, int a, int b) {
  const bool diagonal = a / kSide != b / kSide && a % kSide != b % kSide;
  const auto both = static_cast<float>(cost.data()[a] + cost.data()[b]);
  return static_cast<std::int32_t>((diagonal ? 0.70710678f : 0.5f) * both);
}

// What the way that was found costs from each cell; also checks that it is a way, in order.
std::vector<std::int32_t> PricesAlong(const Ways& ways, const Grid<std::int32_t>& cost,
                                      const std::vector<std::int32_t>& start) {
  std::vector<std::int32_t> price(cost.size(), kNever);
  EXPECT_EQ(ways.order.size(), cost.size());
  for (const std::int32_t cell : ways.order) {
    const std::int32_t receiver = ways.receiver[cell];
    if (receiver == cell) {
      price[cell] = start[cell];
      continue;
    }
    EXPECT_LE(std::abs(cell / kSide - receiver / kSide), 1);
    EXPECT_LE(std::abs(cell % kSide - receiver % kSide), 1);
    EXPECT_NE(price[receiver], kNever) << "a cell stands before its receiver";
    price[cell] = price[receiver] + StepPrice(cost, cell, receiver);
  }
  return price;
}

TEST(CheapestWaysTest, FindsWhatNoStepCanMakeCheaper) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Grid<std::int32_t> cost = RandomCosts(seed);
    std::vector<std::int32_t> start(cost.size(), kNever);
    start[5] = 0;
    start[kSide * 20 + 3] = 900;
    const Ways ways = CheapestWays(cost, Grid<std::int32_t>(kSide, kSide, 0), start);
    const std::vector<std::int32_t> price = PricesAlong(ways, cost, start);
    for (int r = 0; r < kSide; ++r) {
      for (int c = 0; c < kSide; ++c) {
        EXPECT_LE(price[r * kSide + c], start[r * kSide + c]);
        for (int i = 0; i < 9; ++i) {
          const CellIndex n{r + i / 3 - 1, c + i % 3 - 1};
          if (!cost.Contains(n) || i == 4) continue;
          const int from = n.row * kSide + n.col;
          EXPECT_LE(price[r * kSide + c], price[from] + StepPrice(cost, r * kSide + c, from));
        }
      }
    }
  }
}

TEST(CheapestWaysTest, LeavesEachPartByOneWay) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Grid<std::int32_t> cost = RandomCosts(seed);
    Grid<std::int32_t> part(kSide, kSide, 0);
    for (int c = 2; c < 22; ++c) {
      part(6, c) = 1;
      part(15, c) = part(16, c) = 2;
    }
    std::vector<std::int32_t> start(cost.size(), kNever);
    for (int c = 0; c < kSide; ++c) start[c] = start[(kSide - 1) * kSide + c] = 0;
    const Ways ways = CheapestWays(cost, part, start);
    PricesAlong(ways, cost, start);
    int exits[3] = {0, 0, 0};
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::int32_t here = part.data()[i];
      exits[here] += here != 0 && part.data()[ways.receiver[i]] != here;
    }
    EXPECT_EQ(exits[1], 1) << seed;
    EXPECT_EQ(exits[2], 1) << seed;
  }
}

}  // namespace
}  // namespace latticeworld::internal
