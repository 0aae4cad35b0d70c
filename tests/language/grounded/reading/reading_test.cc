#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/common/random.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/grounded/reading/claims_of_plan.h"
#include "latticeworld/language/grounded/reading/layout_parser.h"
#include "latticeworld/language/grounded/reading/sense.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Samples() {
  return {
      {"Shrubs only near the brook.", kSuburb, {"present W", "adjacent G W"}},
      {"Dunes in the north, then scrub, then woods.",
       kSuburb,
       {"direction G D S", "direction F G S"}},
      {"heath to the left of the pond, spruces to the right",
       kSuburb,
       {"direction G W W", "direction F W E"}},
      {"Everything north of the brook is woodland and everything south of it is ploughed.",
       kSuburb,
       {"direction F W N"}},
      {"A hamlet whose southern edge borders on a pond.",
       kSuburb,
       {"direction W B S", "adjacent W B"}},
      {"a street crossing a creek that flows from the north to the south",
       kSuburb,
       {"course W northern edge>southern edge", "crosses R W"}},
      {"No houses in the west. Only heath there.", kSuburb, {"present G@western third"}},
      {"Trees close to the barn but not close to the lane.", kSuburb, {"apart F R"}},
      {"The houses have spread on both banks of the brook.", kSuburb, {"both_sides B W"}},
      {"meadow left village right",
       kSuburb,
       {"present G@western third", "present B@eastern third"}},
      // What lies close by, to a side of what is told about, or along it.
      {"A stream from north to south, with a hamlet on its eastern bank.",
       kSuburb,
       {"adjacent B W", "direction B W E"}},
      {"A village with orchards to the west and a lake to the east.",
       kSuburb,
       {"direction W B E"},
       {"present W@eastern third"}},
      {"Shrubs grow only near the river. The river flows from west to east.", kWild, {"along B W"}},
      {"A lake in the middle. A forest hugs its whole shore.", kWild, {"surrounds F W"}},
      // One thing for each of several places, one share for each of several things.
      {"Two ponds, one in each northern corner.",
       kSuburb,
       {"present W@north-west corner", "present W@north-east corner", "count W 2..2"}},
      {"All sand and two small lakes.", kSuburb, {"rest D", "count W 2..2"}},
      {"A hamlet beside a lake. Only one hamlet, please.", kSuburb, {"count B 1..1"}},
      // Places.
      {"A forest in the north-west.", kSuburb, {"present F@upper left"}},
      {"woods W, lake E", kSuburb, {"present F@western third", "present W@eastern third"}},
      {"In the upper left there is a lake and in the lower right a town.",
       kSuburb,
       {"present W@upper left", "present B@lower right"}},
      {"Forest and farmland in the west, a village in the east",
       kSuburb,
       {"present F@western third", "present A@western third", "present B@eastern third"},
       {"present F@eastern third"}},
      {"a lake, a village in the center", kSuburb, {"present B@center"}, {"present W@center"}},
      {"Woods lie in all four corners.",
       kSuburb,
       {"present F@north-west corner", "present F@south-east corner"}},
      {"upper left: town. lower right: lake.",
       kSuburb,
       {"present B@upper left", "present W@lower right"}},
      {"The northern lake is large.", kSuburb, {"present W@northern third", "amount W"}},
      {"DESERT AT THE TOP, FARMLAND IN THE MIDDLE, OCEAN AT THE BOTTOM",
       kSuburb,
       {"present D@northern third", "present A@middle rows", "present W@southern third"}},
      {"in the background mountains, in the foreground a lake",
       kWild,
       {"present R@northern third", "present W@southern third"}},
      // Extents.
      {"The northern half is forest.",
       kSuburb,
       {"dominant F@northern half", "amount F@northern half"}},
      {"Farmland covers the southern half", kSuburb, {"dominant A@southern half"}},
      {"half of the map is forest", kSuburb, {"amount F"}, {"dominant F"}},
      {"Forest takes up a third of the map and the rest is grassland.",
       kSuburb,
       {"amount F", "rest G"}},
      {"30 % water, 20 % forest", kSuburb, {"amount W", "amount F"}},
      {"mostly meadow with a pond in the middle", kSuburb, {"dominant G", "present W@center"}},
      {"the left half is woodland and the right half is cropland",
       kSuburb,
       {"dominant F@western half", "dominant A@eastern half"},
       {"dominant A@western half"}},
      {"Everything is grassland, except for a small pond at the top right.",
       kSuburb,
       {"dominant G", "present W@upper right"}},
      {"forest everywhere except in the south", kSuburb, {"dominant F", "absent F@southern third"}},
      // Counts.
      {"three lakes", kSuburb, {"count W 3..3"}},
      {"several ponds", kSuburb, {"count W 3.."}},
      {"a lake", kSuburb, {"present W"}, {"count W 1..1"}},
      {"a single lake", kSuburb, {"count W 1..1"}},
      {"copses: four of them", kSuburb, {"count F 4..4"}},
      {"two villages, one in the north and one in the south",
       kSuburb,
       {"count B 2..2", "present B@northern third", "present B@southern third"}},
      // Shapes.
      {"a round lake", kSuburb, {"shape W round"}},
      {"a lake shaped like a ring", kSuburb, {"shape W ring"}},
      {"A crescent-shaped forest lies in the east.", kSuburb, {"shape F bent"}},
      {"a straight road from west to east",
       kSuburb,
       {"shape R straight", "course R western edge>eastern edge"}},
      {"scattered houses", kSuburb, {"scattered B"}},
      // Courses.
      {"A river winds from the north to the south.",
       kSuburb,
       {"course W northern edge>southern edge", "shape W winding"}},
      {"a road from the lower left to the upper right",
       kSuburb,
       {"course R south-west corner>north-east corner"}},
      {"A river enters in the north-west and leaves in the south-east.",
       kSuburb,
       {"course W north-west corner>south-east corner"}},
      {"From the north to the south runs a river.",
       kSuburb,
       {"course W northern edge>southern edge"}},
      {"a creek flows from the upper left to the lower right through woodland",
       kWild,
       {"course W north-west corner>south-east corner", "through W F"}},
      {"a north-south road", kSuburb, {"course R northern edge>southern edge"}},
      {"Along the southern edge runs a road.", kSuburb, {"along R@southern edge"}},
      {"A river crosses the map from west to east and a road crosses it from north to south.",
       kSuburb,
       {"course W western edge>eastern edge", "course R northern edge>southern edge",
        "crosses R W"}},
      {"A town and a lake. A road connects the town with the lake.", kSuburb, {"connects R B W"}},
      {"two parallel streets from the left edge to the right edge",
       kSuburb,
       {"parallel R R", "course R western edge>eastern edge"}},
      {"The forest is cut in two by a road.", kSuburb, {"through R F"}},
      {"Going north: fields; then woods; then a lake.", kSuburb, {"order AFW>N"}},
      {"Seen from the top downward: snow, cliffs, pines.", kWild, {"order SRF>S"}},
      // What was said before is taken up.
      {"Keep lakes out. A village in the west.", kSuburb, {"absent W", "present B@western third"}},
      {"A green space (lawn) covers a third of the map, houses the rest.",
       kSuburb,
       {"amount G", "rest B"}},
      {"Three huts, scratch that, five.", kSuburb, {"count B 5..5"}},
      {"Two ponds, nothing else but woods.", kSuburb, {"count W 2..2", "rest F"}},
      {"Orchards should outweigh everything else in this picture.", kSuburb, {"dominant A"}},
      {"Town in the upper left, lake in the lower right, the other corners: woods.",
       kSuburb,
       {"present F@north-east corner", "present F@south-west corner"}},
      {"Streets in a grid in the south-west. Houses between.",
       kSuburb,
       {"present B@lower left", "adjacent B R"}},
      {"A road that does not cross the lake.",
       kSuburb,
       {"present R", "present W"},
       {"through R W"}},
      {"Two lakes: the northern one is round, the southern one is long.",
       kSuburb,
       {"count W 2..2", "present W@northern third", "present W@southern third"}},
      {"Four barns, one in each corner.",
       kSuburb,
       {"count B 4..4", "present B@north-west corner", "present B@south-east corner"}},
      {"There are three lakes. Each lies in the north.",
       kSuburb,
       {"count W 3..3", "present W@northern third"}},
      {"Water in the east, a village in the west.", kSuburb, {"present W@eastern third"}},
      {"Boulders: three separate fields.", kWild, {"count R 3..3"}},
      {"I need a park: lawn everywhere, a pond in the heart of it.", kSuburb, {"dominant G"}},
      {"Make the left third forest, the middle third fields and the right third water.",
       kSuburb,
       {"dominant F@western third", "dominant A@middle columns", "dominant W@eastern third"}},
      {"Cover 40 % with woods, 20 % with water and the rest with grass.",
       kSuburb,
       {"amount F", "amount W", "rest G"}},
      {"Fill the northern half with woods.", kSuburb, {"dominant F@northern half"}},
      {"Ponds in the south; no trees there.", kSuburb, {"absent F@southern third"}},
      {"A lake and two villages. The first village is in the north, the second one lies in the "
       "south.",
       kSuburb,
       {"count B 2..2", "present B@northern third", "present B@southern third"}},
      {"A river comes from the north-west and empties into a lake near the south-eastern corner.",
       kSuburb,
       {"present W@south-east corner"}},
      {"Trees frame the whole map.", kSuburb, {"present F@edges"}, {"dominant F"}},
      {"A wide river splits the map into a northern and a southern part.",
       kSuburb,
       {"course W western edge>eastern edge"}},
      // Relations.
      {"The houses must be at least five cells from the water.", kSuburb, {"apart B W"}},
      {"Fields north and south of the river.",
       kSuburb,
       {"both_sides A W", "direction A W N", "direction A W S"}},
      {"A lake in the centre. To the east and west of it lie woods.",
       kSuburb,
       {"direction F W E", "direction F W W"}},
      {"Where the road meets the river stands an inn.", kSuburb, {"adjacent B R", "adjacent B W"}},
      {"A road runs from north to south. Where it crosses the river there is a village.",
       kSuburb,
       {"crosses R W", "adjacent B R", "adjacent B W"}},
      {"A canyon from north to south, a stream in it.",
       kWild,
       {"course W northern edge>southern edge", "both_sides R W"}},
      {"A village next to a lake.", kSuburb, {"adjacent B W"}},
      {"next to the lake lies a village", kSuburb, {"adjacent B W"}},
      {"A lake in the middle of the map is surrounded by forest.",
       kSuburb,
       {"present W@center", "surrounds F W"},
       {"surrounds W F"}},
      {"In the center there is a village; around it are fields.", kSuburb, {"surrounds A B"}},
      {"houses on both sides of the river", kSuburb, {"both_sides B W"}},
      {"a river with houses on both sides", kSuburb, {"both_sides B W"}},
      {"The river is flanked by trees", kSuburb, {"both_sides F W"}},
      {"A forest with a lake in it.", kSuburb, {"within W F"}},
      {"a clearing in the forest", kSuburb, {"within G F"}},
      {"an island in the lake", kSuburb, {"within G W"}},
      {"a meadow sprinkled with ponds", kSuburb, {"within W G", "scattered W"}},
      {"A village north of the lake.", kSuburb, {"direction B W N"}},
      {"north of the lake there is a village", kSuburb, {"direction B W N"}},
      {"a lake with a village to its west", kSuburb, {"direction B W W"}},
      {"Behind the village lies a forest.", kSuburb, {"direction F B N"}},
      {"a forest between a lake and a village", kSuburb, {"between F W B"}},
      {"Between the village and the lake lies a forest.", kSuburb, {"between F B W"}},
      {"A stream separates the forest from the fields.", kSuburb, {"between W F A"}},
      {"The village is far away from the lake.", kSuburb, {"apart B W"}},
      {"More forest than farmland, please.", kSuburb, {"more_than F A"}},
      {"less water than forest", kSuburb, {"more_than F W"}},
      {"Houses line the road.", kSuburb, {"along B R"}},
      {"a road lined with trees", kSuburb, {"along F R"}},
      {"a riverside village", kSuburb, {"adjacent B W"}},
      {"Forest fringed with fields", kSuburb, {"adjacent A F"}},
      // Order.
      {"From north to south: snow, then rock, then forest",
       kWild,
       {"order SRF>S", "present S@northern third", "present F@southern third"}},
      {"West to east the country climbs: water, then scrub, then timber.", kWild, {"order WBF>E"}},
      // Denial.
      {"No roads.", kSuburb, {"absent R"}},
      {"without any buildings or trees", kSuburb, {"absent B", "absent F"}},
      {"no houses in the east", kSuburb, {"absent B@eastern third"}, {"absent B"}},
      {"a treeless plain", kSuburb, {"absent F", "present G"}},
      {"no roads and a lake", kSuburb, {"absent R", "present W"}, {"absent W"}},
      {"settlement: none", kSuburb, {"absent B"}},
      {"snow only in the upper right corner", kWild, {"located S@north-east corner"}},
      {"not a lake but a river", kSuburb, {"present W"}},
      // Discourse.
      {"There is a lake and there is a town. The former is in the east, the latter in the west.",
       kSuburb,
       {"present W@eastern third", "present B@western third"}},
      {"Two lakes in the south, no wait, make it three.", kSuburb, {"count W 3..3"}},
      {"A lake in the north. A village lies next to it.", kSuburb, {"adjacent B W"}},
      {"A town in the south-west, and a forest north of the town.", kSuburb, {"direction F B N"}},
      {"A road leads from the village to the lake; both are in the south.",
       kSuburb,
       {"connects R B W"}},
      {"instead of a lake, a village in the north",
       kSuburb,
       {"present B@northern third"},
       {"present W"}},
      {"the rest is farmland. a lake in the middle.", kSuburb, {"rest A", "present W@center"}},
      {"Lake in the north, fields everywhere else", kSuburb, {"rest A"}},
      {"A lake lies in the west and another in the east.",
       kSuburb,
       {"present W@western third", "present W@eastern third"}},
      {"Sand dominates, and there is a village in the south.",
       kSuburb,
       {"dominant D", "present B@southern third"}},
      {"A town on the west bank of the river, meadows on the opposite bank.",
       kSuburb,
       {"direction B W W", "direction G W E"}},
      {"A highway through a pine forest, nothing else.", kSuburb, {"rest F", "through R F"}},
      {"A hamlet in the center. A path connects the hamlet to the eastern edge.",
       kSuburb,
       {"course R center>eastern edge", "adjacent R B"}},
      {"Six small woods on a heath, none of them touching the edges of the map.",
       kWild,
       {"count F 6..6", "within F B", "absent F@edges"},
       {"present F@edges"}},
      {"A river runs from west to east. North of it is forest. South of it are fields.",
       kSuburb,
       {"direction F W N", "direction A W S"}},
      {"A road from the left to the right. Below that, fields. Above it, forest.",
       kSuburb,
       {"direction A R S", "direction F R N"}},
      {"In the middle a lake. To its left there is a village, to its right a wood.",
       kSuburb,
       {"direction B W W", "direction F W E"}},
      {"There are cottages among the trees and a pond.", kSuburb, {"within B F"}, {"within B W"}},
      {"a road going from up to down, houses on its right side",
       kSuburb,
       {"course R northern edge>southern edge", "direction B R E"}},
      {"Many trees, please. At least 40 percent.", kSuburb, {"amount F"}, {"count F 4.."}},
      {"A lake in the upper right and, between the lake and the bottom edge, a small village.",
       kSuburb,
       {"present W@upper right", "direction B W S"}},
      {"The southern third is a lake.", kWild, {"dominant W@southern third"}},
      {"A parking lot in the south-west. To the north-east there is a mall. In between are "
       "streets.",
       kSuburb,
       {"present B@upper right", "between R D B"}},
      {"A river splits the map into an eastern and a western half.",
       kSuburb,
       {"course W northern edge>southern edge"}},
      {"Snow in the north, a tarn in the south, trees in between, no rocks.",
       kWild,
       {"between F S W", "absent R"}},
      {"The north is snow. The south is forest. Where they meet, rocks.", kWild, {"between R S F"}},
      {"Bare soil in the middle, about a quarter of the map, and grass all around.",
       kSuburb,
       {"present D@center", "amount D", "dominant G"}},
      {"A town in the center with fields around it. A river flows past the town on its west side.",
       kSuburb,
       {"direction W B W"},
       {"direction W A W"}},
      {"Forest except for a clearing in the middle.", kWild, {"dominant F", "present B@center"}},
      {"A wood along the western edge, a river along the eastern edge, between them meadows.",
       kSuburb,
       {"between G F W"},
       {"present G@eastern edge"}},
      {"A forest covers everything but the southeast, which is a lake.",
       kSuburb,
       {"dominant F", "dominant W@lower right", "absent F@lower right"}},
      {"Fields everywhere but in the north.", kSuburb, {"dominant A", "absent A@northern third"}},
      {"Blocks of houses separated by streets that form a cross, trees along the streets",
       kSuburb,
       {"along F R"},
       {"through R F"}},
      {"A lake on the left. On its eastern shore, a town. A road leaves the town heading east.",
       kSuburb,
       {"direction B W E", "adjacent R B", "present R@eastern edge"},
       {"present B@eastern third"}},
      {"A ridge runs from the west to the east. To the north of it, snow; to the south, forest.",
       kWild,
       {"direction S R N", "direction F R S"}},
      {"the west third should be forest, the middle third town, the east third water",
       kSuburb,
       {"dominant B@middle columns"}},
      {"A house stands in each of the four quarters.",
       kSuburb,
       {"present B@north-western quarter", "present B@south-eastern quarter"},
       {"amount B"}},
      {"Sea at the bottom, sand above it, then a road, then houses.",
       kSuburb,
       {"direction D W N", "direction R D N", "direction B R N"}},
      {"Only snow and rocks. The rocks form a ring.", kWild, {"rest S", "shape R ring"}},
      {"No forest north of the river.", kSuburb, {"present W"}, {"absent F"}},
      {"A town in the east, linked with the lake in the west by a straight road.",
       kSuburb,
       {"connects R B W", "shape R straight"}},
      {"A river through the jungle. A sandbank? No.", kWild, {"absent R", "through W F"}},
      {"flat grass, a few trees here and there and a dirt road bending from left to top",
       kSuburb,
       {"shape R winding", "course R western edge>northern edge"},
       {"shape F winding", "shape G winding"}},
      {"The north is urban, the southern part is full of fields.",
       kSuburb,
       {"present B@northern third", "present A@southern third"},
       {"present B@southern third"}},
      {"3 ponds in a row from west to east, forest north of them, fields south of them.",
       kSuburb,
       {"count W 3..3", "present W@middle rows", "direction F W N", "direction A W S"}},
      {"Fill the map with forest. Cut a clearing in the NE corner.",
       kWild,
       {"dominant F", "present B@north-east corner"}},
      {"Fill the southern half with water and the rest with grass.",
       kSuburb,
       {"dominant W@southern half", "rest G"}},
      {"I need: 1) forest, upper left 2) lake, lower right 3) a road from one to the other",
       kSuburb,
       {"present F@upper left", "present W@lower right", "connects R F W"},
       {"count W 2..2"}},
      {"Fields dominate the east while woods dominate the west; a brook separates them.",
       kSuburb,
       {"dominant A@eastern third", "between W A F"}},
      {"A road runs along the top and then down the right side.",
       kSuburb,
       {"course R north-west corner>south-east corner", "present R@north-east corner"}},
      {"A lake fills the foreground, with pines on its far shore.", kSuburb, {"direction F W N"}},
      {"vilage in teh top rigth corner", kSuburb, {"present B@north-east corner"}},
  };
}

class ReadingSamples : public testing::TestWithParam<Sample> {};

TEST_P(ReadingSamples, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(ReadingSamples, ReadsTheSameInCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Voices, ReadingSamples, testing::ValuesIn(Samples()));

const LayoutPlan Read(const std::string& instruction, Vocabulary vocabulary = kSuburb) {
  return ParseLayoutInstruction(instruction, vocabulary);
}

TEST(ReadingTest, SensesAreAllKnownAndSaidOnce) {
  EXPECT_EQ(Listed(CheckSenses(SenseFile())), "");
  EXPECT_NE(Listed(CheckSenses("nonsense: a")), "");
  EXPECT_NE(Listed(CheckSenses("and: plus | plus")), "");
  EXPECT_NE(Listed(CheckSenses("and: plus |")), "");
}

TEST(ReadingTest, ClaimsFollowFromThePlanAlone) {
  const LayoutPlan plan = Read("Three lakes in the north, a village south of them, no roads.");
  std::vector<std::string> again;
  for (const Claim& claim : ClaimsOfPlan(plan)) again.push_back(Show(claim));
  EXPECT_EQ(Claims(plan), again);
}

TEST(ReadingTest, EveryClaimRemembersItsWords) {
  const std::string text = "A round lake in the north. East of it a forest, and no roads.";
  for (const Claim& claim : Read(text).claims) {
    ASSERT_FALSE(claim.words.empty()) << Show(claim);
    EXPECT_NE(text.find(claim.words), std::string::npos) << claim.words;
  }
}

TEST(ReadingTest, KeepsWhatIsNotUnderstood) {
  EXPECT_EQ(Read("a forest with purple spaceships").not_understood,
            std::vector<std::string>({"purple spaceships"}));
  EXPECT_TRUE(Read("Could you please draw a forest in the north, thank you very much!")
                  .not_understood.empty());
}

TEST(ReadingTest, WarnsOfWhatTheVocabularyLacks) {
  const LayoutPlan plan = Read("a forest and a castle", kWild);
  ASSERT_EQ(plan.warnings.size(), 1u);
  EXPECT_NE(plan.warnings[0].find("castle"), std::string::npos);
}

TEST(ReadingTest, WarnsOfCorrectedSpelling) {
  const LayoutPlan plan = Read("a vilage in the north");
  ASSERT_EQ(plan.warnings.size(), 1u);
  EXPECT_NE(plan.warnings[0].find("\"vilage\""), std::string::npos) << plan.warnings[0];
  EXPECT_NE(plan.warnings[0].find("village"), std::string::npos) << plan.warnings[0];
}

TEST(ReadingTest, TheLaterOfTwoSentencesWins) {
  const LayoutPlan denied = Read("A lake in the center. There must be no water.");
  EXPECT_EQ(Claims(denied), std::vector<std::string>({"absent W"}));
  ASSERT_FALSE(denied.warnings.empty());
  EXPECT_NE(denied.warnings[0].find("lake"), std::string::npos) << denied.warnings[0];
  const LayoutPlan moved = Read("A lake in the north. The lake is in the south.");
  EXPECT_EQ(Claims(moved), std::vector<std::string>({"present W@southern third"}));
}

TEST(ReadingTest, WhatIsSaidAgainIsReadOnce) {
  const std::string once = "A lake lies in the north of the map. ";
  const LayoutPlan plan = Read(once + once + once);
  EXPECT_EQ(Claims(plan), Claims(Read(once)));
  EXPECT_EQ(plan.features.size(), 1u);
  ASSERT_EQ(plan.warnings.size(), 1u);
  EXPECT_NE(plan.warnings[0].find("A lake lies"), std::string::npos);
}

TEST(ReadingTest, BackgroundIsALetterOfTheVocabularyThatNobodyDenied) {
  EXPECT_EQ(Read("a lake").background, 'G');
  EXPECT_EQ(Read("a lake", kWild).background, 'B');
  EXPECT_EQ(Read("no grass, a lake").background, 'A');
  EXPECT_EQ(Read("The rest is forest. A lake.").background, 'F');
  EXPECT_EQ(Read("mostly farmland").background, 'A');
  // Nothing is said of what the rest is, and it is no grass.
  EXPECT_EQ(Read("Grass takes up about 75 % of the land.").background, 'A');
  EXPECT_EQ(Read("Mostly grass, about 80 %, and a lake.").background, 'A');
  EXPECT_EQ(Read("Two thirds grass, the rest forest.").background, 'F');
}

bool IsSound(const LayoutPlan& plan) {
  const int count = static_cast<int>(plan.features.size());
  const auto legal = [&](int index) { return index >= 0 && index < count; };
  bool sound = FindClass(plan.vocabulary, plan.background) != nullptr;
  for (const PlannedFeature& feature : plan.features) {
    sound = sound && FindClass(plan.vocabulary, feature.letter) != nullptr && feature.cells > 0;
    for (const std::optional<Waypoint>* end : {&feature.from, &feature.to}) {
      if (end->has_value()) sound = sound && (*end)->feature < count;
    }
    for (const Waypoint& via : feature.via) sound = sound && via.feature < count;
  }
  for (const PlannedRelation& relation : plan.relations) {
    sound = sound && legal(relation.subject) && legal(relation.object) &&
            relation.second_object < count;
  }
  for (const PlannedOrder& order : plan.orders) {
    for (const int index : order.features) sound = sound && legal(index);
  }
  return sound;
}

TEST(ReadingTest, WordSaladGivesASoundPlan) {
  const std::vector<std::string> words = {"forest",
                                          "no",
                                          "the",
                                          "rest",
                                          "is",
                                          "lake",
                                          "between",
                                          "and",
                                          "north",
                                          "of",
                                          "from",
                                          "to",
                                          "river",
                                          "surrounded by",
                                          "mostly",
                                          "three",
                                          "ponds",
                                          ",",
                                          ".",
                                          "in",
                                          "upper left",
                                          "road",
                                          "runs",
                                          "through",
                                          "connects",
                                          "more",
                                          "than",
                                          "without",
                                          "xyzzy",
                                          "999999999",
                                          "edges",
                                          "snow",
                                          "village",
                                          "around",
                                          "scattered",
                                          "middle",
                                          "'",
                                          "-",
                                          "(",
                                          "everywhere",
                                          "treeless",
                                          "west",
                                          "half",
                                          "a few",
                                          "dozen",
                                          "next to",
                                          "it",
                                          "winding",
                                          "with",
                                          "but",
                                          "they",
                                          "one",
                                          "the other",
                                          "which",
                                          "except",
                                          "instead of",
                                          "actually",
                                          "scratch that",
                                          "not",
                                          "only",
                                          "both sides of",
                                          "its shore",
                                          "from west to east",
                                          "50 %",
                                          "former",
                                          "round",
                                          "parallel",
                                          "crosses",
                                          "where",
                                          "otherwise"};
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    RandomStream random(seed, "salad");
    std::string text = "a";
    const int length = random.UniformInt(1, 60);
    for (int i = 0; i < length; ++i) {
      text +=
          " " +
          words[static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(words.size()) - 1))];
    }
    const Vocabulary vocabulary = random.Chance(0.5) ? kSuburb : kWild;
    EXPECT_TRUE(IsSound(ParseLayoutInstruction(text, vocabulary))) << text;
  }
}

TEST(ReadingTest, ReadsTheLongestInstructionsOnce) {
  std::string text;
  int number = 0;
  while (text.size() + 60 < kMaxInstructionBytes) {
    text += "A lake " + std::to_string(++number) + " in the north, woods, no snow and it; ";
  }
  EXPECT_TRUE(IsSound(Read(text)));
  std::string noise;
  RandomStream random(1, "noise");
  while (noise.size() < kMaxInstructionBytes) {
    noise += static_cast<char>(random.UniformInt(1, 126));
  }
  EXPECT_TRUE(IsSound(Read(noise)));
}

}  // namespace
}  // namespace latticeworld
