#include <gtest/gtest.h>

#include "layout/claim_checks.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

constexpr Claim::Heading kNorth{0, -1}, kSouth{0, 1}, kEast{1, 0}, kWest{-1, 0};
constexpr Claim::Heading kNorthEast{1, -1};

SymbolicLayout Meadow() { return Uniform(Vocabulary::kSuburb, 'G'); }

// A village and a lake with `between` cells of meadow between them.
SymbolicLayout Apart(int between) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {10, 2}, {13, 5}, 'B');
  Fill(&layout, {9, 6 + between}, {14, 9 + between}, 'W');
  return layout;
}

TEST(ClaimRelationsTest, AdjacentAndApartCountKingsMoves) {
  for (int between = 0; between < 12; ++between) {
    const int gap = between + 1;
    const SymbolicLayout layout = Apart(between);
    const Claim adjacent = About(ClaimKind::kAdjacent, 'B', 'W');
    EXPECT_EQ(Holds(adjacent, layout), gap <= 1);
    EXPECT_EQ(Holds(WithBounds(adjacent, Claim::kUnsaid, 4), layout), gap <= 4);
    const Claim apart = About(ClaimKind::kApart, 'B', 'W');
    EXPECT_EQ(Holds(apart, layout), gap >= 3);
    EXPECT_EQ(Holds(WithBounds(apart, 6), layout), gap >= 6);
    if (gap > 1) {
      EXPECT_GT(Distance(adjacent, layout), Distance(adjacent, Apart(between - 1)));
    }
    if (gap < 6) {
      EXPECT_GT(Distance(WithBounds(apart, 6), layout),
                Distance(WithBounds(apart, 6), Apart(between + 1)));
    }
  }
}

TEST(ClaimRelationsTest, WhatIsNotThereIsNeitherNearNorFar) {
  for (const ClaimKind kind :
       {ClaimKind::kAdjacent, ClaimKind::kApart, ClaimKind::kSurrounds, ClaimKind::kWithin,
        ClaimKind::kDirection, ClaimKind::kBothSides, ClaimKind::kThrough, ClaimKind::kAlong,
        ClaimKind::kCrosses, ClaimKind::kParallel}) {
    EXPECT_EQ(Distance(Directed(kind, 'B', 'F', kNorth), Apart(3)), 1.0) << NameOf(kind);
    EXPECT_EQ(Distance(Directed(kind, 'F', 'B', kNorth), Apart(3)), 1.0) << NameOf(kind);
  }
  EXPECT_EQ(Measured(About(ClaimKind::kAdjacent, 'B', 'F'), Apart(3)).explanation,
            "there is too little forest");
}

TEST(ClaimRelationsTest, AStrayCellIsNoShore) {
  SymbolicLayout layout = Apart(9);
  layout.cells(9, 6) = 'W';
  EXPECT_FALSE(Holds(About(ClaimKind::kAdjacent, 'B', 'W'), layout));
  EXPECT_TRUE(Holds(WithBounds(About(ClaimKind::kApart, 'B', 'W'), 6), layout));
}

TEST(ClaimRelationsTest, ZonesSayWhichOfSeveral) {
  SymbolicLayout layout = Apart(9);
  Disc(&layout, {26, 26}, 3.0, 'W');
  Disc(&layout, {26, 20}, 2.0, 'B');
  Claim claim = About(ClaimKind::kAdjacent, 'B', 'W');
  EXPECT_TRUE(Holds(claim, layout));
  claim.zone = *FindZone("northern half");
  EXPECT_FALSE(Holds(claim, layout));
  claim.zone = Zone{};
  claim.object_zone = *FindZone("northern half");
  EXPECT_FALSE(Holds(claim, layout));
}

TEST(ClaimRelationsTest, TwoPiecesOfOneClassHaveAGapToo) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {8, 8}, 3.0, 'W');
  EXPECT_EQ(Distance(About(ClaimKind::kApart, 'W', 'W'), layout), 1.0) << "one alone";
  Disc(&layout, {8, 24}, 3.0, 'W');  // columns 11 and 21
  EXPECT_TRUE(Holds(WithBounds(About(ClaimKind::kApart, 'W', 'W'), 10), layout));
  EXPECT_FALSE(Holds(WithBounds(About(ClaimKind::kApart, 'W', 'W'), 11), layout));
}

// A lake with a ring of forest on `quarters` of its four sides.
SymbolicLayout Ringed(int quarters) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {11, 11}, {20, 20}, 'W');
  if (quarters > 0) Fill(&layout, {10, 11}, {10, 20}, 'F');
  if (quarters > 1) Fill(&layout, {21, 11}, {21, 20}, 'F');
  if (quarters > 2) Fill(&layout, {11, 10}, {20, 10}, 'F');
  if (quarters > 3) Fill(&layout, {11, 21}, {20, 21}, 'F');
  return layout;
}

TEST(ClaimRelationsTest, SurroundsIsAShareOfTheBorder) {
  const Claim claim = About(ClaimKind::kSurrounds, 'F', 'W');
  for (int quarters = 1; quarters <= 4; ++quarters) {
    const SymbolicLayout layout = Ringed(quarters);
    EXPECT_EQ(Holds(claim, layout), quarters >= 3) << quarters;
    EXPECT_TRUE(Holds(WithBounds(claim, 0.25 * quarters), layout)) << "just so much";
    EXPECT_FALSE(Holds(WithBounds(claim, 0.25 * quarters + 0.01), layout));
    EXPECT_EQ(Holds(About(ClaimKind::kWithin, 'W', 'F'), layout), quarters >= 3);
    if (quarters < 3) {
      EXPECT_GT(Distance(claim, layout), Distance(claim, Ringed(quarters + 1)));
    }
  }
  EXPECT_FALSE(Holds(About(ClaimKind::kSurrounds, 'W', 'F'), Ringed(4))) << "the other way round";
}

TEST(ClaimRelationsTest, AMapEdgeIsNoBorder) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {9, 9}, 'F');
  Fill(&layout, {0, 0}, {5, 5}, 'W');
  EXPECT_TRUE(Holds(WithBounds(About(ClaimKind::kSurrounds, 'F', 'W'), 1.0), layout));
}

TEST(ClaimRelationsTest, AShoreDoesNotPartALakeFromItsForest) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {15, 15}, 9.0, 'F');
  Disc(&layout, {15, 15}, 5.2, 'D');
  Disc(&layout, {15, 15}, 4.0, 'W');
  EXPECT_TRUE(Holds(About(ClaimKind::kSurrounds, 'D', 'W'), layout));
  EXPECT_TRUE(Holds(About(ClaimKind::kSurrounds, 'F', 'W'), layout));
  EXPECT_FALSE(Holds(About(ClaimKind::kSurrounds, 'G', 'W'), layout));
}

TEST(ClaimRelationsTest, AnIslandDoesNotSurroundItsLake) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {15, 15}, 9.0, 'W');
  Disc(&layout, {15, 15}, 7.0, 'F');
  EXPECT_FALSE(Holds(WithBounds(About(ClaimKind::kSurrounds, 'F', 'W'), 0.01), layout));
  EXPECT_TRUE(Holds(About(ClaimKind::kSurrounds, 'W', 'F'), layout));
  EXPECT_TRUE(Holds(About(ClaimKind::kWithin, 'F', 'W'), layout));
}

TEST(ClaimRelationsTest, OneClearingAmongMuchGrassLiesWithin) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {15, 31}, 'F');
  EXPECT_FALSE(Holds(About(ClaimKind::kWithin, 'G', 'F'), layout));
  Disc(&layout, {7, 20}, 2.0, 'G');
  EXPECT_TRUE(Holds(About(ClaimKind::kWithin, 'G', 'F'), layout));
}

TEST(ClaimRelationsTest, HousesWithGardensAreOneVillageToTheForestAround) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'F');
  Fill(&layout, {10, 10}, {20, 20}, 'G');
  for (int row = 11; row < 20; row += 3) {
    for (int col = 11; col < 20; col += 3) Fill(&layout, {row, col}, {row + 1, col + 1}, 'B');
  }
  EXPECT_TRUE(Holds(About(ClaimKind::kSurrounds, 'F', 'B'), layout));
  EXPECT_TRUE(Holds(About(ClaimKind::kWithin, 'B', 'F'), layout));
}

TEST(ClaimRelationsTest, BetweenIsOnTheWay) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {16, 4}, 3.0, 'W');
  Disc(&layout, {16, 28}, 3.0, 'F');
  const Claim claim = About(ClaimKind::kBetween, 'B', 'W', 'F');
  EXPECT_EQ(Distance(claim, layout), 1.0);
  const auto with_village = [&](CellIndex cell) {
    SymbolicLayout village = layout;
    Disc(&village, cell, 1.5, 'B');
    return village;
  };
  EXPECT_TRUE(Holds(claim, with_village({16, 16})));
  EXPECT_TRUE(Holds(claim, with_village({10, 20})));
  EXPECT_FALSE(Holds(claim, with_village({2, 16}))) << "far aside";
  EXPECT_FALSE(Holds(claim, with_village({26, 4}))) << "beside the lake";
  EXPECT_FALSE(Holds(About(ClaimKind::kBetween, 'W', 'B', 'F'), with_village({16, 16})));
  EXPECT_GT(Distance(claim, with_village({29, 2})), Distance(claim, with_village({24, 3})));
}

TEST(ClaimRelationsTest, BetweenTwoOfAKind) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {4, 4}, 3.0, 'W');
  Disc(&layout, {15, 16}, 1.5, 'B');
  EXPECT_EQ(Distance(About(ClaimKind::kBetween, 'B', 'W', 'W'), layout), 1.0);
  Disc(&layout, {27, 27}, 3.0, 'W');
  EXPECT_TRUE(Holds(About(ClaimKind::kBetween, 'B', 'W', 'W'), layout));
}

TEST(ClaimRelationsTest, ARiverLiesBetweenTheLandsOfItsBanks) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'F');
  Fill(&layout, {0, 16}, {31, 31}, 'A');
  Line(&layout, {{0, 15}, {31, 17}}, 'W');
  EXPECT_TRUE(Holds(About(ClaimKind::kBetween, 'W', 'F', 'A'), layout));
  EXPECT_FALSE(Holds(About(ClaimKind::kBetween, 'F', 'W', 'A'), layout));
}

TEST(ClaimRelationsTest, DirectionFollowsTheCompass) {
  constexpr Claim::Heading kHeadings[8] = {{0, -1}, {1, -1}, {1, 0},  {1, 1},
                                           {0, 1},  {-1, 1}, {-1, 0}, {-1, -1}};
  for (int at = 0; at < 8; ++at) {
    SymbolicLayout layout = Meadow();
    Disc(&layout, {16, 16}, 3.0, 'W');
    Disc(&layout, {16 + 10 * kHeadings[at].south, 16 + 10 * kHeadings[at].east}, 1.5, 'B');
    for (int asked = 0; asked < 8; ++asked) {
      const Claim claim = Directed(ClaimKind::kDirection, 'B', 'W', kHeadings[asked]);
      const int turn = std::min((at - asked + 8) % 8, (asked - at + 8) % 8);
      // An eighth off is told from the heading at corners, where it counts as both.
      EXPECT_TRUE(turn != 0 || Holds(claim, layout)) << at << " " << asked;
      EXPECT_TRUE(turn < 2 || !Holds(claim, layout)) << at << " " << asked;
    }
    EXPECT_FALSE(Holds(Directed(ClaimKind::kDirection, 'W', 'B', kHeadings[at]), layout));
  }
}

TEST(ClaimRelationsTest, DirectionComesNearerStepByStep) {
  double before = 1.1;
  for (int row = 28; row >= 12; row -= 2) {
    SymbolicLayout layout = Meadow();
    Disc(&layout, {16, 8}, 2.0, 'W');
    Disc(&layout, {row, 20}, 1.5, 'B');
    const double distance = Distance(Directed(ClaimKind::kDirection, 'B', 'W', kNorth), layout);
    EXPECT_LT(distance, before);
    before = distance;
  }
}

TEST(ClaimRelationsTest, WordsSayWhereAThingLies) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {20, 8}, 2.0, 'W');
  Disc(&layout, {8, 8}, 2.0, 'B');
  EXPECT_EQ(
      Measured(Directed(ClaimKind::kDirection, 'B', 'W', kNorth), layout).explanation,
      "building lies 12 cells to the north of water; more to the north than to the side is asked");
  EXPECT_EQ(
      Measured(Directed(ClaimKind::kDirection, 'B', 'W', kSouth), layout).explanation,
      "building lies 12 cells to the north of water; more to the south than to the side is asked");
  EXPECT_EQ(Measured(About(ClaimKind::kAdjacent, 'B', 'W'), layout).explanation,
            "building and water are 8 steps apart; at most 1 is asked");
}

TEST(ClaimRelationsTest, OneOfTwoVillagesNorthOfTheLakeIsEnough) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {20, 6}, 3.0, 'W');
  Disc(&layout, {10, 6}, 2.0, 'B');
  Disc(&layout, {24, 28}, 2.0, 'B');
  EXPECT_TRUE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', kNorth), layout));
  EXPECT_TRUE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', kEast), layout));
  EXPECT_FALSE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', kWest), layout));
  EXPECT_FALSE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', {0, 0}), layout));
}

TEST(ClaimRelationsTest, NorthOfARiverIsNorthOfItsNearestReach) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{10, 0}, {14, 12}, {20, 22}, {22, 31}}, 'W');
  Disc(&layout, {6, 2}, 1.5, 'B');
  EXPECT_TRUE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', kNorth), layout));
  EXPECT_TRUE(Holds(Directed(ClaimKind::kDirection, 'W', 'B', kSouth), layout));
  EXPECT_FALSE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', kSouth), layout));
  Disc(&layout, {6, 2}, 1.5, 'G');
  Disc(&layout, {16, 2}, 1.5, 'B');
  EXPECT_FALSE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', kNorth), layout));
  EXPECT_TRUE(Holds(Directed(ClaimKind::kDirection, 'B', 'W', kSouth), layout));
}

TEST(ClaimRelationsTest, OrderGoesByTheMiddles) {
  SymbolicLayout layout = Uniform(Vocabulary::kWild, 'B');
  Fill(&layout, {0, 0}, {6, 31}, 'S');
  Fill(&layout, {7, 0}, {14, 31}, 'R');
  Fill(&layout, {15, 0}, {22, 31}, 'F');
  Claim claim = Directed(ClaimKind::kOrder, '?', '\0', kSouth);
  claim.sequence = "SRFB";
  EXPECT_TRUE(Holds(claim, layout));
  claim.heading = kNorth;
  EXPECT_EQ(Measured(claim, layout).explanation,
            "3 of 3 steps go another way; the order SRFB to the north is asked");
  const double backward = Distance(claim, layout);
  claim.heading = kSouth;
  claim.sequence = "RSFB";
  EXPECT_FALSE(Holds(claim, layout));
  EXPECT_LT(Distance(claim, layout), backward);
  claim.sequence = "SRWB";
  EXPECT_EQ(Distance(claim, layout), 1.0);
  claim.sequence = "SB";
  claim.heading = kEast;
  EXPECT_FALSE(Holds(claim, layout)) << "neither is east of the other";
  claim.heading = kNorthEast;
  EXPECT_FALSE(Holds(claim, layout));
}

}  // namespace
}  // namespace latticeworld
