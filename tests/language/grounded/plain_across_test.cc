#include <gtest/gtest.h>

#include <vector>

#include "latticeworld/layout/vocabulary.h"
#include "reading_sample.h"

// What lies across, beside or on a side of a thing, and is not said of the whole map.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Across() {
  return {
      {"A lake and a small village on opposite sides of the map.",
       kSuburb,
       {"apart W B"},
       {"present W@western third", "present B@western third"}},
      {"At opposite ends of the map there are a farm and a wood.", kSuburb, {"apart A F"}},
      {"Two hamlets at opposite ends of the map.", kSuburb, {"count B 2..2"}, {"apart B B"}},
      {"On opposite banks of the river lie a farm and a forest.", kSuburb, {"between W A F"}},
      {"A road with fields and a wood on opposite sides.", kSuburb, {"between R A F"}},
      {"Two hamlets on opposite banks of a stream.", kSuburb, {"both_sides B W"}},
      {"Two villages facing one another across a river.",
       kSuburb,
       {"both_sides B W", "count B 2..2"},
       {"within B W"}},
      {"The snow faces the forest across the rock.", kWild, {"between R S F"}, {"within S R"}},
      {"Across the lake from the village there is a farm.", kSuburb, {"between W B A"}},
      {"The wood lies on the other side of the road from the houses.", kSuburb, {"between R F B"}},
      {"Opposite the farm, on the far bank of the river, is a wood.", kSuburb, {"between W A F"}},
      {"Opposite the farm there is a wood.", kSuburb, {"adjacent F A"}, {"between W A F"}},
      {"A path across the river from the town to the forest.",
       kSuburb,
       {"crosses R W", "connects R B F"}},
      {"A stream with fields on the near bank and a wood on the far bank.",
       kSuburb,
       {"between W A F"},
       {"present A@southern third", "present F@northern third"}},
      {"A ridge cuts the lake off from the forest.", kWild, {"between R W F"}, {"within R W"}},
      {"The lake cuts off the farm from the houses.", kSuburb, {"between W A B"}},
      {"The river cuts the town in two.", kSuburb, {"both_sides B W"}, {"between W B B"}},
      {"A wood should screen the village from the road.", kSuburb, {"between F B R"}},
      {"Trees hide the road from view.", kSuburb, {"present F", "present R"}},
      {"The farm is cut off from the rest of the map by a wood.",
       kSuburb,
       {"adjacent A F"},
       {"rest A"}},
      {"A stream runs between the woods and the fields.",
       kSuburb,
       {"between W F A"},
       {"connects W F A"}},
      {"A road runs between two ponds.", kSuburb, {"between R W W"}, {"connects R W W"}},
      {"A road runs between the farm and the village.", kSuburb, {"connects R A B"}},
      {"A road comes in from the west, passes between two woods and leaves in the east.",
       kSuburb,
       {"between R F F", "course R western edge>eastern edge"}},
  };
}

std::vector<Sample> OnlyThere() {
  return {
      {"Beyond the river, nothing but woods.", kSuburb, {"adjacent F W"}, {"dominant F"}},
      {"Along the road there are only fields.", kSuburb, {"along A R"}, {"dominant A", "amount A"}},
      {"Around the village there is nothing but meadow.",
       kSuburb,
       {"surrounds G B"},
       {"amount G", "dominant G"}},
      {"Behind the houses there is only forest.",
       kSuburb,
       {"direction F B N"},
       {"amount F@northern third"}},
      {"Nothing but grass between the lake and the town.",
       kSuburb,
       {"between G W B"},
       {"dominant G"}},
      {"There is nothing between the lake and the town but grass.", kSuburb, {"between G W B"}},
      {"Around the lake no trees, only meadow.",
       kSuburb,
       {"surrounds G W"},
       {"absent F", "rest G"}},
      {"Only forest.", kSuburb, {"dominant F", "amount F"}},
      {"In the north there is only forest.", kSuburb, {"amount F@northern third"}},
      {"A town in the middle. Beyond the houses nothing but fields.", kSuburb, {"rest A"}},
  };
}

std::vector<Sample> Contrasts() {
  return {
      {"I want a pond, not a river, in the east.",
       kSuburb,
       {"present W@eastern third"},
       {"absent W", "absent W@eastern third"}},
      {"A lake in the south, not a river.", kSuburb, {"present W@southern third"}, {"absent W"}},
      {"A lake, no houses, in the center.",
       kSuburb,
       {"present W@center", "absent B"},
       {"absent B@center"}},
      {"The north is forest, not grass, and the south is water.",
       kSuburb,
       {"absent G@northern third"}},
      {"Not a village but a farm by the lake.", kSuburb, {"adjacent A W"}, {"present B"}},
      {"A farm without any houses next to it.", kSuburb, {"apart B A"}, {"absent B"}},
      {"A lake with no forest nearby.", kSuburb, {"apart F W"}, {"absent F"}},
      {"A forest in the north and a village with no forest in the south.",
       kSuburb,
       {"present F@northern third"},
       {"apart F B"}},
      {"The two villages are not connected by a road.", kSuburb, {"count B 2..2"}, {"apart B R"}},
      {"A farm by a wood, but not surrounded by it.", kSuburb, {"adjacent A F"}, {"surrounds F A"}},
      {"Once there was a village here, now there is only forest.",
       kSuburb,
       {"dominant F"},
       {"present B"}},
  };
}

std::vector<Sample> Vantage() {
  return {
      {"A village lies behind the lake, seen from the east.",
       kSuburb,
       {"direction B W W"},
       {"present B@eastern third"}},
      {"Seen from the south, a wood stands in front of the lake.", kSuburb, {"direction F W S"}},
      {"Fields surround the town, except to the north.",
       kSuburb,
       {"surrounds A B"},
       {"absent A@northern third"}},
      {"The forest surrounds the lake except on the west, where there is a town.",
       kSuburb,
       {"surrounds F W", "direction B W W"},
       {"present B@western third"}},
      {"Two mountains with snow on top.", kWild, {"within S R"}, {"present S@northern third"}},
      {"Rock with snow on top and forest at the bottom.", kWild, {"present S@northern third"}},
      {"A road passes the village on the west.",
       kSuburb,
       {"direction R B W"},
       {"present B@western third"}},
      {"The town overlooks a lake to the south.",
       kSuburb,
       {"direction W B S", "adjacent B W"},
       {"present B@southern third"}},
      {"A farm beside a lake to the east of the wood.", kSuburb, {"direction A F E"}},
      {"A village next to a lake in the south.", kSuburb, {"present W@southern third"}},
      {"The bushes are walled in by rock to the east.",
       kWild,
       {"direction R B E", "adjacent R B"},
       {"surrounds R B"}},
      {"The lake is hemmed in by rock on three sides.", kWild, {"adjacent R W"}, {"surrounds W R"}},
      {"Houses line the northern shore of the lake; on the southern shore there are no houses.",
       kSuburb,
       {"direction B W N"},
       {"absent B@southern third"}},
      {"The houses back onto the forest.", kSuburb, {"adjacent B F"}, {"within B F"}},
      {"The village faces the lake.", kSuburb, {"adjacent B W"}},
  };
}

std::vector<Sample> Relatives() {
  return {
      {"The lake whose western shore is lined with houses lies in the middle.",
       kSuburb,
       {"present W@center", "direction B W W"},
       {"present B@center"}},
      {"A river whose banks are wooded runs through the farmland.",
       kSuburb,
       {"through W A", "both_sides F W"},
       {"within F A"}},
      {"The lake, which has houses on its shore, is in the west.",
       kSuburb,
       {"present W@western third", "adjacent B W"},
       {"present B@western third"}},
      {"Everything except the farm, which is in the north, is forest.",
       kSuburb,
       {"dominant F", "present A@northern third"}},
      {"To the south of the forest, which occupies the top, is a meadow.",
       kSuburb,
       {"direction G F S"}},
      {"The lake, which is round, is in the west.",
       kSuburb,
       {"shape W round", "present W@western third"}},
      {"A meadow through which flows a stream.", kSuburb, {"through W G"}},
      {"A forest, through which a road runs, lies in the north.",
       kSuburb,
       {"through R F", "present F@northern third"}},
      {"A road with trees on either side leads from the south to the lake.",
       kSuburb,
       {"both_sides F R", "present R@southern edge"},
       {"present F@southern edge"}},
      {"A snowfield, with rock on both sides of it, cuts the forest in two.",
       kWild,
       {"both_sides R S", "both_sides F S"},
       {"within R F"}},
      {"A lake with houses on both sides.", kSuburb, {"both_sides B W"}},
  };
}

std::vector<Sample> Clumps() {
  return {
      {"Two islands of rock in a lake.", kWild, {"count R 2..2", "within R W"}, {"present B"}},
      {"The island in the lake is wooded.", kSuburb, {"within F W"}, {"within G W"}},
      {"An island of forest in the middle.", kSuburb, {"present F@center"}, {"present G"}},
      {"In a glade of the forest stands a hut.", kSuburb, {"present B"}, {"within F G"}},
      {"A buffer of trees around the lake.", kSuburb, {"surrounds F W"}},
      {"A ring of rock encloses a lake, and outside it everything is forest.",
       kWild,
       {"rest F"},
       {"rest R"}},
      {"The lake reaches from the rock in the west to the forest in the east.",
       kWild,
       {"adjacent W R", "adjacent W F", "present R@western third"},
       {"adjacent R F"}},
      {"A forest stretches from the west to the east.",
       kSuburb,
       {"course F western edge>eastern edge"}},
      {"Forest and water in the north and south respectively.",
       kSuburb,
       {"present F@northern third", "present W@southern third"},
       {"present F@southern third"}},
      {"From the left: a forest, a field and a lake.", kSuburb, {"order FAW>E"}},
      {"From the top: a road runs down to the lake.", kSuburb, {"adjacent R W"}},
      {"Water in the north, houses south of it, and beyond them bare earth.",
       kSuburb,
       {"direction D B S"},
       {"rest D"}},
      {"A lake in the middle and fields around it, and beyond them forest.", kSuburb, {"rest F"}},
  };
}

class PlainAcrossTest : public testing::TestWithParam<Sample> {};
TEST_P(PlainAcrossTest, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainAcrossTest, ReadsCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Across, PlainAcrossTest, testing::ValuesIn(Across()));
INSTANTIATE_TEST_SUITE_P(OnlyThere, PlainAcrossTest, testing::ValuesIn(OnlyThere()));
INSTANTIATE_TEST_SUITE_P(Contrasts, PlainAcrossTest, testing::ValuesIn(Contrasts()));
INSTANTIATE_TEST_SUITE_P(Vantage, PlainAcrossTest, testing::ValuesIn(Vantage()));
INSTANTIATE_TEST_SUITE_P(Relatives, PlainAcrossTest, testing::ValuesIn(Relatives()));
INSTANTIATE_TEST_SUITE_P(Clumps, PlainAcrossTest, testing::ValuesIn(Clumps()));

}  // namespace
}  // namespace latticeworld
