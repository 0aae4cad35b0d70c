#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Banks, flanks and crossings, rows of things, and second thoughts.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Banks() {
  return {
      {"The river from north to south splits the land into a western part, all forest, and an "
       "eastern part, all fields.",
       kSuburb,
       {"course W northern edge>southern edge", "direction F W W", "direction A W E"}},
      {"The river splits the map into two halves; the left one is farmland and the right one is "
       "forest.",
       kSuburb,
       {"direction A W W", "direction F W E"},
       {"count W"}},
      {"A road divides the land in two, with the northern half all woods and the southern half all "
       "fields.",
       kSuburb,
       {"direction F R N", "direction A R S"},
       {"count R"}},
      {"A river from west to east. The town lies on the southern bank only.",
       kSuburb,
       {"direction B W S"},
       {"dominant B"}},
      {"A river. North and south of it the land is wooded.",
       kSuburb,
       {"direction F W N", "direction F W S"}},
      {"Houses along one road, and behind the houses, on both sides, long fields.",
       kSuburb,
       {"both_sides A R"},
       {"both_sides R B"}},
      {"A road from north to south. Its western side is wooded, its eastern side is not: there are "
       "only fields.",
       kSuburb,
       {"direction F R W"},
       {"direction F R E"}},
      {"From the tower in the middle you look north over a lake and south over fields.",
       kSuburb,
       {"direction W B N", "direction A B S"}},
  };
}

std::vector<Sample> Shores() {
  return {
      {"The village is on the left bank, the castle on the right one. The river runs from top to "
       "bottom.",
       kSuburb,
       {"direction B W W", "direction B W E"}},
      {"A lake whose northern shore is wooded and whose southern shore is built up.",
       kSuburb,
       {"direction F W N", "direction B W S"}},
      {"A big pond, forest on its western side, meadow on the east.",
       kSuburb,
       {"direction F W W", "direction G W E"}},
      {"South of the road it's all houses, north of it all fields.",
       kSuburb,
       {"direction B R S"},
       {"direction A B N"}},
      {"The hut is surrounded by fields on three sides; the fourth, the eastern, is forest.",
       kSuburb,
       {"direction F B E"},
       {"amount F"}},
  };
}

std::vector<Sample> Flanks() {
  return {
      {"The village lies against the wood, and on the village's other side, to the south, there "
       "are fields.",
       kSuburb,
       {"adjacent B F", "direction A B S"},
       {"present B@southern third"}},
      {"A town. On its one flank, to the east, a forest; on the other flank, to the west, a lake.",
       kSuburb,
       {"direction F B E", "direction W B W"}},
      {"A road. West of the road there is forest, on the other side of it houses.",
       kSuburb,
       {"direction F R W", "direction B R E"}},
      {"A river: what lies north of it is forest, what lies south of it is farmland. It runs from "
       "west to east.",
       kSuburb,
       {"direction F W N", "direction A W S", "course W western edge>eastern edge"}},
      {"Two lakes. The higher one lies in a wood, the lower one in a meadow.",
       kSuburb,
       {"count W 1..1@northern third", "count W 1..1@southern third"}},
      {"Rock on the right: the sea at the very edge.",
       kWild,
       {"present W@eastern edge"},
       {"present W@edges"}},
  };
}

std::vector<Sample> Joins() {
  return {
      {"A mill stands where the river and the road cross.",
       kSuburb,
       {"adjacent B W", "adjacent B R", "crosses W R"}},
      {"A road runs from west to east and a river from north to south. A mill stands where they "
       "meet.",
       kSuburb,
       {"adjacent B R", "adjacent B W"},
       {"between B R W"}},
      {"Between the two woods, one in the west, one in the east, lies a long lake.",
       kSuburb,
       {"between W F F", "present F@western third", "present F@eastern third"}},
      {"The lake is ringed by rock, and the rock by forest.",
       kWild,
       {"surrounds R W", "surrounds F R"}},
      {"A bypass swings around the town to the east.", kSuburb, {"direction R B E"}},
      {"A lake top right, a village bottom left, a road between them.",
       kSuburb,
       {"connects R W B", "course R upper right>lower left"}},
      {"Two bands of forest, one in the north and one in the south, a road between them.",
       kSuburb,
       {"between R F F"},
       {"connects R F F"}},
      {"Two villages, one in the north and one in the south. A lane links the pair.",
       kSuburb,
       {"connects R B B"},
       {"count R 2..2"}},
      {"Roads in the shape of an X.",
       kSuburb,
       {"course R north-west corner>south-east corner",
        "course R north-east corner>south-west corner"}},
      {"Draw a T of roads: the bar along the top, the stem down to the bottom edge. West of the "
       "stem, fields.",
       kSuburb,
       {"course R western edge>eastern edge", "direction A R W"},
       {"absent R@northern edge"}},
  };
}

std::vector<Sample> Corrections() {
  return {
      {"Put the barn at the left edge, I mean right edge, with fields around it.",
       kSuburb,
       {"present B@eastern edge"},
       {"present B@western edge"}},
      {"Half forest, half meadow, split left and right, forest on the right. Sorry, on the left.",
       kSuburb,
       {"present F@western third"},
       {"present F@eastern third"}},
      {"Three villages in a row from west to east. Wait, north to south is better.",
       kSuburb,
       {"count B 3..3", "present B@middle columns"}},
      {"A river from north to south. Actually, make it from west to east.",
       kSuburb,
       {"course W western edge>eastern edge"}},
      {"Four houses, no, five houses, near the lake.", kSuburb, {"count B 5..5", "adjacent B W"}},
      {"A road along the top edge, or rather the bottom edge.", kSuburb, {"along R@southern edge"}},
      // These take nothing back.
      {"A village in the north, no roads, a lake in the south.",
       kSuburb,
       {"present B@northern third", "present W@southern third", "absent R"}},
  };
}

std::vector<Sample> Rows() {
  return {
      {"A wood, a lake and a village lie in a row from west to east.", kSuburb, {"order FWB>E"}},
      {"Village, lake and wood in a row, the lake in the middle and the village westernmost.",
       kSuburb,
       {"order BWF>E"},
       {"present F@center"}},
      {"Fields, a road and a wood in a line from top to bottom.", kSuburb, {"order ARF>S"}},
  };
}

std::vector<Sample> Grounds() {
  return {
      {"Houses all over the southern half; leave the northern half to the woods.",
       kSuburb,
       {"dominant F@northern half"}},
      {"Quarter it: wheat in the NW, trees in the NE, houses in the SW, a lake in the SE.",
       kSuburb,
       {"dominant A@north-western quarter", "present W@south-eastern quarter"}},
      {"A third of the map is water. The water is all on the left.",
       kSuburb,
       {"amount W", "present W@western third"}},
      {"A big forest with a small lake inside and 2 huts next to the lake.",
       kSuburb,
       {"within W F", "adjacent B W"},
       {"within W B"}},
      {"A road from top to bottom. Wherever it is not road, it is forest.",
       kSuburb,
       {"course R northern edge>southern edge"},
       {"absent R"}},
      {"No houses, except one, by the lake in the east.",
       kSuburb,
       {"count B 1..1", "adjacent B W"},
       {"absent B"}},
      {"Equal parts of forest and fields, and a village where they meet.",
       kSuburb,
       {"amount F", "amount A", "between B F A"},
       {"amount B"}},
      // Parks would not show on grass.
      {"Two parks, one in the west and one in the east.",
       kSuburb,
       {"count G 2..2", "count G 1..1@western third"}},
  };
}

class PlainSides : public testing::TestWithParam<Sample> {};

TEST_P(PlainSides, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainSides, ReadsTheSameInCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Banks, PlainSides, testing::ValuesIn(Banks()));
INSTANTIATE_TEST_SUITE_P(Shores, PlainSides, testing::ValuesIn(Shores()));
INSTANTIATE_TEST_SUITE_P(Flanks, PlainSides, testing::ValuesIn(Flanks()));
INSTANTIATE_TEST_SUITE_P(Joins, PlainSides, testing::ValuesIn(Joins()));
INSTANTIATE_TEST_SUITE_P(Corrections, PlainSides, testing::ValuesIn(Corrections()));
INSTANTIATE_TEST_SUITE_P(Rows, PlainSides, testing::ValuesIn(Rows()));
INSTANTIATE_TEST_SUITE_P(Grounds, PlainSides, testing::ValuesIn(Grounds()));

}  // namespace
}  // namespace latticeworld
