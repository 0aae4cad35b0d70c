#include "latticeworld/language/reading/things/things_of_text.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

TextThings Take(const std::string& text) { return TakeThings(text, Vocabulary::kSuburb); }

TEST(ThingsOfTextTest, ThreeTreesInARowBesideANeighborhoodAreThreeTreesInARow) {
  const TextThings taken = Take("Three trees in a row beside a neighborhood.");
  ASSERT_EQ(taken.things.size(), 1u);
  const ThingWish& trees = taken.things[0];
  EXPECT_EQ(trees.kind, "tree");
  EXPECT_EQ(trees.count, 3);
  EXPECT_EQ(trees.arrangement, ThingArrangement::kRow);
  EXPECT_EQ(trees.relation, ThingRelation::kNear);
  EXPECT_EQ(trees.target.letter, 'B');
  EXPECT_EQ(taken.rest, "a neighborhood.");
}

TEST(ThingsOfTextTest, ThingsStandByEachOther) {
  const TextThings taken = Take(
      "A well in front of a church, with four benches around the well and a row of six lamps "
      "along the road, 20 m apart.");
  ASSERT_EQ(taken.things.size(), 4u);
  EXPECT_EQ(taken.things[0].kind, "church");
  EXPECT_EQ(taken.things[1].kind, "well");
  EXPECT_EQ(taken.things[1].relation, ThingRelation::kInFront);
  EXPECT_EQ(taken.things[1].target.wish, 0);
  EXPECT_EQ(taken.things[2].kind, "bench");
  EXPECT_EQ(taken.things[2].count, 4);
  EXPECT_EQ(taken.things[2].target.wish, 1);
  EXPECT_EQ(taken.things[3].kind, "lamp");
  EXPECT_EQ(taken.things[3].relation, ThingRelation::kAlong);
  EXPECT_EQ(taken.things[3].target.letter, 'R');
  EXPECT_EQ(taken.things[3].spacing_m, 20.0);
}

TEST(ThingsOfTextTest, SidesAndWhatLiesBetweenAreHeard) {
  const TextThings taken = Take(
      "A tent south-west of a pond. Two benches stand to the east of the river. A well 20 m north "
      "of "
      "the tent. A ruin lies between the lake and the forest. A bench behind the ruin.");
  ASSERT_EQ(taken.things.size(), 5u);
  EXPECT_EQ(taken.things[4].relation, ThingRelation::kBehind);
  EXPECT_EQ(taken.things[4].target.wish, 3);
  EXPECT_EQ(taken.things[0].side, ThingSide::kSouthWest);
  EXPECT_EQ(taken.things[0].target.letter, 'W');
  EXPECT_EQ(taken.things[1].count, 2);
  EXPECT_EQ(taken.things[1].side, ThingSide::kEast);
  EXPECT_EQ(taken.things[2].side, ThingSide::kNorth);
  EXPECT_EQ(taken.things[2].target.wish, 0);
  EXPECT_EQ(taken.things[2].distance_m, 20.0);
  EXPECT_EQ(taken.things[3].relation, ThingRelation::kBetween);
  EXPECT_EQ(taken.things[3].target.letter, 'W');
  EXPECT_EQ(taken.things[3].second.letter, 'F');
  EXPECT_EQ(taken.rest, "a pond. the river.. the lake and the forest..");
  EXPECT_EQ(Take("A bench in the north of the forest.").things.at(0).side, ThingSide::kAny);
  EXPECT_EQ(Take("A tent right by the lake.").things.at(0).relation, ThingRelation::kNear);
  EXPECT_EQ(Take("A tent just right of the lake.").things.at(0).side, ThingSide::kEast);
}

TEST(ThingsOfTextTest, BuildingsThatAreCountedAndArrangedAreSingleThings) {
  const TextThings taken = Take(
      "Six houses in a row along the road. Four warehouses in a row along the eastern edge. "
      "A village with two warehouses and ten houses near the lake.");
  ASSERT_EQ(taken.things.size(), 2u);
  EXPECT_EQ(taken.things[0].kind, "house");
  EXPECT_EQ(taken.things[0].count, 6);
  EXPECT_EQ(taken.things[0].relation, ThingRelation::kAlong);
  EXPECT_EQ(taken.things[1].kind, "barn");
  EXPECT_EQ(taken.things[1].arrangement, ThingArrangement::kRow);
  EXPECT_EQ(taken.things[1].zone.name, "eastern edge");
  ASSERT_EQ(taken.warnings.size(), 1u);
  EXPECT_NE(taken.warnings[0].find("such kind of thing as warehouses; the nearest is a barn"),
            std::string::npos)
      << taken.warnings[0];
}

TEST(ThingsOfTextTest, LandThatTheVocabularyHasNotIsWarnedOf) {
  const TextThings taken = TakeThings("A lone oak is left of the road.", Vocabulary::kWild);
  ASSERT_EQ(taken.things.size(), 1u);
  EXPECT_EQ(taken.things[0].relation, ThingRelation::kNone);
  ASSERT_EQ(taken.warnings.size(), 1u);
  EXPECT_NE(taken.warnings[0].find("the wild vocabulary has nothing like \"the road\""),
            std::string::npos)
      << taken.warnings[0];
  EXPECT_TRUE(Take("A lone oak is left of the road.").warnings.empty());
  EXPECT_TRUE(TakeThings("A church by the road.", Vocabulary::kWild).warnings.empty())
      << "it is left to who reads the rest";
}

TEST(ThingsOfTextTest, OrderlyThingsStandInGrids) {
  const TextThings taken = Take("Organized chambers, trees, and rocks");
  ASSERT_EQ(taken.things.size(), 3u);
  EXPECT_EQ(taken.things[0].kind, "hut");
  EXPECT_EQ(taken.things[1].kind, "tree");
  EXPECT_EQ(taken.things[2].kind, "boulder");
  for (const ThingWish& wish : taken.things) {
    EXPECT_EQ(wish.arrangement, ThingArrangement::kGrid);
  }
}

TEST(ThingsOfTextTest, ALoneTreeAndASpacingAndAPlaceAreHeard) {
  const TextThings taken = Take("A lone oak tree in the upper left. Five posts every 20 m.");
  ASSERT_EQ(taken.things.size(), 2u);
  EXPECT_EQ(taken.things[0].kind, "oak");
  EXPECT_EQ(taken.things[0].zone.name, "upper left");
  EXPECT_EQ(taken.things[1].spacing_m, 20.0);
}

TEST(ThingsOfTextTest, PiersTentsAndRuinsThatAreCountedAreSingle) {
  const TextThings taken = Take("A pier at the lake. Two tents beside the lake. A ruin.");
  ASSERT_EQ(taken.things.size(), 3u);
  EXPECT_EQ(taken.things[0].target.letter, 'W');
  EXPECT_EQ(taken.things[1].count, 2);
  EXPECT_EQ(taken.things[2].kind, "ruin");
}

TEST(ThingsOfTextTest, MoreIsSaidOfThingsThatWereAskedFor) {
  const TextThings taken = Take(
      "A well in front of a lone church. Three lamps. The lamps are in a row every 6 m. The church "
      "faces the lake.");
  ASSERT_EQ(taken.things.size(), 3u);
  EXPECT_EQ(taken.things[0].kind, "church");
  EXPECT_EQ(taken.things[0].facing.letter, 'W');
  EXPECT_EQ(taken.things[1].target.wish, 0);
  EXPECT_EQ(taken.things[2].arrangement, ThingArrangement::kRow);
  EXPECT_EQ(taken.things[2].spacing_m, 6.0);
}

TEST(ThingsOfTextTest, PartsOfLandAreThatLand) {
  const TextThings taken = Take("Three crates in the middle of the dense forest.");
  ASSERT_EQ(taken.things.size(), 1u);
  EXPECT_EQ(taken.things[0].relation, ThingRelation::kIn);
  EXPECT_EQ(taken.things[0].target.letter, 'F');
  EXPECT_EQ(taken.rest, "the dense forest.");
}

TEST(ThingsOfTextTest, WhatIsSaidOfThingsIsUnderstoodWhollyOrNot) {
  for (const char* text :
       {"A bench by the lake.", "There is a well in front of a church, and a bench.",
        "A tent south-west of a pond and three lamps in a row every 6 m along the road.",
        "A village, with a well in the north."}) {
    SCOPED_TRACE(text);
    EXPECT_TRUE(Take(text).whole);
  }
  for (const char* text :
       {"A bench at the edge of the forest.", "A tent at the foot of the hill.",
        "Next to the lake there is a bench.", "On the hill there are two tents.",
        "A bench near the eastern shore of the lake.", "Two rows of three tents beside the river.",
        "A village with a well.", "A bench by the road. A tent overlooks the lake.",
        "There is a well in front of a church, and a bench beside it."}) {
    SCOPED_TRACE(text);
    EXPECT_FALSE(Take(text).whole);
  }
}

TEST(ThingsOfTextTest, LandIsLeftAsItIs) {
  for (const char* text :
       {"A river winds from the north to the south between dense forest in the upper left and "
        "farmland on the right. A road runs from the west to the east, with a small village in the "
        "center.",
        "Trees line the river.", "A row of houses along the road.", "A village with a church.",
        "A log cabin by the lake, and a well kept garden as well.", "A post office in the center.",
        "Six houses in the north."}) {
    const TextThings taken = Take(text);
    EXPECT_TRUE(taken.things.empty()) << text;
    EXPECT_EQ(taken.rest, text);
  }
}

}  // namespace
}  // namespace latticeworld
