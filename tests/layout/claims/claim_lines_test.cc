#include <gtest/gtest.h>

#include "layout/claim_checks.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

SymbolicLayout Meadow() { return Uniform(Vocabulary::kSuburb, 'G'); }

TEST(ClaimLinesTest, ACourseIsOnePieceFromZoneToZone) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{14, 0}, {10, 12}, {17, 22}, {13, 31}}, 'W');
  EXPECT_TRUE(Holds(Course('W', "western edge", "eastern edge"), layout));
  EXPECT_TRUE(Holds(Course('W', "anywhere", "eastern edge"), layout));
  EXPECT_FALSE(Holds(Course('W', "northern edge", "eastern edge"), layout));
  layout.cells(11, 13) = layout.cells(10, 12) = layout.cells(10, 13) = 'G';
  EXPECT_FALSE(Holds(Course('W', "western edge", "eastern edge"), layout)) << "cut in two";
  EXPECT_EQ(Distance(Course('R', "western edge", "eastern edge"), layout), 1.0);
}

TEST(ClaimLinesTest, ACourseComesNearerCellByCell) {
  double before = 1.1;
  for (int end = 0; end < kLayoutSize; ++end) {
    SymbolicLayout layout = Meadow();
    Line(&layout, {{14, 0}, {14, end}}, 'R');
    const double distance = Distance(Course('R', "western edge", "eastern edge"), layout);
    EXPECT_TRUE(distance < before || end < 4 || end > 28) << end;
    EXPECT_EQ(distance == 0.0, end >= 28) << end;
    before = distance;
  }
}

TEST(ClaimLinesTest, ARiverGoesOnUnderARoad) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{16, 0}, {16, 31}}, 'W');
  Line(&layout, {{0, 12}, {31, 20}}, 'R');
  EXPECT_TRUE(Holds(Course('W', "western edge", "eastern edge"), layout));
  EXPECT_TRUE(Holds(Course('R', "northern edge", "southern edge"), layout));
  Line(&layout, {{0, 12}, {31, 20}}, 'F');
  EXPECT_FALSE(Holds(Course('W', "western edge", "eastern edge"), layout)) << "forest is no bridge";
}

TEST(ClaimLinesTest, ALineThroughALandHasItOnBothSides) {
  SymbolicLayout layout = Meadow();
  Fill(&layout, {10, 8}, {22, 22}, 'F');
  Line(&layout, {{0, 12}, {31, 17}}, 'W');
  EXPECT_TRUE(Holds(About(ClaimKind::kThrough, 'W', 'F'), layout));
  EXPECT_TRUE(Holds(About(ClaimKind::kBothSides, 'F', 'W'), layout));
  SymbolicLayout past;
  for (const int col : {23, 7}) {
    past = Meadow();
    Fill(&past, {10, 8}, {22, 22}, 'F');
    Line(&past, {{0, col}, {31, col}}, 'W');
    EXPECT_FALSE(Holds(About(ClaimKind::kThrough, 'W', 'F'), past)) << "along its border";
    EXPECT_FALSE(Holds(About(ClaimKind::kBothSides, 'F', 'W'), past));
  }
  SymbolicLayout far = Meadow();
  Fill(&far, {10, 8}, {22, 22}, 'F');
  Line(&far, {{0, 30}, {31, 30}}, 'W');
  EXPECT_GT(Distance(About(ClaimKind::kThrough, 'W', 'F'), far),
            Distance(About(ClaimKind::kThrough, 'W', 'F'), past));
}

TEST(ClaimLinesTest, AWindingRoadHasAVillageOnBothSides) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{0, 6}, {10, 10}, {14, 22}, {31, 26}}, 'R');
  Fill(&layout, {8, 14}, {9, 17}, 'B');
  EXPECT_FALSE(Holds(About(ClaimKind::kBothSides, 'B', 'R'), layout)) << "north of it alone";
  EXPECT_FALSE(Holds(About(ClaimKind::kThrough, 'R', 'B'), layout));
  Fill(&layout, {14, 13}, {15, 16}, 'B');
  EXPECT_TRUE(Holds(About(ClaimKind::kBothSides, 'B', 'R'), layout)) << ToText(layout);
  EXPECT_TRUE(Holds(About(ClaimKind::kThrough, 'R', 'B'), layout));
}

TEST(ClaimLinesTest, SidesStayThemselvesAroundABend) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{31, 8}, {8, 8}, {8, 24}, {31, 24}}, 'W');
  // All within the bend: one side.
  Fill(&layout, {10, 10}, {12, 13}, 'F');
  Fill(&layout, {20, 10}, {24, 11}, 'F');
  Fill(&layout, {20, 21}, {24, 22}, 'F');
  EXPECT_FALSE(Holds(About(ClaimKind::kBothSides, 'F', 'W'), layout)) << ToText(layout);
  Fill(&layout, {20, 26}, {24, 27}, 'F');
  EXPECT_TRUE(Holds(About(ClaimKind::kBothSides, 'F', 'W'), layout));
}

TEST(ClaimLinesTest, ALakeHasSidesWhereverOneLooksFrom) {
  for (const auto& [first, second] : {std::pair<CellIndex, CellIndex>{{16, 8}, {16, 24}},
                                      {{8, 16}, {24, 16}},
                                      {{9, 9}, {23, 23}},
                                      {{9, 23}, {23, 9}}}) {
    SymbolicLayout layout = Meadow();
    Disc(&layout, {16, 16}, 6.0, 'W');
    Disc(&layout, first, 1.5, 'B');
    EXPECT_FALSE(Holds(About(ClaimKind::kBothSides, 'B', 'W'), layout)) << ToText(layout);
    Disc(&layout, second, 1.5, 'B');
    EXPECT_TRUE(Holds(About(ClaimKind::kBothSides, 'B', 'W'), layout)) << ToText(layout);
  }
}

TEST(ClaimLinesTest, AlongIsWithinThreeSteps) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{0, 10}, {31, 10}}, 'R');
  Fill(&layout, {4, 12}, {5, 13}, 'B');
  Fill(&layout, {20, 7}, {21, 8}, 'B');
  EXPECT_TRUE(Holds(WithBounds(About(ClaimKind::kAlong, 'B', 'R'), 1.0), layout));
  Fill(&layout, {20, 20}, {22, 23}, 'B');  // 12 of 20 far off
  EXPECT_TRUE(Holds(About(ClaimKind::kAlong, 'R', 'R'), layout));
  SymbolicLayout field = Meadow();
  Line(&field, {{0, 10}, {31, 10}}, 'R');
  Fill(&field, {8, 12}, {15, 15}, 'A');  // two of four columns near
  EXPECT_TRUE(Holds(About(ClaimKind::kAlong, 'A', 'R'), field));
  EXPECT_FALSE(Holds(WithBounds(About(ClaimKind::kAlong, 'A', 'R'), 0.51), field));
  Fill(&field, {8, 12}, {15, 20}, 'A');
  EXPECT_FALSE(Holds(About(ClaimKind::kAlong, 'A', 'R'), field));
}

TEST(ClaimLinesTest, AlongAnEdge) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{0, 29}, {20, 30}}, 'W');
  EXPECT_TRUE(Holds(About(ClaimKind::kAlong, 'W', "eastern edge"), layout));
  EXPECT_FALSE(Holds(About(ClaimKind::kAlong, 'W', "western edge"), layout));
  EXPECT_FALSE(Holds(About(ClaimKind::kAlong, 'W', "northern edge"), layout));
  Disc(&layout, {16, 10}, 7.0, 'W');
  EXPECT_TRUE(Holds(About(ClaimKind::kAlong, 'W', "eastern edge"), layout))
      << "it follows the edge for most of its length, however much water there is elsewhere";
  SymbolicLayout across = Meadow();
  Line(&across, {{16, 0}, {16, 31}}, 'W');
  EXPECT_FALSE(Holds(About(ClaimKind::kAlong, 'W', "eastern edge"), across));
}

TEST(ClaimLinesTest, CrossingIsToComeOutOnTheOtherSide) {
  const Claim claim = About(ClaimKind::kCrosses, 'R', 'W');
  for (const auto& road : std::vector<std::vector<CellIndex>>{
           {{0, 12}, {31, 12}}, {{2, 2}, {30, 30}}, {{30, 2}, {3, 29}}, {{0, 20}, {31, 8}}}) {
    SymbolicLayout layout = Meadow();
    Line(&layout, {{16, 0}, {16, 31}}, 'W');
    Line(&layout, road, 'R');
    EXPECT_TRUE(Holds(claim, layout)) << ToText(layout);
    EXPECT_TRUE(Holds(About(ClaimKind::kCrosses, 'W', 'R'), layout));
    SymbolicLayout under = Meadow();
    Line(&under, road, 'R');
    Line(&under, {{16, 0}, {16, 31}}, 'W');
    EXPECT_TRUE(Holds(claim, under)) << ToText(under);
  }
}

TEST(ClaimLinesTest, ARoadThatEndsAtARiverDoesNotCrossIt) {
  const Claim claim = About(ClaimKind::kCrosses, 'R', 'W');
  SymbolicLayout layout = Meadow();
  Line(&layout, {{16, 0}, {16, 31}}, 'W');
  SymbolicLayout ends = layout, beside = layout, far = layout;
  Line(&ends, {{0, 12}, {15, 12}}, 'R');
  Line(&beside, {{15, 0}, {15, 31}}, 'R');
  Line(&far, {{2, 0}, {2, 31}}, 'R');
  EXPECT_FALSE(Holds(claim, ends));
  EXPECT_FALSE(Holds(claim, beside));
  EXPECT_FALSE(Holds(claim, far));
  EXPECT_GT(Distance(claim, far), Distance(claim, ends));
}

TEST(ClaimLinesTest, AWideRiverIsCrossedToo) {
  for (int width = 2; width <= 3; ++width) {
    SymbolicLayout layout = Meadow();
    Fill(&layout, {15, 0}, {14 + width, 31}, 'W');
    Line(&layout, {{0, 12}, {31, 12}}, 'R');
    EXPECT_TRUE(Holds(About(ClaimKind::kCrosses, 'R', 'W'), layout)) << ToText(layout);
  }
}

TEST(ClaimLinesTest, TwoRoadsCrossWhereFourArmsMeet) {
  SymbolicLayout layout = Meadow();
  const Claim claim = About(ClaimKind::kCrosses, 'R', 'R');
  Line(&layout, {{16, 0}, {16, 31}}, 'R');
  const double alone = Distance(claim, layout);
  EXPECT_GT(alone, 0.0);
  Line(&layout, {{0, 12}, {15, 12}}, 'R');
  EXPECT_FALSE(Holds(claim, layout)) << "three arms";
  EXPECT_LT(Distance(claim, layout), alone);
  Line(&layout, {{16, 12}, {31, 12}}, 'R');
  EXPECT_TRUE(Holds(claim, layout));
}

TEST(ClaimLinesTest, ParallelLinesRunBesideEachOther) {
  const Claim claim = About(ClaimKind::kParallel, 'R', 'W');
  SymbolicLayout river = Meadow();
  Line(&river, {{20, 0}, {16, 10}, {19, 20}, {14, 31}}, 'W');
  SymbolicLayout beside = river, across = river, touching = river, behind = river;
  Line(&beside, {{14, 2}, {11, 12}, {13, 20}, {8, 30}}, 'R');
  EXPECT_TRUE(Holds(claim, beside)) << ToText(beside);
  Line(&across, {{0, 12}, {31, 12}}, 'R');
  EXPECT_FALSE(Holds(claim, across));
  Line(&touching, {{19, 0}, {15, 10}, {18, 20}, {13, 31}}, 'R');
  EXPECT_FALSE(Holds(claim, touching)) << ToText(touching);
  SymbolicLayout apart = Meadow();
  Line(&apart, {{10, 0}, {10, 12}}, 'W');
  Line(&apart, {{14, 18}, {14, 31}}, 'R');
  EXPECT_FALSE(Holds(claim, apart)) << "one after the other";
}

TEST(ClaimLinesTest, ParallelLinesBendTogether) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{2, 0}, {2, 27}, {31, 27}}, 'W');
  Line(&layout, {{5, 0}, {5, 24}, {31, 24}}, 'R');
  EXPECT_TRUE(Holds(About(ClaimKind::kParallel, 'R', 'W'), layout)) << ToText(layout);
}

TEST(ClaimLinesTest, TwoParallelRoads) {
  SymbolicLayout layout = Meadow();
  Line(&layout, {{4, 0}, {4, 31}}, 'R');
  EXPECT_EQ(Distance(About(ClaimKind::kParallel, 'R', 'R'), layout), 1.0);
  Line(&layout, {{9, 0}, {10, 31}}, 'R');
  EXPECT_TRUE(Holds(About(ClaimKind::kParallel, 'R', 'R'), layout));
}

TEST(ClaimLinesTest, AConnectionReachesBothEnds) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {6, 6}, 2.0, 'B');
  Disc(&layout, {24, 25}, 3.0, 'W');
  const Claim claim = About(ClaimKind::kConnects, 'R', 'B', 'W');
  EXPECT_EQ(Distance(claim, layout), 1.0);
  double before = 1.1;
  for (int step = 0; step <= 14; ++step) {
    SymbolicLayout road = layout;
    Line(&road, {{9, 8}, {9 + step, 8 + step}}, 'R');
    const double distance = Distance(claim, road);
    EXPECT_TRUE(distance < before || (distance == 0.0 && before == 0.0)) << step;
    EXPECT_EQ(distance == 0.0, step >= 13) << step << "\n" << ToText(road);
    before = distance;
  }
}

TEST(ClaimLinesTest, AConnectionOfTwoVillages) {
  SymbolicLayout layout = Meadow();
  Disc(&layout, {6, 6}, 2.0, 'B');
  Line(&layout, {{6, 9}, {6, 22}}, 'R');
  const Claim claim = About(ClaimKind::kConnects, 'R', 'B', 'B');
  EXPECT_EQ(Distance(claim, layout), 1.0) << "one village alone";
  Disc(&layout, {16, 27}, 2.0, 'B');
  EXPECT_FALSE(Holds(claim, layout));
  Line(&layout, {{6, 22}, {16, 24}}, 'R');
  EXPECT_TRUE(Holds(claim, layout)) << ToText(layout);
  Line(&layout, {{0, 15}, {31, 15}}, 'W');
  EXPECT_TRUE(Holds(claim, layout)) << "a river does not part it";
  Line(&layout, {{0, 15}, {31, 15}}, 'G');
  EXPECT_FALSE(Holds(claim, layout)) << "a gap does";
}

}  // namespace
}  // namespace latticeworld
