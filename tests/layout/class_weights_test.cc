#include "latticeworld/layout/class_weights.h"

#include <gtest/gtest.h>

#include "layout/layouts.h"

namespace latticeworld {
namespace {

char LetterAt(const SymbolicLayout& layout, const GridGeometry& geometry, CellIndex cell) {
  return layout.cells(cell.row * kLayoutSize / geometry.rows(),
                      cell.col * kLayoutSize / geometry.cols());
}

TEST(DecodeLayoutTest, WeightsSumToOneInEveryCell) {
  for (const int cells : {32, 100, 257}) {
    const GridGeometry geometry = GridGeometry::FromCells(cells, 128.0);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const ClassWeights weights = ToWeights(
          DecodeLayout(Random(Vocabulary::kSuburb, seed), geometry, DecodeOptions(), seed).masks);
      for (int row = 0; row < cells; ++row) {
        for (int col = 0; col < cells; ++col) {
          float sum = 0.0f;
          for (const ClassWeight& entry : weights.classes) {
            ASSERT_GE(entry.weight(row, col), 0.0f);
            ASSERT_LE(entry.weight(row, col), 1.0f);
            sum += entry.weight(row, col);
          }
          ASSERT_NEAR(sum, 1.0f, 1e-6f);
        }
      }
    }
  }
}

TEST(DecodeLayoutTest, OnlyClassesOfTheLayoutHaveWeights) {
  const ClassWeights weights =
      ToWeights(DecodeLayout(Uniform(Vocabulary::kWild, 'F'), GridGeometry::FromCells(64, 64.0),
                             DecodeOptions(), 1)
                    .masks);
  ASSERT_EQ(weights.classes.size(), 1u);
  EXPECT_NE(weights.Find('F'), nullptr);
  EXPECT_EQ(weights.Find('W'), nullptr);
}

TEST(DecodeLayoutTest, AwayFromBordersTheLetterRules) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {8, 8}, {23, 23}, 'F');
  const GridGeometry geometry = GridGeometry::FromCells(512, 512.0);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const ClassWeights weights =
        ToWeights(DecodeLayout(layout, geometry, DecodeOptions(), seed).masks);
    for (int row = 0; row < 512; row += 3) {
      for (int col = 0; col < 512; col += 3) {
        const bool at_border = (row > 110 && row < 400 && col > 110 && col < 400) &&
                               !(row > 145 && row < 365 && col > 145 && col < 365);
        if (at_border) continue;
        ASSERT_EQ(weights.DominantAt({row, col}), LetterAt(layout, geometry, {row, col}));
      }
    }
  }
}

TEST(DecodeLayoutTest, WithoutNoiseAStraightBorderLiesInItsPlaceAndIsAsWideAsAsked) {
  DecodeOptions options;
  options.noise_amplitude = 0.0;
  options.blend_width_m = 16.0;
  const GridGeometry geometry = GridGeometry::FromCells(512, 256.0);
  SymbolicLayout upper = Uniform(Vocabulary::kSuburb, 'G'), left = upper;
  Fill(&upper, {0, 0}, {11, 31}, 'W');
  Fill(&left, {0, 0}, {31, 11}, 'W');
  for (const SymbolicLayout& layout : {upper, left}) {
    const ClassWeights weights = ToWeights(DecodeLayout(layout, geometry, options, 1).masks);
    int blended = 0;
    for (int i = 0; i < 512; ++i) {
      const CellIndex cell = layout.cells(0, 31) == 'W' ? CellIndex{i, 300} : CellIndex{300, i};
      EXPECT_EQ(weights.DominantAt(cell), LetterAt(layout, geometry, cell)) << i;
      const float weight = (*weights.Find('W'))[cell];
      blended += weight > 0.005f && weight < 0.995f;
    }
    EXPECT_GE(blended, 24);  // cells of 0.5 m
    EXPECT_LE(blended, 33);
  }
}

TEST(DecodeLayoutTest, ABorderIsBlendedAndChangesWithTheSeed) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'B');
  Fill(&layout, {0, 16}, {31, 31}, 'S');
  const GridGeometry geometry = GridGeometry::FromCells(256, 256.0);
  const ClassWeights first = ToWeights(DecodeLayout(layout, geometry, DecodeOptions(), 1).masks);
  const ClassWeights again = ToWeights(DecodeLayout(layout, geometry, DecodeOptions(), 1).masks);
  const ClassWeights other = ToWeights(DecodeLayout(layout, geometry, DecodeOptions(), 2).masks);
  EXPECT_EQ(*first.Find('S'), *again.Find('S'));
  EXPECT_NE(*first.Find('S'), *other.Find('S'));
  int blended = 0;
  for (const float weight : first.Find('S')->ToFloat()) blended += weight > 0.05f && weight < 0.95f;
  EXPECT_GT(blended, 256);       // at least a cell wide along the whole border
  EXPECT_LT(blended, 256 * 24);  // and not wider than a few layout cells
}

TEST(DecodeLayoutTest, ARoadOneCellWideStaysConnectedInItsPlace) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  for (int row = 0; row < 32; ++row) layout.cells(row, 10 + (row / 8)) = 'R';
  for (int step = 8; step < 32; step += 8) layout.cells(step, 10 + step / 8 - 1) = 'R';
  const GridGeometry geometry = GridGeometry::FromCells(512, 512.0);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const ClassWeights weights =
        ToWeights(DecodeLayout(layout, geometry, DecodeOptions(), seed).masks);
    for (int row = 0; row < 512; ++row) {
      int width = 0;
      for (int col = 130; col < 256; ++col) width += weights.DominantAt({row, col}) == 'R';
      ASSERT_GE(width, 4) << "row " << row << ", seed " << seed;
      ASSERT_LE(width, 56) << "row " << row << ", seed " << seed;
    }
  }
}

// Cells of `letter` that hang together, by their sides, with the first of them in row-major order.
int ConnectedCells(const ClassWeights& weights, char letter, int* all) {
  constexpr int kSize = 512;
  Grid<char> open(kSize, kSize, 0);
  std::vector<CellIndex> reached;
  *all = 0;
  for (int row = 0; row < kSize; ++row) {
    for (int col = 0; col < kSize; ++col) {
      if (weights.DominantAt({row, col}) != letter) continue;
      open(row, col) = 1;
      if ((*all)++ == 0) reached.push_back({row, col});
    }
  }
  for (const CellIndex& first : reached) open[first] = 0;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const CellIndex cell = reached[next];
    for (const CellIndex near :
         {CellIndex{cell.row - 1, cell.col}, CellIndex{cell.row + 1, cell.col},
          CellIndex{cell.row, cell.col - 1}, CellIndex{cell.row, cell.col + 1}}) {
      if (!open.Contains(near) || !open[near]) continue;
      open[near] = 0;
      reached.push_back(near);
    }
  }
  return static_cast<int>(reached.size());
}

TEST(DecodeLayoutTest, ARiverThatRunsDiagonallyIsOneRiver) {
  for (const bool falls : {true, false}) {
    SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
    for (int i = 0; i < 32; ++i) layout.cells(i, falls ? i : 31 - i) = 'W';
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const ClassWeights weights = ToWeights(
          DecodeLayout(layout, GridGeometry::FromCells(512, 512.0), DecodeOptions(), seed).masks);
      int all = 0;
      const int connected = ConnectedCells(weights, 'W', &all);
      EXPECT_GT(connected, 0.99 * all) << "seed " << seed << (falls ? ", falls" : ", rises");
      EXPECT_GT(all, 512 * 12);
      EXPECT_LT(all, 512 * 32);
    }
  }
}

TEST(DecodeLayoutTest, ARoadThatMeetsARiverInACornerGoesOverIt) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  for (int i = 0; i < 32; ++i) {
    layout.cells(i, i) = 'W';
    layout.cells(i, 31 - i) = 'R';
  }
  layout.cells(16, 16) = layout.cells(15, 15) = 'W';
  layout.cells(15, 16) = layout.cells(16, 15) = 'R';
  const ClassWeights weights = ToWeights(
      DecodeLayout(layout, GridGeometry::FromCells(512, 512.0), DecodeOptions(), 1).masks);
  int all = 0;
  EXPECT_GT(ConnectedCells(weights, 'R', &all), 0.99 * all);
}

}  // namespace
}  // namespace latticeworld
