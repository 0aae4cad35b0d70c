#include "latticeworld/simulation/agents/ways/path_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

constexpr double kDiagonal = 1.4142;  // as the search counts

// A layer of one metre cells whose north-west corner is (0, 0).
PathLayer LayerOf(const Grid<std::uint8_t>& ease) {
  return PathLayer(ease.rows(), 1.0, {0.0, 0.0}, [ease](int row, int col, PathLayer::Tile* tile) {
    for (int r = 0; r < PathLayer::kTile; ++r) {
      for (int c = 0; c < PathLayer::kTile; ++c) {
        if (ease.Contains({row + r, col + c}))
          (*tile)[static_cast<std::size_t>(r * PathLayer::kTile + c)] = ease(row + r, col + c);
      }
    }
  });
}

Grid<std::uint8_t> FromText(const std::vector<std::string>& rows) {
  Grid<std::uint8_t> ease(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()));
  for (int r = 0; r < ease.rows(); ++r) {
    for (int c = 0; c < ease.cols(); ++c)
      ease(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] == '#' ? 0 : 255;
  }
  return ease;
}

Grid<std::uint8_t> RandomEase(int cells, double blocked, std::uint64_t seed) {
  RandomStream random(seed, "ease");
  Grid<std::uint8_t> ease(cells, cells);
  for (std::uint8_t& cell : ease)
    cell = random.Chance(blocked) ? 0 : static_cast<std::uint8_t>(random.UniformInt(1, 255));
  return ease;
}

// Steps of a way, or of all ways: no corner of a blocked cell is cut.
bool IsStep(const Grid<std::uint8_t>& ease, CellIndex a, CellIndex b) {
  if (!ease.Contains(a) || !ease.Contains(b) || ease[a] == 0 || ease[b] == 0) return false;
  const int rows = std::abs(a.row - b.row), cols = std::abs(a.col - b.col);
  if (std::max(rows, cols) != 1) return false;
  return rows + cols == 1 || (ease(a.row, b.col) != 0 && ease(b.row, a.col) != 0);
}

// What a way through a cell of that ease costs, times its length: 1 on level open ground to 1.5
// where it is as steep or wet as can be.
double HardshipOf(std::uint8_t ease) { return 1.0 + 0.5 * (255 - ease) / 254.0; }

double StepCost(const Grid<std::uint8_t>& ease, CellIndex a, CellIndex b) {
  const double length = a.row != b.row && a.col != b.col ? kDiagonal : 1.0;
  return 0.5 * length * (HardshipOf(ease[a]) + HardshipOf(ease[b]));
}

// Plain Dijkstra from one cell to all.
Grid<double> CostsFrom(const Grid<std::uint8_t>& ease, CellIndex from) {
  Grid<double> costs(ease.rows(), ease.cols(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::pair<int, int>>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  costs[from] = 0.0;
  open.push({0.0, {from.row, from.col}});
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    const CellIndex here{at.first, at.second};
    if (cost > costs[here]) continue;
    for (int row = here.row - 1; row <= here.row + 1; ++row) {
      for (int col = here.col - 1; col <= here.col + 1; ++col) {
        const CellIndex next{row, col};
        if (!IsStep(ease, here, next)) continue;
        const double there = cost + StepCost(ease, here, next);
        if (there >= costs[next]) continue;
        costs[next] = there;
        open.push({there, {row, col}});
      }
    }
  }
  return costs;
}

TEST(PathSearchTest, IsAsCheapAsDijkstraFindsIt) {
  PathSearch search;  // one for all: what it keeps must not matter
  int reached = 0, cut_off = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Grid<std::uint8_t> ease = RandomEase(40, 0.35, seed);
    PathLayer layer = LayerOf(ease);
    RandomStream random(seed, "ends");
    const CellIndex from{random.UniformInt(0, 39), random.UniformInt(0, 39)};
    const CellIndex to{random.UniformInt(0, 39), random.UniformInt(0, 39)};
    const CellPath path = search.Find(&layer, from, to, 100000);
    if (ease[from] == 0) {
      EXPECT_TRUE(path.cells.empty());
      continue;
    }
    const Grid<double> costs = CostsFrom(ease, from);
    ASSERT_FALSE(path.cells.empty());
    EXPECT_EQ(path.cells.front(), from);
    EXPECT_EQ(path.complete, std::isfinite(costs[to])) << "seed " << seed;
    (path.complete ? reached : cut_off) += 1;
    if (path.complete) {
      EXPECT_EQ(path.cells.back(), to);
    }
    EXPECT_NEAR(path.cost, costs[path.cells.back()], 1e-9) << "seed " << seed;
    double cost = 0.0;
    for (std::size_t i = 1; i < path.cells.size(); ++i) {
      ASSERT_TRUE(IsStep(ease, path.cells[i - 1], path.cells[i])) << "seed " << seed;
      cost += StepCost(ease, path.cells[i - 1], path.cells[i]);
    }
    EXPECT_NEAR(cost, path.cost, 1e-9);
  }
  EXPECT_GT(reached, 10);
  EXPECT_GT(cut_off, 5);
}

TEST(PathSearchTest, AGreedyOneCostsNoMoreThanItsShareAndLooksAtLess) {
  PathSearch search;
  long exact_expanded = 0, greedy_expanded = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PathLayer layer = LayerOf(RandomEase(64, 0.2, seed));
    const CellPath exact = search.Find(&layer, {3, 3}, {60, 58}, 100000);
    const CellPath greedy = search.Find(&layer, {3, 3}, {60, 58}, 100000, 125);
    EXPECT_EQ(exact.complete, greedy.complete);
    if (!exact.complete) continue;
    EXPECT_LE(greedy.cost, 1.25 * exact.cost + 1e-9) << "seed " << seed;
    exact_expanded += exact.expanded;
    greedy_expanded += greedy.expanded;
  }
  EXPECT_LT(2 * greedy_expanded, exact_expanded);
}

TEST(PathSearchTest, EndsNearestToAGoalThatNoWayLeadsTo) {
  PathLayer layer = LayerOf(FromText({"..........",  //
                                      "..........",  //
                                      "......####",  //
                                      "......#..#",  //
                                      "......#..#",  //
                                      "......####",  //
                                      "..........",  //
                                      "..........",  //
                                      "..........",  //
                                      ".........."}));
  PathSearch search;
  const CellPath path = search.Find(&layer, {9, 0}, {4, 7}, 1000);
  EXPECT_FALSE(path.complete);
  EXPECT_EQ(path.cells.back(), (CellIndex{4, 5}));
}

TEST(PathSearchTest, ExpandsNoMoreThanItMay) {
  PathLayer layer = LayerOf(Grid<std::uint8_t>(64, 64, 255));
  PathSearch search;
  const CellPath path = search.Find(&layer, {5, 5}, {60, 40}, 20);
  EXPECT_FALSE(path.complete);
  EXPECT_EQ(path.expanded, 20);
  // And yet it leads towards it.
  EXPECT_GT(path.cells.back().row, 15);
}

TEST(PathSearchTest, OverOpenGroundItLooksAtLittleMoreThanTheWay) {
  PathLayer layer = LayerOf(Grid<std::uint8_t>(512, 512, 255));
  PathSearch search;
  const CellPath path = search.Find(&layer, {10, 10}, {400, 500}, 100000);
  EXPECT_TRUE(path.complete);
  EXPECT_LE(path.expanded, 2 * static_cast<int>(path.cells.size()));
}

TEST(PathSearchTest, GoesAroundHardGroundWhenThatIsCheaper) {
  Grid<std::uint8_t> ease(9, 9, 255);
  for (int row = 1; row < 8; ++row) ease(row, 4) = 1;
  PathLayer layer = LayerOf(ease);
  PathSearch search;
  // Straight through costs a cell's width at 1.5; around the end of the strip it is longer.
  EXPECT_NEAR(search.Find(&layer, {4, 3}, {4, 5}, 1000).cost, 2.0 + 0.5, 1e-9);
  // Where the strip is walked along, stepping aside pays.
  const CellPath along = search.Find(&layer, {1, 4}, {7, 4}, 1000);
  EXPECT_NE(along.cells[3].col, 4);
}

TEST(PathSearchTest, SameQuestionSameWayWhateverWasAskedBefore) {
  const Grid<std::uint8_t> ease = RandomEase(96, 0.25, 5);
  PathLayer fresh_layer = LayerOf(ease), used_layer = LayerOf(ease);
  PathSearch fresh, used;
  for (int i = 0; i < 30; ++i) used.Find(&used_layer, {i, 95 - i}, {95 - 2 * i, i}, 20000);
  CellIndex from{2, 2};
  while (ease[from] == 0) ++from.col;
  const CellPath a = fresh.Find(&fresh_layer, from, {90, 93}, 20000);
  const CellPath b = used.Find(&used_layer, from, {90, 93}, 20000);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.cost, b.cost);
}

bool IsLineFree(PathLayer* layer, WorldPoint from, WorldPoint to) {
  double left = 0.0;
  return layer->IsLineFree(from, to, 0.0, &left);
}

TEST(PathLayerTest, ALineIsFreeWhereAllThatItTouchesIs) {
  PathLayer layer = LayerOf(FromText({".....",  //
                                      ".#...",  //
                                      ".....",  //
                                      "...#.",  //
                                      "....."}));
  EXPECT_TRUE(IsLineFree(&layer, {0.5, -0.5}, {4.5, -0.5}));
  EXPECT_FALSE(IsLineFree(&layer, {0.5, -1.5}, {4.5, -1.5}));
  EXPECT_FALSE(IsLineFree(&layer, {0.5, -0.5}, {4.5, -4.5}));
  // A hair's breadth of the blocked cell is enough.
  EXPECT_FALSE(IsLineFree(&layer, {0.1, -1.7}, {2.9, -2.1}));
  EXPECT_TRUE(IsLineFree(&layer, {0.1, -2.1}, {2.9, -2.1}));
  // Through the corner that two blocked cells do not share with the way, but touch it.
  EXPECT_FALSE(IsLineFree(&layer, {0.5, -2.5}, {2.5, -0.5}));
  // Beyond the map nothing is free.
  EXPECT_FALSE(IsLineFree(&layer, {0.5, -0.5}, {5.5, -0.5}));
  EXPECT_FALSE(IsLineFree(&layer, {-0.5, -0.5}, {0.5, -0.5}));
}

TEST(PathLayerTest, LinesAgreeWithFineSamplesOfThem) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Grid<std::uint8_t> ease = RandomEase(33, 0.05, seed);
    PathLayer layer = LayerOf(ease);
    RandomStream random(seed, "lines");
    int samples_free = 0, agreed = 0;
    for (int i = 0; i < 50; ++i) {
      const WorldPoint from{random.Uniform(0.0, 33.0), random.Uniform(-33.0, 0.0)};
      const WorldPoint to{random.Uniform(0.0, 33.0), random.Uniform(-33.0, 0.0)};
      bool free = true;
      constexpr int kSamples = 4000;
      for (int s = 0; s <= kSamples; ++s) {
        const double share = static_cast<double>(s) / kSamples;
        free = free && layer.IsFree(layer.CellAt({from.x_m + share * (to.x_m - from.x_m),
                                                  from.y_m + share * (to.y_m - from.y_m)}));
      }
      // Samples may miss a corner that is cut by less than their distance; never the other way.
      if (!free) {
        EXPECT_FALSE(IsLineFree(&layer, from, to)) << "seed " << seed << ", line " << i;
      } else {
        ++samples_free;
        agreed += IsLineFree(&layer, from, to) ? 1 : 0;
      }
    }
    EXPECT_GE(agreed, samples_free - 1) << "seed " << seed;
  }
}

TEST(PathLayerTest, MakesOnlyTheTilesThatAreAskedAboutAndAgainWhenForgotten) {
  int made = 0;
  PathLayer layer(256, 1.0, {0.0, 0.0}, [&](int, int, PathLayer::Tile* tile) {
    ++made;
    tile->fill(static_cast<std::uint8_t>(made));
  });
  EXPECT_EQ(layer.Ease({5, 5}), 1);
  EXPECT_EQ(layer.Ease({31, 0}), 1);
  EXPECT_EQ(layer.Ease({32, 0}), 2);
  layer.Forget({200.5, -200.5}, 3.0);
  EXPECT_EQ(layer.Ease({5, 5}), 1);
  layer.Forget({33.0, -10.0}, 2.0);  // reaches into the first tile
  EXPECT_EQ(layer.Ease({5, 5}), 3);
  EXPECT_EQ(layer.Ease({32, 0}), 2);
  EXPECT_EQ(made, 3);
}

TEST(PathLayerTest, FindsTheNearestFreeCellThatPasses) {
  PathLayer layer = LayerOf(FromText({".....",  //
                                      ".###.",  //
                                      ".###.",  //
                                      ".###.",  //
                                      "....."}));
  const auto any = [](CellIndex) { return true; };
  CellIndex cell;
  ASSERT_TRUE(layer.NearestFree({2.6, -2.5}, 5.0, any, &cell));
  EXPECT_EQ(cell, (CellIndex{2, 4}));
  ASSERT_TRUE(layer.NearestFree(
      {2.6, -2.5}, 5.0, [](CellIndex c) { return c.col < 4; }, &cell));
  EXPECT_EQ(cell.row == 0 || cell.row == 4, true);
  EXPECT_FALSE(layer.NearestFree({2.5, -2.5}, 1.5, any, &cell));
}

}  // namespace
}  // namespace latticeworld
