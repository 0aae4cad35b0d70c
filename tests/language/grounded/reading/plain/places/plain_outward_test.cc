#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Sizes told by other sizes, rings, what lies behind and between things, and what links them.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Sizes() {
  return {
      {"A big forest and a lake half its size.", kSuburb, {"more_than F W"}, {"amount W"}},
      {"A lake and a forest twice as large.", kSuburb, {"more_than F W"}},
      {"Woods on 60 % of the land, farmland a third of that.",
       kSuburb,
       {"amount F", "amount A"},
       {"amount A@center"}},
      {"A lake covers a fifth of the map and the village is about the same size.",
       kSuburb,
       {"amount W", "amount B"}},
      {"The fields cover a quarter of the map, and the town takes up half of that.",
       kSuburb,
       {"amount A", "amount B"},
       {"present B@northern third"}},
  };
}

std::vector<Sample> Outward() {
  return {
      {"The farm stands between the lake on its northern side and the woods to its south.",
       kSuburb,
       {"between A W F", "direction W A N", "direction F A S"},
       {"direction A W N", "direction A F S"}},
      {"A village between a river to its east and fields to its west.",
       kSuburb,
       {"between B W A", "direction W B E", "direction A B W"}},
      {"There is a town in the center. Around it fields, and beyond that forest.",
       kSuburb,
       {"surrounds A B", "surrounds F A"}},
      {"A pond surrounded by grass; outside this there are only houses.",
       kSuburb,
       {"surrounds G W", "surrounds B G"}},
      {"Water along the northern edge and, inland, sand followed by grass.",
       kSuburb,
       {"direction D W S", "direction G D S"}},
      {"A strip of sand along the west coast. Behind it meadows, then woods.",
       kSuburb,
       {"order DGF>E"},
       {"present G@interior"}},
      {"A lake on the northern side, and houses on the far shore.",
       kSuburb,
       {"direction B W N"},
       {"direction B W S"}},
      {"Houses line the road, and behind them are fields.",
       kSuburb,
       {"along B R", "adjacent A B"},
       {"direction A B N"}},
  };
}

std::vector<Sample> Linked() {
  return {
      {"A lake in the north and a village in the south, linked by a road.",
       kSuburb,
       {"connects R W B"}},
      {"A town in the middle and a farm in every corner, all joined by roads.",
       kSuburb,
       {"connects R B A"}},
      {"A river flows from top to bottom and a village lies halfway along the river.",
       kSuburb,
       {"adjacent B W", "present B@center"}},
      {"A road with a farm midway along it.", kSuburb, {"adjacent A R"}, {"present A@center"}},
      {"Mostly sand, but the land becomes lusher towards the south.",
       kSuburb,
       {"dominant D"},
       {"present D@southern third", "dominant D@southern third"}},
      {"Mostly grass, and the land becomes sandier towards the east.",
       kSuburb,
       {"present D@eastern third"}},
      {"A dense forest in the west that thins out towards the east.",
       kSuburb,
       {"present F@western third"},
       {"present F@eastern third"}},
      {"Forest to the left, fields to the right, and a road between them.",
       kSuburb,
       {"between R F A"},
       {"between R A A"}},
      {"Woods in the north, houses in the south; between them is a river.",
       kSuburb,
       {"between W F B"}},
      {"A small town with a park in its center, and a ring road around it.",
       kSuburb,
       {"surrounds R B"},
       {"surrounds R G"}},
  };
}

std::vector<Sample> Lists() {
  return {
      {"From west to east a forest, a meadow and a town.",
       kSuburb,
       {"order FGB>E"},
       {"course F western edge>eastern edge"}},
      {"From the top to the bottom woods, then fields, and finally a lake.",
       kSuburb,
       {"order FAW>S"}},
      {"From north to south a road, from west to east a river.",
       kSuburb,
       {"course R northern edge>southern edge", "course W western edge>eastern edge"}},
      {"A lake in the west, east of it a village, east of that fields.",
       kSuburb,
       {"direction B W E", "direction A B E"},
       {"direction B A E"}},
      {"Two farms, one to the left and one to the right of the road.",
       kSuburb,
       {"direction A R W", "direction A R E"},
       {"present A@western third"}},
      {"The left half is divided into woods in the north and a lake in the south.",
       kSuburb,
       {"present F@north-western quarter", "present W@south-western quarter"}},
  };
}

std::vector<Sample> Grouping() {
  return {
      {"The only trees, up in the far north-east. A lake in the west.",
       kSuburb,
       {"located F@north-east corner"}},
      {"The only water is a river on the right.", kSuburb, {"located W@eastern third"}},
      {"Keep all the houses together in one group in the lower left.",
       kSuburb,
       {"located B@lower left", "clustered B"},
       {"count B 1..1"}},
      {"The houses and the lake must be at least eight cells apart.",
       kSuburb,
       {"apart B W"},
       {"count B 8..", "count W 8.."}},
      {"A strip of trees shelters the village from the north.",
       kSuburb,
       {"direction F B N"},
       {"present B@northern third"}},
      {"The village is protected from the north wind by a wood.",
       kSuburb,
       {"direction F B N"},
       {"present B@northern third"}},
      {"The house stands at the north-west corner of the lake.", kSuburb, {"direction B W NW"}},
      {"Four groups of houses, one near the middle of each side of the map.",
       kSuburb,
       {"present B@middle left", "present B@lower"}},
      {"A lake in the west. In the east there are two villages and a road that joins them.",
       kSuburb,
       {"connects R B B"},
       {"connects R W B"}},
  };
}

std::vector<Sample> Placing() {
  return {
      {"A wood in the north with a lake inside, and a road from the lake south to a "
       "village.",
       kSuburb,
       {"connects R W B"},
       {"present W@southern third"}},
      {"To the left of the village is a lake, and behind it, to the north, a rock.",
       kSuburb,
       {"direction W B W", "direction D B N"}},
      {"A town on the river, on the south side.",
       kSuburb,
       {"direction B W S"},
       {"present B@southern third"}},
      {"The forest borders the lake in the north and the fields in the south.",
       kSuburb,
       {"direction W F N", "direction A F S"},
       {"present F@northern third"}},
      {"A lake near the corner, bottom left.",
       kSuburb,
       {"present W@south-west corner"},
       {"present W@corners"}},
      {"A lake in the north. The middle of the map stays empty.", kSuburb, {"present G@center"}},
  };
}

std::vector<Sample> Asides() {
  return {
      {"A manor in the middle. Surrounded by forest, reached by a lane from the east.",
       kSuburb,
       {"surrounds F B", "adjacent R B"},
       {"adjacent R F"}},
      {"Three hamlets hang on a road like beads on a string. It enters at the left edge.",
       kSuburb,
       {"along B R", "present R@western edge"},
       {"present B@western edge"}},
      {"No houses in the northern half, which has a lake in the middle.",
       kSuburb,
       {"absent B@northern half", "present W@center"},
       {"absent W@center"}},
      {"The village as it was in 1900.", kSuburb, {"present B"}, {"count B 24..24"}},
      {"Around 55 percent of the cells should be forest, in a few large stands.",
       kSuburb,
       {"amount F"}},
      {"A lake, and 5 houses and then grass where there is still room.",
       kSuburb,
       {"count B 5..5", "rest G"}},
      {"Two roads cross in the middle. They cut the map into four: woods in the NW, crops "
       "in the NE.",
       kSuburb,
       {"crosses R R", "present F@upper left"},
       {"count R 5..5"}},
      {"A lake in the west. Huts dotted about, none on the shore.",
       kSuburb,
       {"present B", "apart B W"},
       {"absent B"}},
      {"The town is wooded on every side but one: towards the east it opens on meadows.",
       kSuburb,
       {"direction G B E"},
       {"direction G F E"}},
      {"A snow-covered plain with a lake.", kWild, {"dominant S"}},
      {"A lake in the north - no, sorry, in the south.",
       kSuburb,
       {"present W@southern third"},
       {"absent W@southern third"}},
      {"A lake, no, a wood in the north.", kSuburb, {"present F@northern third"}, {"present W"}},
      {"Put a village in the north. On second thought, put it in the south.",
       kSuburb,
       {"present B@southern third"},
       {"present B@northern third"}},
  };
}

class PlainOutward : public testing::TestWithParam<Sample> {};

TEST_P(PlainOutward, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainOutward, ReadsTheSameInCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Sizes, PlainOutward, testing::ValuesIn(Sizes()));
INSTANTIATE_TEST_SUITE_P(Outward, PlainOutward, testing::ValuesIn(Outward()));
INSTANTIATE_TEST_SUITE_P(Linked, PlainOutward, testing::ValuesIn(Linked()));
INSTANTIATE_TEST_SUITE_P(Lists, PlainOutward, testing::ValuesIn(Lists()));
INSTANTIATE_TEST_SUITE_P(Grouping, PlainOutward, testing::ValuesIn(Grouping()));
INSTANTIATE_TEST_SUITE_P(Placing, PlainOutward, testing::ValuesIn(Placing()));
INSTANTIATE_TEST_SUITE_P(Asides, PlainOutward, testing::ValuesIn(Asides()));

}  // namespace
}  // namespace latticeworld
