#include <gtest/gtest.h>

#include <vector>

#include "latticeworld/layout/vocabulary.h"
#include "reading_sample.h"

// Sizes told by other sizes, rings, what lies behind and between things, and what links them.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;

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

class PlainOutward : public testing::TestWithParam<Sample> {};

TEST_P(PlainOutward, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainOutward, ReadsTheSameInCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Sizes, PlainOutward, testing::ValuesIn(Sizes()));
INSTANTIATE_TEST_SUITE_P(Outward, PlainOutward, testing::ValuesIn(Outward()));
INSTANTIATE_TEST_SUITE_P(Linked, PlainOutward, testing::ValuesIn(Linked()));
INSTANTIATE_TEST_SUITE_P(Lists, PlainOutward, testing::ValuesIn(Lists()));

}  // namespace
}  // namespace latticeworld
