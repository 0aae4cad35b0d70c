#include <gtest/gtest.h>

#include <vector>

#include "latticeworld/layout/vocabulary.h"
#include "reading_sample.h"

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

class PlainWaysTest : public testing::TestWithParam<Sample> {};

TEST_P(PlainWaysTest, AreRead) {
  ExpectRead(GetParam());
  ExpectReadInCapitals(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Ways, PlainWaysTest, testing::ValuesIn(Ways()));
INSTANTIATE_TEST_SUITE_P(Meetings, PlainWaysTest, testing::ValuesIn(Meetings()));
INSTANTIATE_TEST_SUITE_P(Landscapes, PlainWaysTest, testing::ValuesIn(Landscapes()));
INSTANTIATE_TEST_SUITE_P(Rests, PlainWaysTest, testing::ValuesIn(Rests()));

}  // namespace
}  // namespace latticeworld
