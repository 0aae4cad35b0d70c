#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// What lies within and without, at ends, is measured in cells, or is only part of the land.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;

std::vector<Sample> Rings() {
  return {
      {"Forest on all four sides, a meadow within.", kSuburb, {"surrounds F G"}},
      {"A town inside a ring road, fields outside.",
       kSuburb,
       {"surrounds R B", "shape R ring"},
       {"adjacent A B"}},
      {"Woods at the top, water at the bottom, and in between a village.",
       kSuburb,
       {"between B F W", "present F@northern third", "present W@southern third"}},
      {"A forest on the east side, a lake at its foot.", kSuburb, {"adjacent W F"}},
  };
}

std::vector<Sample> Ends() {
  return {
      {"A village at each end of the road.", kSuburb, {"count B 2..2", "adjacent B R"}},
      {"Two villages, one at each end of the road.",
       kSuburb,
       {"count B 2..2", "adjacent B R"},
       {"count B 1..1"}},
      {"Roads leave the town in all four directions.",
       kSuburb,
       {"present R@northern edge", "present R@southern edge", "present R@eastern edge",
        "present R@western edge", "adjacent R B"},
       {"count B 4..4"}},
  };
}

std::vector<Sample> Fellows() {
  return {
      {"A village north of the lake, another one south of it, and a road that connects them past "
       "the lake on the east.",
       kSuburb,
       {"direction B W N", "direction B W S", "connects R B B"}},
      {"Half of the buildings are in the north, the other half in the south.",
       kSuburb,
       {"present B@northern third", "present B@southern third"},
       {"amount B"}},
      {"Most of the houses are in the north.",
       kSuburb,
       {"present B@northern third"},
       {"dominant B@northern third"}},
      {"Five ponds and paths between them.", kSuburb, {"count W 5..5", "between R W W"}},
      {"Half of the map is forest, the other half fields.", kSuburb, {"amount F", "amount A"}},
  };
}

std::vector<Sample> Spans() {
  return {
      {"A forest strip 5 cells wide along the western border.",
       kSuburb,
       {"present F@western edge"},
       {"count F 5..5"}},
      {"A river two or three cells wide runs from north to south.",
       kSuburb,
       {"course W northern edge>southern edge"},
       {"count W 3..3", "count W 2..3"}},
      {"A lake about 10 cells across in the middle.",
       kSuburb,
       {"present W@center", "amount W"},
       {"count W 8..12"}},
      {"A lake of 12 x 10 cells in the north.",
       kSuburb,
       {"present W@northern third", "amount W"},
       {"count W 10..10", "count W 12..12"}},
      {"Five houses, each 2 cells wide.", kSuburb, {"count B 5..5"}},
      {"Two streets, 6 m wide, cross in the middle.", kSuburb, {"crosses R R"}},
  };
}

std::vector<Sample> Backgrounds() {
  return {
      {"Mostly grass and a single building in the middle.",
       kSuburb,
       {"dominant G", "present B@center"},
       {"present G@center"}},
      {"Nothing but grass and a single building in the middle.",
       kSuburb,
       {"dominant G", "present B@center"},
       {"present G@center"}},
      {"Scattered trees and a pond in the middle.",
       kSuburb,
       {"scattered F", "present W@center"},
       {"present F@center"}},
      {"Suburb with streets in a grid and a park in the center.",
       kSuburb,
       {"shape R gridded", "present G@center"},
       {"present R@center"}},
      {"A forest and a lake in the north.",
       kSuburb,
       {"present F@northern third", "present W@northern third"}},
  };
}

class PlainRingsTest : public testing::TestWithParam<Sample> {};

TEST_P(PlainRingsTest, AreRead) {
  ExpectRead(GetParam());
  ExpectReadInCapitals(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Rings, PlainRingsTest, testing::ValuesIn(Rings()));
INSTANTIATE_TEST_SUITE_P(Ends, PlainRingsTest, testing::ValuesIn(Ends()));
INSTANTIATE_TEST_SUITE_P(Fellows, PlainRingsTest, testing::ValuesIn(Fellows()));
INSTANTIATE_TEST_SUITE_P(Spans, PlainRingsTest, testing::ValuesIn(Spans()));
INSTANTIATE_TEST_SUITE_P(Backgrounds, PlainRingsTest, testing::ValuesIn(Backgrounds()));

}  // namespace
}  // namespace latticeworld
