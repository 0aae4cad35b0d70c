#include <gtest/gtest.h>

#include "layout/claim_checks.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

SymbolicLayout Meadow() { return Uniform(Vocabulary::kSuburb, 'G'); }

Claim Count(char letter, double least, double most = Claim::kUnsaid,
            const std::string& zone = "anywhere") {
  return WithBounds(About(ClaimKind::kCount, letter, zone), least, most);
}

SymbolicLayout Lakes(int count) {
  SymbolicLayout layout = Meadow();
  for (int i = 0; i < count; ++i) Disc(&layout, {5 + 10 * (i / 3), 5 + 10 * (i % 3)}, 3.0, 'W');
  return layout;
}

TEST(ClaimPiecesTest, CountHoldsWithinItsBoundsAlone) {
  for (int lakes = 0; lakes <= 9; ++lakes) {
    EXPECT_EQ(Holds(Count('W', 3, 3), Lakes(lakes)), lakes == 3) << lakes;
    EXPECT_EQ(Holds(Count('W', 2, 5), Lakes(lakes)), lakes >= 2 && lakes <= 5) << lakes;
    EXPECT_EQ(Holds(Count('W', 4), Lakes(lakes)), lakes >= 4) << lakes;
    EXPECT_EQ(Holds(About(ClaimKind::kCount, 'W'), Lakes(lakes)), lakes >= 1) << lakes;
  }
}

TEST(ClaimPiecesTest, CountIsFartherOffPieceByPiece) {
  for (int lakes = 0; lakes < 3; ++lakes) {
    EXPECT_GT(Distance(Count('W', 3, 3), Lakes(lakes)),
              Distance(Count('W', 3, 3), Lakes(lakes + 1)));
  }
  for (int lakes = 3; lakes < 9; ++lakes) {
    EXPECT_LT(Distance(Count('W', 3, 3), Lakes(lakes)),
              Distance(Count('W', 3, 3), Lakes(lakes + 1)));
  }
}

TEST(ClaimPiecesTest, CountTakesAPieceWithHalfOfItInTheZone) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {14, 4}, {17, 7}, 'W');
  EXPECT_TRUE(Holds(Count('W', 1, 1, "northern half"), layout));
  EXPECT_TRUE(Holds(Count('W', 1, 1, "southern half"), layout));
  Fill(&layout, {18, 4}, {18, 7}, 'W');
  EXPECT_FALSE(Holds(Count('W', 1, 1, "northern half"), layout));
}

TEST(ClaimPiecesTest, StraysOfAPenAreNoLakes) {
  SymbolicLayout layout = Lakes(3);
  layout.cells(31, 31) = layout.cells(25, 2) = 'W';
  EXPECT_TRUE(Holds(Count('W', 3, 3), layout));
  SymbolicLayout hamlet = Meadow();
  hamlet.cells(3, 3) = hamlet.cells(9, 20) = hamlet.cells(25, 8) = 'B';
  EXPECT_TRUE(Holds(Count('B', 3, 3), hamlet)) << "single houses are all there is";
}

TEST(ClaimPiecesTest, ARiverUnderABridgeIsOneRiver) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{16, 0}, {16, 31}}, 'W');
  EXPECT_TRUE(Holds(Count('W', 1, 1), layout));
  Line(&layout, {{0, 12}, {31, 12}}, 'R');
  EXPECT_TRUE(Holds(Count('W', 1, 1), layout)) << ToText(layout);
  EXPECT_TRUE(Holds(Count('R', 1, 1), layout));
  Line(&layout, {{0, 13}, {31, 13}}, 'R');  // a wide road
  EXPECT_TRUE(Holds(Count('W', 1, 1), layout)) << ToText(layout);
  Line(&layout, {{0, 14}, {31, 14}}, 'R');
  EXPECT_FALSE(Holds(Count('W', 1, 1), layout)) << "three cells are no bridge";
}

TEST(ClaimPiecesTest, ABridgeCrossesAtAnyAngle) {
  const std::vector<std::vector<CellIndex>> rivers = {{{0, 4}, {31, 27}},
                                                      {{31, 3}, {2, 30}},
                                                      {{20, 0}, {12, 16}, {20, 31}},
                                                      {{0, 8}, {16, 16}, {31, 12}}};
  const std::vector<std::vector<CellIndex>> roads = {
      {{16, 0}, {16, 31}}, {{10, 0}, {24, 31}}, {{30, 0}, {3, 31}}};
  for (const auto& river : rivers) {
    for (const auto& road : roads) {
      SymbolicLayout layout = Meadow();
      Line(&layout, river, 'W');
      const int dry = MaskOf(layout, 'W').count();
      Line(&layout, road, 'R');
      if (dry - MaskOf(layout, 'W').count() > 2) continue;  // one on top of the other for a while
      EXPECT_TRUE(Holds(Count('W', 1, 1), layout)) << ToText(layout);
      EXPECT_TRUE(Holds(Count('R', 1, 1), layout));
    }
  }
}

TEST(ClaimPiecesTest, ARoadBetweenLakesJoinsNone) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {12, 10}, 5.0, 'W');
  Disc(&layout, {12, 21}, 5.0, 'W');
  Line(&layout, {{0, 15}, {31, 15}}, 'R');
  Line(&layout, {{0, 16}, {31, 16}}, 'R');
  EXPECT_TRUE(Holds(Count('W', 2, 2), layout)) << ToText(layout);
  SymbolicLayout ponds = Meadow();
  Fill(&ponds, {10, 8}, {12, 11}, 'W');
  Fill(&ponds, {10, 13}, {12, 16}, 'W');
  Line(&ponds, {{0, 12}, {31, 12}}, 'R');
  EXPECT_TRUE(Holds(Count('W', 2, 2), ponds)) << ToText(ponds);
}

TEST(ClaimPiecesTest, InTheWildNothingCrossesWater) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'B');
  Line(&layout, {{16, 0}, {16, 31}}, 'W');
  Line(&layout, {{0, 12}, {31, 12}}, 'R');  // rocky land
  EXPECT_TRUE(Holds(Count('W', 2, 2), layout));
}

TEST(ClaimPiecesTest, ClusteredIsInFewPieces) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {8, 8}, {10, 13}, 'B');
  layout.cells(14, 14) = layout.cells(6, 20) = 'B';
  EXPECT_TRUE(Holds(About(ClaimKind::kClustered, 'B'), layout)) << "three pieces";
  layout.cells(30, 30) = 'B';
  EXPECT_TRUE(Holds(About(ClaimKind::kClustered, 'B'), layout)) << "20 of 21 in three";
  Claim one = About(ClaimKind::kClustered, 'B');
  one.most = 1;
  EXPECT_FALSE(Holds(one, layout)) << "18 of 21 in one";
  SymbolicLayout scattered = Meadow();
  for (int i = 0; i < 10; ++i) scattered.cells(3 * i + 1, (9 * i) % 31) = 'B';
  EXPECT_FALSE(Holds(About(ClaimKind::kClustered, 'B'), scattered));
  EXPECT_GT(Distance(About(ClaimKind::kClustered, 'B'), scattered), Distance(one, layout));
  EXPECT_EQ(Distance(About(ClaimKind::kClustered, 'W'), layout), 1.0);
}

TEST(ClaimPiecesTest, ScatteredIsInManyPiecesOfWhichNoneRules) {
  SymbolicLayout layout = Meadow();
  const Claim claim = About(ClaimKind::kScattered, 'B');
  double before = 1.1;
  for (int i = 0; i < 4; ++i) {
    layout.cells(7 * i + 2, (9 * i + 3) % 31) = 'B';
    EXPECT_LT(Distance(claim, layout), before);
    before = Distance(claim, layout);
  }
  EXPECT_TRUE(Holds(claim, layout)) << "four";
  EXPECT_FALSE(Holds(WithBounds(claim, 5), layout));
  Fill(&layout, {28, 0}, {29, 4}, 'B');
  EXPECT_FALSE(Holds(claim, layout)) << "one has most of it";
  EXPECT_EQ(Distance(About(ClaimKind::kScattered, 'D'), layout), 1.0);
}

}  // namespace
}  // namespace latticeworld
