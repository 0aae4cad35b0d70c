#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Ways around things, islands in rivers, things of one name in two places, and sides of one owner.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb, kWild = Vocabulary::kWild;

std::vector<Sample> Detours() {
  return {
      {"Put a big lake in the center and a road that goes all the way around it.",
       kSuburb,
       {"surrounds R W", "shape R ring"}},
      {"Two towns in the bottom corners, joined by a highway that bends north around a lake.",
       kSuburb,
       {"direction R W N"},
       {"surrounds B W", "shape R bent"}},
      {"A round lake in the middle, a ring of rock around it, and forest outside.",
       kWild,
       {"surrounds R W", "surrounds F R"}},
      {"A river winds through a forest.", kSuburb, {"shape W winding", "through W F"}},
      {"A road meanders through fields from west to east.",
       kSuburb,
       {"shape R winding", "through R A", "course R western edge>eastern edge"}},
  };
}

std::vector<Sample> Islands() {
  return {
      {"A winding river from north to south with a wooded island in it.",
       kSuburb,
       {"within F W", "shape W winding", "course W northern edge>southern edge"}},
      {"A river flows in from the north edge, splits in two around a wooded island and leaves on "
       "the south edge.",
       kSuburb,
       {"within F W", "course W northern edge>southern edge"},
       {"count W 2..2"}},
      {"A lake with three small islands, each with trees on it.",
       kSuburb,
       {"within F W", "count F 3..3"}},
      {"A house on an island in a big lake.",
       kSuburb,
       {"within B G", "within G W"},
       {"within B W"}},
  };
}

std::vector<Sample> Namesakes() {
  return {
      {"A dirt road leads from the farm in the north to the farm in the south.",
       kSuburb,
       {"present A@northern third", "present A@southern third", "connects R A A"}},
      {"The village in the east and the village in the west are connected by a road.",
       kSuburb,
       {"connects R B B"}},
      {"A road from the left edge to the village in the middle and another one from the village to "
       "the bottom edge.",
       kSuburb,
       {"course R western edge>center", "course R center>southern edge"},
       {"present B@southern edge"}},
      {"A hedge of trees runs between two fields.", kSuburb, {"between F A A"}},
      {"Bushland with three lonely groves of trees.", kWild, {"count F 3..3"}},
      {"Scatter some trees over the meadow.", kSuburb, {"scattered F", "within F G"}},
  };
}

std::vector<Sample> Owners() {
  return {
      {"A lake in the centre with forest on the north side of it and fields on the south side.",
       kSuburb,
       {"direction F W N", "direction A W S"},
       {"present A@southern third"}},
      {"A road from north to south. Fields on the west side of the road, forest on the east.",
       kSuburb,
       {"direction A R W", "direction F R E"},
       {"present F@eastern third"}},
      {"The river runs north to south, with a village on its left bank about halfway down.",
       kSuburb,
       {"direction B W W", "adjacent B W"}},
      {"Snowy mountains in the north, a forest at their foot and low bushes in the south.",
       kWild,
       {"adjacent F S", "present B@southern third"},
       {"present F@southern third"}},
      {"Snow only on the highest part in the upper right.",
       kWild,
       {"located S@upper right"},
       {"present S@northern quarter"}},
      {"Snow on the west, snow on the east, and a green valley in between with a river along it.",
       kWild,
       {"between B S S", "along W B"}},
  };
}

std::vector<Sample> Walks() {
  return {
      {"Coming from the west you first cross fields, then a river, then you reach the town and "
       "behind it the desert begins.",
       kSuburb,
       {"order AWBD>E"}},
      {"Going north the grass gives way to bushes, then rocks, and finally snow.",
       kWild,
       {"order BRS>N"}},
      {"A road enters at the top left corner, runs down to the middle, and then goes straight to "
       "the right edge.",
       kSuburb,
       {"course R north-west corner>eastern edge", "present R@center"},
       {"shape R straight"}},
      {"A motorway comes in from the left, turns in the middle and leaves at the bottom.",
       kSuburb,
       {"course R western edge>southern edge", "shape R bent"}},
      {"A wall of rock runs right across the map from west to east, cutting the forest in two.",
       kWild,
       {"course R western edge>eastern edge", "through R F"},
       {"dominant R"}},
  };
}

std::vector<Sample> Spreads() {
  return {
      {"Several small ponds dotted around the meadow, all of them near the road.",
       kSuburb,
       {"within W G", "count W 3..", "adjacent W R"},
       {"scattered G"}},
      {"More forest than anything else, and a lake.", kSuburb, {"dominant F"}},
      {"The lake is bordered by forest on its west side and by rocks on its east side.",
       kWild,
       {"direction F W W", "direction R W E"},
       {"direction W F W", "direction R F E"}},
      {"A village with woods to the north; to the south it's open fields.",
       kSuburb,
       {"direction F B N", "direction A B S"},
       {"present A@southern third"}},
  };
}

std::vector<Sample> Others() {
  return {
      {"The north-east and south-west quarters are forest, the other two are grass.",
       kSuburb,
       {"present F@north-eastern quarter", "present F@south-western quarter",
        "present G@north-western quarter", "present G@south-eastern quarter"},
       {"present F@north-western quarter"}},
      {"The north and south edges are forest and the other two are water.",
       kSuburb,
       {"present F@northern edge", "present W@eastern edge"},
       {"present F@western edge"}},
      {"A narrow road starts in the south, makes two sharp turns and ends in the north.",
       kSuburb,
       {"shape R bent", "course R southern edge>northern edge"},
       {"count R 2..2"}},
      {"A mill stands where the brook flows into the lake. The lake is in the south.",
       kSuburb,
       {"adjacent B W"}},
      {"A small wood at the left edge, a bigger one at the right edge, and between the two a "
       "village.",
       kSuburb,
       {"between B F F"},
       {"count B 2..2"}},
      {"A large open meadow with one building in the far corner, bottom right.",
       kSuburb,
       {"present B@south-east corner"},
       {"present B@corners"}},
  };
}

class PlainPlacesTest : public testing::TestWithParam<Sample> {};

TEST_P(PlainPlacesTest, AreRead) {
  ExpectRead(GetParam());
  ExpectReadInCapitals(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Detours, PlainPlacesTest, testing::ValuesIn(Detours()));
INSTANTIATE_TEST_SUITE_P(Islands, PlainPlacesTest, testing::ValuesIn(Islands()));
INSTANTIATE_TEST_SUITE_P(Namesakes, PlainPlacesTest, testing::ValuesIn(Namesakes()));
INSTANTIATE_TEST_SUITE_P(Owners, PlainPlacesTest, testing::ValuesIn(Owners()));
INSTANTIATE_TEST_SUITE_P(Walks, PlainPlacesTest, testing::ValuesIn(Walks()));
INSTANTIATE_TEST_SUITE_P(Others, PlainPlacesTest, testing::ValuesIn(Others()));
INSTANTIATE_TEST_SUITE_P(Spreads, PlainPlacesTest, testing::ValuesIn(Spreads()));

}  // namespace
}  // namespace latticeworld
