#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// What one meets on the way, what the land is as a whole, and what is left of it.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Ways() {
  return {
      {"From the top down: snow, rock, forest.",
       kWild,
       {"present S@northern third", "present F@southern third", "order SRF>S"}},
      {"Fields, then houses, then forest as you go east.",
       kSuburb,
       {"present A@western third", "present F@eastern third", "order ABF>E"}},
      {"Sand gives way to grass and then to forest as one goes south.",
       kSuburb,
       {"order DGF>S", "present D@northern third"},
       {"present G@southern third"}},
      {"Starting at the north edge you cross sand, then grass, then forest.",
       kSuburb,
       {"order DGF>S", "present D@northern third", "present F@southern third"}},
      {"The lake comes first from the left, the village second, the forest third.",
       kSuburb,
       {"order WBF>E", "present W@western third"},
       {"amount F"}},
      {"A road goes up the left side.",
       kSuburb,
       {"along R@western edge"},
       {"present R@western third"}},
      {"River down the left third of the map.",
       kSuburb,
       {"course W northern edge>southern edge", "present W@western third"}},
      {"Road and river go next to each other, never crossing.",
       kSuburb,
       {"parallel R W"},
       {"crosses R W"}},
      {"A path keeps pace with the stream.", kSuburb, {"along R W"}},
      {"The road sticks to the river.", kSuburb, {"along R W"}},
      {"Make the right half mirror the left: a lake in each, and a road from top to bottom between "
       "them.",
       kSuburb,
       {"course R northern edge>southern edge"},
       {"along R@western edge"}},
  };
}

std::vector<Sample> Landscapes() {
  return {
      {"A wooded country with two ponds.", kSuburb, {"dominant F", "count W 2..2"}},
      {"This is farm country.", kSuburb, {"dominant A"}},
      {"A sea of grass with a few trees.", kSuburb, {"dominant G"}},
      {"The place is basically one big meadow.", kSuburb, {"dominant G"}},
      {"A rocky region in the north.", kWild, {"present R@northern third"}, {"dominant R"}},
  };
}

std::vector<Sample> Rests() {
  return {
      {"A lake in the north. Anything that remains is grass.", kSuburb, {"rest G"}},
      {"A lake in the north on a background of grass.", kSuburb, {"rest G"}},
      {"A lake in the north. Apart from that, grass.", kSuburb, {"rest G"}},
      {"A lake in the north. Other than that it's grass.", kSuburb, {"rest G"}},
      {"A lake in the north, grass wherever there is no water.", kSuburb, {"rest G"}, {"absent W"}},
      {"A lake in the north. Grass covers what isn't water.", kSuburb, {"rest G"}, {"rest W"}},
      {"A lake in the north and grass in all other places.", kSuburb, {"rest G"}},
      {"The lake is in the north and grass surrounds everything.", kSuburb, {"rest G"}},
  };
}

std::vector<Sample> Meetings() {
  return {
      {"A village where two roads meet.", kSuburb, {"adjacent B R", "crosses R R"}},
      {"A town at the crossing of two roads.", kSuburb, {"adjacent B R", "crosses R R"}},
      {"A road from north to south and one from east to west.",
       kSuburb,
       {"course R northern edge>southern edge", "course R eastern edge>western edge"}},
      {"The wood is cut in two by a road going diagonally from the southwest corner to the "
       "northeast corner.",
       kSuburb,
       {"course R south-west corner>north-east corner", "through R F"},
       {"course F south-west corner>north-east corner"}},
      {"A lake in the middle, around is sand, after sand is grass.",
       kSuburb,
       {"surrounds D W", "surrounds G D"}},
      {"Fields in the north. Road no.", kSuburb, {"absent R"}},
      {"Farmland, and a river from west to east. No bridges.",
       kSuburb,
       {"course W western edge>eastern edge"},
       {"crosses R W", "present R"}},
      {"A road that avoids the forest.", kSuburb, {"apart R F"}},
      {"N: forest, S: lake, center: village.",
       kSuburb,
       {"present F@northern third", "present W@southern third", "present B@center"},
       {"present F@southern third"}},
  };
}

std::vector<Sample> Approaches() {
  return {
      {"A hospital in the middle. Roads reach it from the west, from the east and from the"
       " south.",
       kSuburb,
       {"adjacent R B", "present R@western third", "present R@eastern third",
        "present R@southern third"}},
      {"Roads enter the town from three sides: north, west and south.",
       kSuburb,
       {"present R@northern third", "present R@western third", "present R@southern third"},
       {"count R 3..3"}},
      {"Two roads cross in the middle, and both run from edge to edge.",
       kSuburb,
       {"crosses R R", "course R northern edge>southern edge",
        "course R western edge>eastern edge"}},
      {"Driving north on the coast road you have the sea on your left and fields on your "
       "right the whole way.",
       kSuburb,
       {"course R southern edge>northern edge", "direction W R W", "direction A R E"},
       {"present W@western third"}},
      {"Walking south along the path, on your left there is a wood, on your right a field.",
       kSuburb,
       {"course R northern edge>southern edge", "direction F R E", "direction A R W"}},
  };
}

std::vector<Sample> Bends() {
  return {
      {"A path follows the right bank of the river from the bottom up to about the middle,"
       " where it crosses the river and carries on to the left edge.",
       kSuburb,
       {"course R southern edge>western edge", "crosses R W", "direction R W E"}},
      {"A river runs from the top edge to the middle and then turns east and leaves by the"
       " right edge.",
       kSuburb,
       {"course W northern edge>eastern edge", "shape W bent"},
       {"course W northern edge>center"}},
      {"A river flows from the left edge to the bottom edge. A village lies on the inside "
       "of the bend and a wood on the outside of the bend.",
       kSuburb,
       {"direction B W SW", "direction F W NE"}},
      {"A river flows from the top edge to the right edge, curving around a town. The town"
       " is on the inner side of the curve. Fill the outer side with fields.",
       kSuburb,
       {"direction B W NE", "direction A W SW"}},
  };
}

std::vector<Sample> Motions() {
  return {
      {"A road follows the river from the top to the bottom on its east bank.",
       kSuburb,
       {"course R northern edge>southern edge", "direction R W E"},
       {"course R northern edge>south-east corner"}},
      {"A highway along the bottom edge; a side road branches off it to the north and ends"
       " at a farm.",
       kSuburb,
       {"adjacent R A"},
       {"present R@south-west corner"}},
      {"A road runs from the west edge to the middle, where it ends at a village.",
       kSuburb,
       {"course R western edge>center", "present B@center", "adjacent R B"}},
      {"The river makes a loop around the village before leaving at the bottom.",
       kSuburb,
       {"shape W bent", "adjacent W B", "present W@southern edge"},
       {"shape W ring", "surrounds W B"}},
      {"The river enters at the top, a third of the way from the left, and leaves at the "
       "bottom right.",
       kSuburb,
       {"course W northern edge>south-east corner"},
       {"amount W"}},
      {"A lane goes from the village straight north to the edge.",
       kSuburb,
       {"shape R straight", "present R@northern edge"},
       {"shape B straight"}},
      {"One river flows north to south, another joins it from the east.",
       kSuburb,
       {"course W northern edge>southern edge", "present W@eastern edge"},
       {"course W eastern edge>southern edge"}},
      {"The road from the village goes past the lake to the eastern edge.",
       kSuburb,
       {"present R@eastern edge", "adjacent R W"},
       {"direction R W E"}},
      {"A village by a lake, with a road leading away from it to the west.",
       kSuburb,
       {"adjacent R B"},
       {"apart R B"}},
      {"Four roads leave the village, one in each direction.",
       kSuburb,
       {"present R@northern edge", "present R@western edge"}},
      {"None of the houses is in the forest.",
       kSuburb,
       {"present B", "present F", "apart B F"},
       {"absent B", "absent F"}},
      {"The forest is in the north, the fields are in the south, and a river runs between "
       "them.",
       kSuburb,
       {"between W F A"},
       {"connects W F A"}},
      {"First comes the forest, then the meadow, then the lake, going south.",
       kSuburb,
       {"order FGW>S"}},
      {"As you go north, forest turns to rock and rock to snow.", kWild, {"order FRS>N"}},
  };
}

std::vector<Sample> Totals() {
  return {
      {"The rest is half fields and half grass. A lake in the north.",
       kSuburb,
       {"rest A"},
       {"amount A"}},
      {"The forest is larger than all the rest together.", kSuburb, {"dominant F"}, {"rest F"}},
      {"The four quarters are forest, grass, fields and water.",
       kSuburb,
       {"amount F", "amount W"},
       {"present F@north-western quarter"}},
      {"The border of the map is water, so it's an island.",
       kSuburb,
       {"present W@edges", "within G W"},
       {"present G@edges"}},
      {"The village has a road to the north and one to the east.",
       kSuburb,
       {"present R@northern edge", "present R@eastern edge", "adjacent R B"},
       {"present B@eastern third"}},
      {"There are three roads: one to the north, one to the east, one to the south.",
       kSuburb,
       {"count R 3..3", "present R@northern third"}},
      {"The road makes a wide curve to the east around the lake.",
       kSuburb,
       {"direction R W E"},
       {"shape R ring", "surrounds R W"}},
      {"A road to the village from the south; it does not continue beyond the village.",
       kSuburb,
       {"adjacent R B"},
       {"apart R B"}},
  };
}

class PlainWaysTest : public testing::TestWithParam<Sample> {};

TEST_P(PlainWaysTest, AreRead) {
  ExpectRead(GetParam());
  ExpectReadInCapitals(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Totals, PlainWaysTest, testing::ValuesIn(Totals()));
INSTANTIATE_TEST_SUITE_P(Ways, PlainWaysTest, testing::ValuesIn(Ways()));
INSTANTIATE_TEST_SUITE_P(Meetings, PlainWaysTest, testing::ValuesIn(Meetings()));
INSTANTIATE_TEST_SUITE_P(Landscapes, PlainWaysTest, testing::ValuesIn(Landscapes()));
INSTANTIATE_TEST_SUITE_P(Rests, PlainWaysTest, testing::ValuesIn(Rests()));
INSTANTIATE_TEST_SUITE_P(Approaches, PlainWaysTest, testing::ValuesIn(Approaches()));
INSTANTIATE_TEST_SUITE_P(Bends, PlainWaysTest, testing::ValuesIn(Bends()));
INSTANTIATE_TEST_SUITE_P(Motions, PlainWaysTest, testing::ValuesIn(Motions()));

}  // namespace
}  // namespace latticeworld
