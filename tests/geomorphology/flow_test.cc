#include "latticeworld/geomorphology/flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

// The textbook's priority flood (Barnes, Lehman and Mulla 2014, algorithm 1).
Grid<float> FillByPriorityFlood(const Grid<float>& height_m, const Grid<unsigned char>& outlet) {
  Grid<float> filled(height_m.rows(), height_m.cols(), std::numeric_limits<float>::infinity());
  using Entry = std::pair<float, std::pair<int, int>>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  const auto reach = [&](int r, int c, float level_m) {
    if (filled(r, c) <= std::max(level_m, height_m(r, c))) return;
    filled(r, c) = std::max(level_m, height_m(r, c));
    open.push({filled(r, c), {r, c}});
  };
  for (int r = 0; r < height_m.rows(); ++r) {
    for (int c = 0; c < height_m.cols(); ++c) {
      if (outlet(r, c) != 0) reach(r, c, height_m(r, c));
    }
  }
  while (!open.empty()) {
    const auto [level_m, cell] = open.top();
    open.pop();
    for (int r = cell.first - 1; r <= cell.first + 1; ++r) {
      for (int c = cell.second - 1; c <= cell.second + 1; ++c) {
        if (height_m.Contains({r, c})) reach(r, c, level_m);
      }
    }
  }
  return filled;
}

Grid<unsigned char> BorderOf(int rows, int cols) {
  Grid<unsigned char> border(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      border(r, c) = r == 0 || c == 0 || r == rows - 1 || c == cols - 1;
    }
  }
  return border;
}

// Rough land; land of few heights, so that much of it is level; a plane with a few holes.
struct Land {
  explicit Land(int seed) {
    RandomStream random(seed, "flow_test");
    const int rows = random.UniformInt(1, 40);
    const int cols = random.UniformInt(1, 40);
    height_m = Grid<float>(rows, cols);
    const int heights = seed % 3 == 0 ? random.UniformInt(1, 6) : 1 << 20;
    for (float& h : height_m) h = static_cast<float>(random.UniformInt(0, heights)) - 3.0f;
    if (seed % 3 == 1) {
      for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < cols; ++c) {
          height_m(r, c) =
              static_cast<float>(random.Chance(0.01) ? random.UniformInt(-9, 9) : r + c);
        }
      }
    }
    outlet = BorderOf(rows, cols);
    at_border = random.Chance(0.4);
    if (!at_border) {
      outlet = Grid<unsigned char>(rows, cols);
      const int count = random.UniformInt(1, 4);
      for (int i = 0; i < count; ++i) {
        outlet(random.UniformInt(0, rows - 1), random.UniformInt(0, cols - 1)) = 1;
      }
    }
  }
  const Grid<unsigned char>* given() const { return at_border ? nullptr : &outlet; }
  Grid<float> height_m;
  Grid<unsigned char> outlet;
  bool at_border = false;
};

bool AreNeighbours(const FlowGraph& flow, int a, int b) {
  return std::abs(a / flow.cols - b / flow.cols) <= 1 &&
         std::abs(a % flow.cols - b % flow.cols) <= 1;
}

TEST(FlowTest, FillsAsPriorityFloodDoes) {
  for (int seed = 0; seed < 400; ++seed) {
    const Land land(seed);
    EXPECT_EQ(FillDepressions(land.height_m, land.given()),
              FillByPriorityFlood(land.height_m, land.outlet))
        << "seed " << seed;
  }
}

TEST(FlowTest, FillsTheEndOfAGorgeToItsOnlySaddleWhereverThatLies) {
  // A gorge a cell wide through high land falls to the border, but ends in a hole.
  for (const bool eastward : {true, false}) {
    for (int hole = 2; hole < 39; ++hole) {
      Grid<float> height_m(9, 41, 50.0f);
      const auto in_gorge = [&](int from_border) -> float& {
        return height_m(4, eastward ? 40 - from_border : from_border);
      };
      for (int i = 0; i < hole; ++i) in_gorge(i) = 0.1f * static_cast<float>(i);
      Grid<float> expected = height_m;
      expected(4, eastward ? 40 - hole : hole) = in_gorge(hole - 1);
      in_gorge(hole) = -100.0f;
      EXPECT_EQ(FillDepressions(height_m, nullptr), expected) << hole << " from the border";
    }
  }
}

TEST(FlowTest, EveryCellDrainsToAnOutletThroughNeighbours) {
  for (int seed = 0; seed < 400; ++seed) {
    const Land land(seed);
    const FlowGraph flow = RouteFlow(land.height_m, land.given());
    const int count = static_cast<int>(land.height_m.size());
    ASSERT_EQ(flow.receiver.size(), land.height_m.size());
    for (int cell = 0; cell < count; ++cell) {
      ASSERT_TRUE(AreNeighbours(flow, cell, flow.receiver[cell]));
      ASSERT_EQ(flow.receiver[cell] == cell, land.outlet.data()[cell] != 0) << "seed " << seed;
      int at = cell;
      for (int i = 0; i < count && flow.receiver[at] != at; ++i) at = flow.receiver[at];
      ASSERT_NE(land.outlet.data()[at], 0) << "seed " << seed;
    }
  }
}

TEST(FlowTest, NoWayRisesAboveTheSpillLevel) {
  for (int seed = 0; seed < 400; ++seed) {
    const Land land(seed);
    const FlowGraph flow = RouteFlow(land.height_m, land.given());
    const Grid<float> filled = FillDepressions(land.height_m, land.given());
    for (std::size_t cell = 0; cell < filled.size(); ++cell) {
      ASSERT_LE(filled.data()[flow.receiver[cell]], filled.data()[cell]) << "seed " << seed;
    }
  }
}

TEST(FlowTest, GoesDownTheSteepestSlope) {
  Grid<float> height_m(3, 3);
  // Two down over a diagonal is less steep than one and a half straight.
  const float rows[3][3] = {{3, 5, 5}, {5, 5, 3.5f}, {5, 5, 5}};
  for (int r = 0; r < 3; ++r) std::copy(rows[r], rows[r] + 3, height_m.row(r));
  EXPECT_EQ(RouteFlow(height_m, nullptr).receiver[4], 5);
  height_m(0, 0) = 2.5f;
  EXPECT_EQ(RouteFlow(height_m, nullptr).receiver[4], 0);
  // Equal slopes: the smaller index.
  height_m(0, 0) = 5.0f;
  height_m(1, 0) = 3.5f;
  EXPECT_EQ(RouteFlow(height_m, nullptr).receiver[4], 3);
}

TEST(FlowTest, GoesDownTheSteepestSlopeEverywhereOnOpenLand) {
  for (int seed = 0; seed < 50; ++seed) {
    // Bumps on a slope too steep for hollows, that falls to any of the four sides.
    RandomStream random(seed, "open land");
    Grid<float> height_m(23, 37);
    for (int r = 0; r < 23; ++r) {
      for (int c = 0; c < 37; ++c) {
        const int fall[4] = {r, -r, c, -c};
        height_m(r, c) = static_cast<float>(random.Uniform(0.0, 3.0) + 3.5 * fall[seed % 4]);
      }
    }
    const FlowGraph flow = RouteFlow(height_m, nullptr);
    for (int r = 1; r < 22; ++r) {
      for (int c = 1; c < 36; ++c) {
        const auto slope = [&](int to) {
          const bool diagonal = to / 37 != r && to % 37 != c;
          return (height_m(r, c) - height_m.data()[to]) / (diagonal ? std::sqrt(2.0) : 1.0);
        };
        const int receiver = flow.receiver[r * 37 + c];
        for (int to_r = r - 1; to_r <= r + 1; ++to_r) {
          for (int to_c = c - 1; to_c <= c + 1; ++to_c) {
            ASSERT_GE(slope(receiver), slope(to_r * 37 + to_c) - 1e-5) << "seed " << seed;
          }
        }
      }
    }
  }
}

TEST(FlowTest, OrderHoldsEveryCatchmentInOnePiece) {
  for (int seed = 0; seed < 200; ++seed) {
    const Land land(seed);
    const FlowGraph flow = RouteFlow(land.height_m, land.given());
    const Grid<float> area = FlowAccumulation(flow, nullptr);
    std::vector<int> place(flow.order.size(), -1);
    for (std::size_t i = 0; i < flow.order.size(); ++i) {
      ASSERT_EQ(place[flow.order[i]], -1);
      place[flow.order[i]] = static_cast<int>(i);
    }
    for (std::size_t cell = 0; cell < place.size(); ++cell) {
      const int receiver = flow.receiver[cell];
      if (receiver == static_cast<int>(cell)) continue;
      EXPECT_GT(place[cell], place[receiver]);
      EXPECT_LE(place[cell] + area.data()[cell], place[receiver] + area.data()[receiver]);
    }
  }
}

TEST(FlowTest, AccumulatesAllRainAtTheOutlets) {
  for (int seed = 0; seed < 100; ++seed) {
    const Land land(seed);
    const FlowGraph flow = RouteFlow(land.height_m, land.given());
    Grid<float> rain(flow.rows, flow.cols);
    RandomStream random(seed, "rain");
    int total = 0;
    for (float& cells : rain) {
      const int drops = random.UniformInt(0, 3);
      total += drops;
      cells = static_cast<float>(drops);
    }
    const Grid<float> area = FlowAccumulation(flow, nullptr);
    const Grid<float> water = FlowAccumulation(flow, &rain);
    float left = 0.0f;
    float cells = 0.0f;
    for (std::size_t cell = 0; cell < area.size(); ++cell) {
      EXPECT_GE(area.data()[cell], 1.0f);
      EXPECT_GE(water.data()[cell], rain.data()[cell]);
      if (flow.receiver[cell] != static_cast<int>(cell)) continue;
      left += water.data()[cell];
      cells += area.data()[cell];
    }
    EXPECT_EQ(left, static_cast<float>(total));
    EXPECT_EQ(cells, static_cast<float>(area.size()));
  }
}

TEST(FlowTest, LevelGroundDrainsTheShortestWay) {
  Grid<float> height_m(31, 31, 7.0f);
  Grid<unsigned char> outlet(31, 31);
  outlet(12, 20) = 1;
  const FlowGraph flow = RouteFlow(height_m, &outlet);
  for (int r = 0; r < 31; ++r) {
    for (int c = 0; c < 31; ++c) {
      int steps = 0;
      for (int at = r * 31 + c; flow.receiver[at] != at; at = flow.receiver[at]) ++steps;
      EXPECT_EQ(steps, std::max(std::abs(r - 12), std::abs(c - 20)));
    }
  }
}

TEST(FlowTest, ADepressionDrainsFromItsPitOverItsLowestSaddle) {
  // A pit of 1 within walls of 9, with gaps of 6 in the west and of 4 in the east.
  Grid<float> height_m(5, 7);
  const float rows[5][7] = {{0, 0, 0, 0, 0, 0, 0},
                            {0, 9, 9, 9, 9, 9, 0},
                            {0, 6, 3, 1, 2, 4, 0},
                            {0, 9, 9, 9, 9, 9, 0},
                            {0, 0, 0, 0, 0, 0, 0}};
  for (int r = 0; r < 5; ++r) std::copy(rows[r], rows[r] + 7, height_m.row(r));
  const FlowGraph flow = RouteFlow(height_m, nullptr);
  EXPECT_EQ(flow.receiver[2 * 7 + 2], 2 * 7 + 3);
  EXPECT_EQ(flow.receiver[2 * 7 + 3], 2 * 7 + 4);
  EXPECT_EQ(flow.receiver[2 * 7 + 4], 2 * 7 + 5);
  EXPECT_EQ(flow.receiver[2 * 7 + 5] % 7, 6);
  EXPECT_EQ(FillDepressions(height_m, nullptr)(2, 3), 4.0f);
}

TEST(FlowTest, IsTheSameWithAnyNumberOfThreads) {
  for (int seed = 0; seed < 50; ++seed) {
    const Land land(seed);
    const FlowGraph one = RouteFlow(land.height_m, land.given(), 1);
    for (const int threads : {2, 3, 7}) {
      const FlowGraph more = RouteFlow(land.height_m, land.given(), threads);
      ASSERT_EQ(one.receiver, more.receiver);
      ASSERT_EQ(one.order, more.order);
    }
  }
}

TEST(FlowTest, AnEmptyGridHasNoFlow) {
  EXPECT_TRUE(RouteFlow(Grid<float>(), nullptr).order.empty());
  EXPECT_TRUE(FillDepressions(Grid<float>(), nullptr).empty());
}

}  // namespace
}  // namespace latticeworld
