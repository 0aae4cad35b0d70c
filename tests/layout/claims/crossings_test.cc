#include "latticeworld/layout/claims/crossings.h"

#include <gtest/gtest.h>

#include "layout/layouts.h"

namespace latticeworld {
namespace {

TEST(CrossingsTest, ANarrowRiverIsFordedAndAWideLakeIsNot) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 5}, {31, 5}, 'W');
  Fill(&layout, {10, 15}, {22, 26}, 'W');
  Fill(&layout, {16, 0}, {16, 31}, 'R');
  const Grid<Crossing> crossings = CrossingsOf(layout, true);
  for (int row = 0; row < 32; ++row) {
    for (int col = 0; col < 32; ++col) {
      Crossing expected = Crossing::kNone;
      if (row == 16 && col == 5) expected = Crossing::kFord;
      if (row == 16 && col >= 15 && col <= 26) expected = Crossing::kBridge;
      EXPECT_EQ(crossings(row, col), expected) << row << ", " << col;
    }
  }
}

TEST(CrossingsTest, ARoadAlongAShoreCrossesNothing) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 10}, {31, 14}, 'W');
  Fill(&layout, {0, 9}, {31, 9}, 'R');
  for (const Crossing crossing : CrossingsOf(layout, true)) EXPECT_EQ(crossing, Crossing::kNone);
}

TEST(CrossingsTest, RockIsNoRoad) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'W');
  Fill(&layout, {16, 0}, {16, 31}, 'R');
  for (const Crossing crossing : CrossingsOf(layout, true)) EXPECT_EQ(crossing, Crossing::kNone);
}

TEST(CrossingsTest, WithoutFordsAllWaterIsBridged) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 5}, {31, 5}, 'W');
  Fill(&layout, {16, 0}, {16, 31}, 'R');
  const Grid<Crossing> crossings = CrossingsOf(layout, false);
  for (int col = 0; col < kLayoutSize; ++col) {
    EXPECT_EQ(crossings(16, col), col == 5 ? Crossing::kBridge : Crossing::kNone) << col;
  }
}

TEST(CrossingsTest, WaterRunsOnBelowARoadHoweverWide) {
  for (int width = 1; width <= 10; ++width) {
    SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
    Fill(&layout, {0, 5}, {31, 6}, 'W');
    Fill(&layout, {12, 0}, {11 + width, 31}, 'R');
    for (const bool fords : {false, true}) {
      const Grid<Crossing> crossings = CrossingsOf(layout, fords);
      const Crossing expected = fords ? Crossing::kFord : Crossing::kBridge;
      for (int row = 0; row < kLayoutSize; ++row) {
        for (int col = 0; col < kLayoutSize; ++col) {
          const bool crosses = layout.cells(row, col) == 'R' && (col == 5 || col == 6);
          EXPECT_EQ(crossings(row, col), crosses ? expected : Crossing::kNone)
              << width << " cells wide, " << row << ", " << col;
        }
      }
    }
  }
}

TEST(CrossingsTest, TheLandOfARoadBetweenTwoLakesStaysLand) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {12, 4}, {20, 10}, 'W');
  Fill(&layout, {12, 18}, {20, 24}, 'W');
  Fill(&layout, {16, 11}, {16, 17}, 'R');
  for (const Crossing crossing : CrossingsOf(layout, false)) EXPECT_EQ(crossing, Crossing::kNone);
}

TEST(CrossingsTest, RoadAndRiverThatCrossInACornerAreFound) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  for (int i = 0; i < kLayoutSize; ++i) layout.cells(i, i) = 'R';
  layout.cells(10, 11) = layout.cells(11, 10) = 'W';
  const Grid<unsigned char> corners = CornerCrossingsOf(layout);
  for (int row = 0; row < corners.rows(); ++row) {
    for (int col = 0; col < corners.cols(); ++col) {
      EXPECT_EQ(corners(row, col), row == 11 && col == 11 ? 1 : 0) << row << ", " << col;
    }
  }
}

}  // namespace
}  // namespace latticeworld
