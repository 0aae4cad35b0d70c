#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// People in a hurry, people whose first language is another, and gaps between things of one kind.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Manners() {
  return {
      {"The road is going from the north to the south.",
       kSuburb,
       {"course R northern edge>southern edge"}},
      {"Trees are standing along the river.", kSuburb, {"along F W"}},
      {"The lake is going to be in the north.", kSuburb, {"present W@northern third"}},
      {"At north from lake is standing town.", kSuburb, {"direction B W N"}},
      {"At the right from the village there are fields.", kSuburb, {"direction A B E"}},
      {"In the south from the tarn is lying a wood.", kWild, {"direction F W S"}},
      {"The road leads in the north from the village to the lake.",
       kSuburb,
       {"connects R B W"},
       {"direction R B N"}},
      {"A lake. Everything that I haven't mentioned is meadow.", kSuburb, {"rest G"}, {"absent G"}},
      {"At least four groups of houses, none of them holding most of the houses, in the fields.",
       kSuburb,
       {"count B 4.."},
       {"absent B"}},
      {"Roads should not exist in this world.", kSuburb, {"absent R"}, {"present R"}},
      {"Forests must not appear on the map at all.", kSuburb, {"absent F"}, {"present F"}},
      {"The roads should not exist in the forest.", kSuburb, {"present F"}, {"absent R"}},
      {"A lake, long rather than round.", kSuburb, {"shape W elongated"}, {"shape W round"}},
      {"Put exactly four ponds into the grass, each of them separate from the others.",
       kSuburb,
       {"count W 4..4", "within W G"},
       {"rest W"}},
      {"The houses are lying on the both sides of the road.", kSuburb, {"both_sides B R"}},
  };
}

std::vector<Sample> Gaps() {
  return {
      {"Two lakes at least five cells apart.", kSuburb, {"apart W W", "count W 2..2"}},
      {"Two lakes. They are at least 5 cells apart.", kSuburb, {"apart W W", "count W 2..2"}},
      {"The lakes must be five cells or more apart.", kSuburb, {"apart W W"}, {"count W 5..5"}},
      {"Three villages, six or more cells from each other.",
       kSuburb,
       {"apart B B", "count B 3..3"}},
      {"Two forests with a distance of at least five cells between them.",
       kWild,
       {"apart F F", "count F 2..2"}},
      {"Two lakes, at least a distance of four cells must be there.",
       kSuburb,
       {"apart W W", "count W 2..2"}},
      {"Two lakes, they may not be connected.", kSuburb, {"apart W W"}},
      {"Two villages far from each other.", kSuburb, {"apart B B"}},
      {"Four ponds that keep their distance from one another.",
       kSuburb,
       {"apart W W", "count W 4..4"},
       {"present B"}},
      {"The lake and the village are at least five cells apart.",
       kSuburb,
       {"apart W B"},
       {"apart W W"}},
      {"Houses set apart from the road.", kSuburb, {"apart B R"}, {"apart B B"}},
      {"Apart from a lake there is only forest.", kSuburb, {"rest F"}, {"apart W W"}},
      {"The town lies apart, in the north.", kSuburb, {"present B@northern third"}, {"apart B B"}},
  };
}

class PlainMannersTest : public testing::TestWithParam<Sample> {};
TEST_P(PlainMannersTest, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainMannersTest, ReadsCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Manners, PlainMannersTest, testing::ValuesIn(Manners()));
INSTANTIATE_TEST_SUITE_P(Gaps, PlainMannersTest, testing::ValuesIn(Gaps()));

}  // namespace
}  // namespace latticeworld
