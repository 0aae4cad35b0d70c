#include <gtest/gtest.h>

#include "layout/claim_checks.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

SymbolicLayout Meadow() { return Uniform(Vocabulary::kSuburb, 'G'); }

TEST(ClaimSharesTest, PresentAsksForAShareOfTheZone) {
  SymbolicLayout layout = Meadow();
  layout.cells(2, 2) = 'W';
  EXPECT_FALSE(Holds(About(ClaimKind::kPresent, 'W', "upper left"), layout)) << "one of 121";
  layout.cells(2, 3) = 'W';
  EXPECT_TRUE(Holds(About(ClaimKind::kPresent, 'W', "upper left"), layout)) << "two of 121";
  EXPECT_FALSE(Holds(About(ClaimKind::kPresent, 'W'), layout)) << "two of 1024";
  EXPECT_TRUE(Holds(WithBounds(About(ClaimKind::kPresent, 'W'), 2.0 / 1024), layout));
  EXPECT_FALSE(Holds(WithBounds(About(ClaimKind::kPresent, 'W'), 2.1 / 1024), layout));
  EXPECT_EQ(Distance(About(ClaimKind::kPresent, 'W', "lower"), layout), 1.0);
}

TEST(ClaimSharesTest, PresentGrowsNearerCellByCell) {
  SymbolicLayout layout = Meadow();
  const Claim claim = WithBounds(About(ClaimKind::kPresent, 'F', "eastern half"), 0.5);
  double before = 1.1;
  for (int col = 31; col >= 16; --col) {
    const double distance = Distance(claim, layout);
    EXPECT_TRUE(distance < before || distance == 0.0) << col;
    before = distance;
    Fill(&layout, {0, col}, {31, col}, 'F');
  }
  EXPECT_EQ(before, 0.0);
}

TEST(ClaimSharesTest, AbsentAllowsNothingOrItsBound) {
  SymbolicLayout layout = Meadow();
  const Claim claim = About(ClaimKind::kAbsent, 'B', "eastern third");
  Fill(&layout, {4, 4}, {9, 9}, 'B');
  EXPECT_TRUE(Holds(claim, layout));
  layout.cells(30, 30) = 'B';
  EXPECT_FALSE(Holds(claim, layout));
  Claim some = claim;
  some.most = 0.01;
  EXPECT_TRUE(Holds(some, layout));
  const double one = Distance(claim, layout);
  EXPECT_GE(one, 0.02) << "the last cell must be worth a search's while";
  Fill(&layout, {20, 25}, {30, 30}, 'B');
  EXPECT_GT(Distance(claim, layout), one);
}

TEST(ClaimSharesTest, AmountHasTwoEnds) {
  const Claim claim = WithBounds(About(ClaimKind::kAmount, 'F'), 0.4, 0.6);
  double before = 2.0;
  for (int rows = 0; rows <= kLayoutSize; ++rows) {
    SymbolicLayout layout = Meadow();
    if (rows > 0) Fill(&layout, {0, 0}, {rows - 1, 31}, 'F');
    const double share = rows / 32.0, distance = Distance(claim, layout);
    EXPECT_EQ(distance == 0.0, share >= 0.4 && share <= 0.6) << share;
    if (share < 0.4) {
      EXPECT_LT(distance, before);
    }
    if (rows > 20) {
      EXPECT_GT(distance, before);
    }
    before = distance;
  }
  SymbolicLayout exact = Meadow();
  Fill(&exact, {0, 0}, {31, 7}, 'F');
  EXPECT_TRUE(Holds(WithBounds(About(ClaimKind::kAmount, 'F'), 0.25, 0.25), exact));
}

TEST(ClaimSharesTest, DominantHasMoreThanAnyOther) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {31, 15}, 'F');
  EXPECT_FALSE(Holds(About(ClaimKind::kDominant, 'F'), layout)) << "as many are not more";
  EXPECT_FALSE(Holds(About(ClaimKind::kDominant, 'G'), layout));
  const double tied = Distance(About(ClaimKind::kDominant, 'F'), layout);
  layout.cells(16, 16) = 'F';
  EXPECT_TRUE(Holds(About(ClaimKind::kDominant, 'F'), layout));
  EXPECT_TRUE(Holds(About(ClaimKind::kDominant, 'G', "eastern half"), layout));
  Fill(&layout, {0, 0}, {31, 7}, 'G');
  EXPECT_GT(Distance(About(ClaimKind::kDominant, 'F'), layout), tied);
  EXPECT_EQ(Distance(About(ClaimKind::kDominant, 'A'), layout), 1.0);
}

TEST(ClaimSharesTest, DominantNeedsNoHalf) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {31, 11}, 'F');
  Fill(&layout, {0, 12}, {31, 21}, 'A');
  EXPECT_TRUE(Holds(About(ClaimKind::kDominant, 'F'), layout));
}

TEST(ClaimSharesTest, MoreThanComparesTwo) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {3, 3}, 'F');
  Fill(&layout, {0, 10}, {3, 13}, 'A');
  const Claim claim = About(ClaimKind::kMoreThan, 'F', 'A');
  EXPECT_FALSE(Holds(claim, layout)) << "equal";
  const double equal = Distance(claim, layout);
  layout.cells(4, 4) = 'F';
  EXPECT_TRUE(Holds(claim, layout));
  Fill(&layout, {10, 10}, {20, 20}, 'A');
  EXPECT_GT(Distance(claim, layout), equal);
  Claim west = claim;
  west.zone = *FindZone("western quarter");
  EXPECT_TRUE(Holds(west, layout)) << "both are counted in the zone";
  EXPECT_FALSE(Holds(About(ClaimKind::kMoreThan, 'B', 'D'), layout)) << "none of either";
}

TEST(ClaimSharesTest, LocatedAsksWhereTheClassLies) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {5, 0}, 'B');
  Fill(&layout, {28, 30}, {31, 30}, 'B');
  const Claim claim = About(ClaimKind::kLocated, 'B', "northern half");
  EXPECT_TRUE(Holds(claim, layout)) << "six of ten";
  EXPECT_FALSE(Holds(WithBounds(claim, 0.61), layout));
  EXPECT_FALSE(Holds(About(ClaimKind::kLocated, 'B', "southern half"), layout));
  EXPECT_EQ(Distance(About(ClaimKind::kLocated, 'W', "southern half"), layout), 1.0);
}

TEST(ClaimSharesTest, RestLooksAtWhatNobodyNamed) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {31, 25}, 'W');
  Claim claim = About(ClaimKind::kRest, 'G');
  claim.sequence = "W";
  EXPECT_TRUE(Holds(claim, layout));
  Fill(&layout, {0, 26}, {31, 26}, 'F');  // 32 of 192
  EXPECT_TRUE(Holds(claim, layout));
  Fill(&layout, {0, 27}, {31, 27}, 'F');
  EXPECT_FALSE(Holds(claim, layout));
  claim.sequence = "WF";
  EXPECT_TRUE(Holds(claim, layout));
  EXPECT_EQ(Distance(claim, Uniform(Vocabulary::kSuburb, 'W')), 1.0) << "there is no rest";
}

TEST(ClaimSharesTest, WordsSayWhatIsAndWhatIsAsked) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {0, 0}, {7, 31}, 'F');
  EXPECT_EQ(Measured(WithBounds(About(ClaimKind::kAmount, 'F'), 0.4, 0.6), layout).explanation,
            "forest covers 25.0 % of the layout; 40.0 % to 60.0 % is asked");
  EXPECT_EQ(Measured(About(ClaimKind::kPresent, 'W', "upper left"), layout).explanation,
            "water covers 0.0 % of the upper left; at least 1.5 % is asked");
  EXPECT_EQ(Measured(About(ClaimKind::kAbsent, 'F', "northern quarter"), layout).explanation,
            "forest covers 100.0 % of the northern quarter; none is asked");
}

}  // namespace
}  // namespace latticeworld
