#include "latticeworld/layout/layout_mask.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "latticeworld/layout/claims/mask_measures.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

using Cells = std::set<std::pair<int, int>>;

Cells CellsOf(const LayoutMask& mask) {
  Cells cells;
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (mask.Contains({row, col})) cells.insert({row, col});
    }
  }
  return cells;
}

// What the bits do, cell by cell.
Cells GrownByHand(const Cells& cells, bool diagonals) {
  Cells grown;
  for (const auto& [row, col] : cells) {
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        if (!diagonals && dr != 0 && dc != 0) continue;
        const int r = row + dr, c = col + dc;
        if (r >= 0 && r < kLayoutSize && c >= 0 && c < kLayoutSize) grown.insert({r, c});
      }
    }
  }
  return grown;
}

Cells FloodedByHand(const Cells& open, Cells flooded, bool diagonals) {
  for (std::size_t before = 0; before != flooded.size();) {
    before = flooded.size();
    for (const auto& cell : GrownByHand(flooded, diagonals)) {
      if (open.count(cell) > 0) flooded.insert(cell);
    }
  }
  return flooded;
}

TEST(LayoutMaskTest, DoesWhatSetsOfCellsDo) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const SymbolicLayout layout =
        seed % 2 == 0 ? Random(Vocabulary::kWild, seed) : Patchy(Vocabulary::kWild, seed);
    const LayoutMask water = MaskOf(layout, 'W'), forest = MaskOf(layout, 'F');
    const LayoutMask wet = water | forest;
    const Cells cells = CellsOf(wet);
    ASSERT_EQ(wet.count(), static_cast<int>(cells.size()));
    ASSERT_EQ(wet.empty(), cells.empty());
    ASSERT_TRUE((water & forest).empty());
    ASSERT_EQ(wet - forest, water);
    ASSERT_EQ((~wet).count(), kLayoutSize * kLayoutSize - wet.count());
    ASSERT_EQ(CellsOf(wet.Grown4()), GrownByHand(cells, false));
    ASSERT_EQ(CellsOf(wet.Grown8()), GrownByHand(cells, true));
    ASSERT_EQ(wet.Grown8(3), wet.Grown8().Grown8().Grown8());
    ASSERT_EQ(wet.Grown8(0), wet);
    if (wet.empty()) continue;
    ASSERT_EQ(std::make_pair(wet.FirstCell().row, wet.FirstCell().col), *cells.begin());
    double rows = 0.0, cols = 0.0;
    for (const auto& [row, col] : cells) {
      rows += row;
      cols += col;
    }
    ASSERT_DOUBLE_EQ(wet.Centroid().row, rows / cells.size());
    ASSERT_DOUBLE_EQ(wet.Centroid().col, cols / cells.size());
    LayoutMask start;
    start.Add(wet.FirstCell());
    const Cells first = {*cells.begin()};
    ASSERT_EQ(CellsOf(wet.Flooded8(start)), FloodedByHand(cells, first, true));
    ASSERT_EQ(CellsOf(wet.Flooded4(start)), FloodedByHand(cells, first, false));
    LayoutMask end;
    end.Add({cells.rbegin()->first, cells.rbegin()->second});
    const Cells last = {*cells.rbegin()};
    ASSERT_EQ(CellsOf(wet.Flooded8(end)), FloodedByHand(cells, last, true));
    ASSERT_EQ(CellsOf(wet.Flooded4(end)), FloodedByHand(cells, last, false));
  }
}

TEST(LayoutMaskTest, FloodsASpiral) {
  // One cell wide, with walls of one cell: the longest way round that a layout has room for.
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'B');
  int low = 0, high = kLayoutSize - 1;
  Line(&layout, {{0, 0}, {0, high}, {high, high}, {high, low}, {low + 2, low}}, 'W');
  for (; low + 6 < high; low += 2, high -= 2) {
    Line(&layout,
         {{low + 2, low},
          {low + 2, high - 2},
          {high - 2, high - 2},
          {high - 2, low + 2},
          {low + 4, low + 2}},
         'W');
  }
  const LayoutMask water = MaskOf(layout, 'W');
  LayoutMask start;
  start.Add({0, 0});
  EXPECT_EQ(water.Flooded4(start), water);
  EXPECT_GT(water.count(), 300);
}

TEST(LayoutMaskTest, PiecesAreWholeApartAndLargestFirst) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const LayoutMask mask = MaskOf(Random(Vocabulary::kWild, seed), 'W');
    LayoutMask all;
    int before = kLayoutSize * kLayoutSize;
    for (const LayoutMask& piece : mask.Pieces()) {
      ASSERT_TRUE((all & piece.Grown8()).empty());
      LayoutMask start;
      start.Add(piece.FirstCell());
      ASSERT_EQ(mask.Flooded8(start), piece);
      ASSERT_LE(piece.count(), before);
      before = piece.count();
      all = all | piece;
    }
    ASSERT_EQ(all, mask);
  }
  EXPECT_TRUE(LayoutMask().Pieces().empty());
}

TEST(LayoutMaskTest, AllIsEveryCell) {
  EXPECT_EQ(LayoutMask::All().count(), kLayoutSize * kLayoutSize);
  LayoutMask all = LayoutMask::All();
  all.Remove({31, 31});
  EXPECT_FALSE(all.Contains({31, 31}));
  EXPECT_EQ(all.count(), kLayoutSize * kLayoutSize - 1);
}

TEST(MaskMeasuresTest, GapsAreKingsMoves) {
  LayoutMask a, b;
  EXPECT_EQ(GapBetween(a, b), kNoGap);
  a.Add({3, 4});
  EXPECT_EQ(GapBetween(a, b), kNoGap);
  b.Add({8, 6});
  EXPECT_EQ(GapBetween(a, b), 5);
  EXPECT_EQ(GapBetween(b, a), 5);
  b.Add({4, 5});
  EXPECT_EQ(GapBetween(a, b), 1);
  b.Add({3, 4});
  EXPECT_EQ(GapBetween(a, b), 0);
}

TEST(MaskMeasuresTest, StraysAreLonelyCellsBesideMany) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'B');
  Fill(&layout, {0, 0}, {3, 4}, 'W');
  layout.cells(20, 20) = 'W';
  layout.cells(4, 5) = 'W';  // touches at a corner
  EXPECT_EQ(WithoutStrays(MaskOf(layout, 'W')).count(), 21);
  layout.cells(25, 5) = layout.cells(25, 9) = 'W';
  EXPECT_EQ(WithoutStrays(MaskOf(layout, 'W')).count(), 24) << "three of 24 are no strays";
}

TEST(MaskMeasuresTest, HolesAreWhatNoWayLeadsOutOf) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'B');
  Disc(&layout, {15, 15}, 8.0, 'W');
  const int full = MaskOf(layout, 'W').count();
  Disc(&layout, {15, 15}, 4.0, 'F');
  EXPECT_EQ(WithHolesFilled(MaskOf(layout, 'W')).count(), full);
  Fill(&layout, {15, 15}, {15, 31}, 'B');  // a way out
  EXPECT_EQ(WithHolesFilled(MaskOf(layout, 'W')), MaskOf(layout, 'W'));
  EXPECT_EQ(Pieces4(~MaskOf(layout, 'B')).size(), 1u);
}

TEST(MaskMeasuresTest, PrincipalAxesOfADiscAndABar) {
  SymbolicLayout disc = Uniform(Vocabulary::kWild, 'B');
  Disc(&disc, {12, 18}, 9.0, 'W');
  const PrincipalAxes round = PrincipalAxesOf(MaskOf(disc, 'W'));
  EXPECT_NEAR(round.center.row, 12.0, 1e-9);
  EXPECT_NEAR(round.center.col, 18.0, 1e-9);
  EXPECT_NEAR(round.length, 18.0, 0.5);
  EXPECT_NEAR(round.width, 18.0, 0.5);
  SymbolicLayout bar = Uniform(Vocabulary::kWild, 'B');
  Line(&bar, {{4, 4}, {24, 24}}, 'W');
  const PrincipalAxes long_one = PrincipalAxesOf(MaskOf(bar, 'W'));
  EXPECT_NEAR(long_one.axis.row, long_one.axis.col, 1e-9);
  EXPECT_GT(long_one.length / long_one.width, 10.0);
}

}  // namespace
}  // namespace latticeworld
