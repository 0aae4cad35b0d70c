#include "latticeworld/layout/crossings.h"

#include <gtest/gtest.h>

#include "layouts.h"

namespace latticeworld {
namespace {

TEST(CrossingsTest, ANarrowRiverIsFordedAndAWideLakeIsNot) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 5}, {31, 5}, 'W');
  Fill(&layout, {10, 15}, {22, 26}, 'W');
  Fill(&layout, {16, 0}, {16, 31}, 'R');
  const Grid<Crossing> crossings = CrossingsOf(layout);
  for (int row = 0; row < 32; ++row) {
    for (int col = 0; col < 32; ++col) {
      Crossing expected = Crossing::kNone;
      if (row == 16 && col == 5) expected = Crossing::kFord;
      if (row == 16 && col >= 15 && col <= 26) expected = Crossing::kCauseway;
      EXPECT_EQ(crossings(row, col), expected) << row << ", " << col;
    }
  }
}

TEST(CrossingsTest, ARoadAlongAShoreCrossesNothing) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  Fill(&layout, {0, 10}, {31, 14}, 'W');
  Fill(&layout, {0, 9}, {31, 9}, 'R');
  for (const Crossing crossing : CrossingsOf(layout)) EXPECT_EQ(crossing, Crossing::kNone);
}

TEST(CrossingsTest, RockIsNoRoad) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'W');
  Fill(&layout, {16, 0}, {16, 31}, 'R');
  for (const Crossing crossing : CrossingsOf(layout)) EXPECT_EQ(crossing, Crossing::kNone);
}

}  // namespace
}  // namespace latticeworld
