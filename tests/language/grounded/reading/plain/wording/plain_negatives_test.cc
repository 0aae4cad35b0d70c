#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// What a thing is without, both and neither of two, what lies on which side, places that stand
// before what they are about.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Lacks() {
  return {
      {"Meadows devoid of trees or houses surround the lake.",
       kSuburb,
       {"surrounds G W", "absent F", "absent B"},
       {"absent W"}},
      {"A path without trees crosses the meadow.", kSuburb, {"through R G"}, {"absent G"}},
      {"A heath free of rocks and snow borders the lake.",
       kWild,
       {"adjacent B W", "absent R", "absent S"},
       {"absent W"}},
      {"The lake, which has no houses, lies in the north.",
       kSuburb,
       {"present W@northern third", "absent B"}},
      {"Forest in the south. A meadow without trees lies in the north.",
       kSuburb,
       {"present F@southern third", "present G@northern third"},
       {"absent F"}},
      {"The houses and fields avoid the lake.", kSuburb, {"apart B W", "apart A W"}, {"absent W"}},
      {"The path has to avoid the forest.", kSuburb, {"apart R F"}, {"absent F"}},
      // Near misses.
      {"There is a forest in the north without houses.",
       kSuburb,
       {"present F@northern third", "absent B"}},
      {"A village without a road in the south.", kSuburb, {"absent R@southern third"}},
      {"You should avoid water.", kSuburb, {"absent W"}},
      {"Avoid houses in the south.", kSuburb, {"absent B@southern third"}},
      {"A meadow clear of the forest lies in the south.", kSuburb, {"apart G F"}, {"absent F"}},
      {"A village, clear of the river, lies in the north.",
       kSuburb,
       {"present B@northern third", "apart B W"},
       {"absent W"}},
  };
}

std::vector<Sample> Neither() {
  return {
      {"Neither the village nor the lake should be close to the forest.",
       kSuburb,
       {"apart B F", "apart W F"},
       {"absent F"}},
      {"Neither the town nor the lake lies in the north.",
       kSuburb,
       {"absent B@northern third", "absent W@northern third", "present B", "present W"}},
      {"The village lies next to neither a lake nor a road.",
       kSuburb,
       {"apart B W", "apart B R"},
       {"absent W"}},
      {"The farm is neither near the lake nor near the road.", kSuburb, {"apart A W", "apart A R"}},
      {"The road crosses neither the river nor the forest.", kSuburb, {"present W"}, {"absent W"}},
      {"A lake and a forest, neither of them near the road.", kSuburb, {"apart W R", "apart F R"}},
      {"A town in the north, a second one in the south, and neither touches the river.",
       kSuburb,
       {"apart B W@northern third", "apart B W@southern third"}},
      {"Two lakes, neither near the road.", kSuburb, {"count W 2..2", "apart W R"}},
      // Near misses.
      {"There is neither forest nor water.", kSuburb, {"absent F", "absent W"}},
      {"Neither houses nor trees are in the north.",
       kSuburb,
       {"absent B@northern third", "absent F@northern third"},
       {"present B", "present F"}},
      {"A lake with neither houses nor trees.", kSuburb, {"absent B", "absent F"}},
  };
}

std::vector<Sample> Both() {
  return {
      {"Both the village and the road lie north of the river.",
       kSuburb,
       {"direction B W N", "direction R W N"},
       {"count B 2..2"}},
      {"Both houses and fields are in the north.",
       kSuburb,
       {"present B@northern third", "present A@northern third"},
       {"count B 2..2"}},
      {"Rock and bushes in the south, and above both of them snow.",
       kWild,
       {"direction S R N", "direction S B N"},
       {"count S 2..2"}},
      {"A pond and a wood, both of them close to the road.",
       kSuburb,
       {"adjacent W R", "adjacent F R"}},
      {"A lake, a forest and a village, all near the road.",
       kSuburb,
       {"adjacent W R", "adjacent F R", "adjacent B R"}},
      {"There is a forest and a lake, and they are in the west.",
       kSuburb,
       {"present F@western third", "present W@western third"}},
      {"There is a wood and a town. Both are in the south.",
       kSuburb,
       {"present F@southern third", "present B@southern third"}},
      {"The lake and the forest are not in the north.",
       kSuburb,
       {"absent W@northern third", "absent F@northern third"}},
      {"A village and a wood, with a lake between them, all in the north.",
       kSuburb,
       {"between W B F", "present B@northern third", "present F@northern third",
        "present W@northern third"}},
      {"The northern village lies on the river and the southern one lies beside the forest.",
       kSuburb,
       {"present B@southern third", "adjacent B F@southern third"},
       {"present W@southern third"}},
      {"The upper lake is big and the lower one touches the village.",
       kSuburb,
       {"present W@southern third", "adjacent W B@southern third"},
       {"adjacent W B@northern third"}},
      {"The lake with the village beside it is in the north, the one without is in the south.",
       kSuburb,
       {"present W@southern third", "adjacent B W"},
       {"present B@southern third"}},
      // Near misses.
      {"Both lakes and the forest are in the north.", kSuburb, {"count W 2..2"}},
      {"Fields lie on both sides of the road.", kSuburb, {"both_sides A R"}},
      {"A lake, a village in the center.", kSuburb, {"present B@center"}, {"present W@center"}},
      {"One half is forest, the other has a lake.",
       kSuburb,
       {"amount F 42..58", "present W"},
       {"amount W 42..58"}},
      {"One half of the village is in the forest and the other is in the fields.",
       kSuburb,
       {"present A"},
       {"amount A 42..58"}},
      {"One half is forest, the other is grass.", kSuburb, {"amount F 42..58", "amount G 42..58"}},
  };
}

std::vector<Sample> Borders() {
  return {
      {"The pond has fields on every side.",
       kSuburb,
       {"surrounds A W"},
       {"present A@western edge"}},
      {"Hemmed in by houses on every side, a small lake lies in the middle.",
       kSuburb,
       {"surrounds B W", "present W@center"},
       {"present B@northern edge"}},
      {"Snow encircles the lake on every side.",
       kWild,
       {"surrounds S W"},
       {"present S@eastern edge"}},
      {"There is a town. Woods press in on it from all sides.", kSuburb, {"surrounds F B"}},
      {"A lake closed in on all sides by forest.", kSuburb, {"surrounds F W"}},
      {"A lake edged on the south-east by rocks.",
       kWild,
       {"direction R W SE", "adjacent R W"},
       {"present W@lower right"}},
      {"The village is bounded by a river to the north, a road to the south and forest to the "
       "east.",
       kSuburb,
       {"direction W B N", "direction R B S", "direction F B E", "adjacent F B"},
       {"present R@southern edge"}},
      {"Farmland in the west, bounded on the east by a river.",
       kSuburb,
       {"present A@western third", "direction W A E"},
       {"present A@eastern third"}},
      {"Farmland bordered by a river on its north side.",
       kSuburb,
       {"direction W A N"},
       {"direction A W N"}},
      {"Houses, bounded to the south by a road, lie in the center.",
       kSuburb,
       {"present B@center", "direction R B S"},
       {"present R@center"}},
      // Near misses.
      {"Forest on all sides.", kSuburb, {"present F@northern edge", "present F@western edge"}},
      {"The map has forest on all sides.", kSuburb, {"present F@northern edge"}},
      {"The map is bounded on the north by a river.", kSuburb, {"present W@northern third"}},
      {"A lake bordered by forest.", kSuburb, {"adjacent F W"}, {"direction F W N"}},
      {"A village bordered by a forest on the east of the lake.",
       kSuburb,
       {"adjacent F B"},
       {"direction F B E"}},
      {"A river with trees on each side.", kSuburb, {"both_sides F W"}, {"surrounds F W"}},
      {"The road has houses on every side.", kSuburb, {"both_sides B R"}},
      {"Trees line the road on each side.", kSuburb, {"both_sides F R"}},
      {"Houses border the road on each side.", kSuburb, {"both_sides B R"}},
      {"Forest flanks the river on each side.", kSuburb, {"both_sides F W"}},
      {"A lake with trees on each side.", kSuburb, {"surrounds F W"}, {"both_sides F W"}},
      {"A village with paths from every side.",
       kSuburb,
       {"course R western edge>eastern edge"},
       {"surrounds R B", "shape R ring"}},
      {"A town with roads to all sides.",
       kSuburb,
       {"course R northern edge>southern edge"},
       {"surrounds R B"}},
      {"Fields on all sides of the town but the west.",
       kSuburb,
       {"surrounds A B"},
       {"present A@northern edge"}},
      {"All sides of the lake are forest except the north.",
       kSuburb,
       {"surrounds F W"},
       {"absent F@northern third"}},
      {"Forest lies around the lake on all sides but not in the south.",
       kSuburb,
       {"surrounds F W"},
       {"absent F@southern third"}},
      {"A lake bordered by forest on all sides except the west.",
       kSuburb,
       {"adjacent F W"},
       {"present W@northern edge"}},
      {"Trees on every side except the south.",
       kSuburb,
       {"present F@northern edge", "present F@eastern edge"},
       {"present F@southern edge"}},
  };
}

std::vector<Sample> Inserts() {
  return {
      {"In the north lies a forest, and below it, facing the lake, houses.",
       kSuburb,
       {"direction B F S", "adjacent B W"},
       {"present B@northern third", "adjacent F W"}},
      {"North of the road, near the pond, stands a farm.",
       kSuburb,
       {"direction A R N", "adjacent A W"}},
      {"There is a lake. Above it, near the road, are fields.",
       kSuburb,
       {"direction A W N", "adjacent A R"},
       {"adjacent W R"}},
      {"In the south, beside the lake, a village.",
       kSuburb,
       {"present B@southern third", "adjacent B W"},
       {"present W@southern third"}},
      {"A lake and, to its east, a forest", kSuburb, {"direction F W E"}, {"direction W F E"}},
      {"A motorway and, alongside it, a canal.", kSuburb, {"parallel W R"}},
      {"The middle is snow, and around that is rock, and around that is forest.",
       kWild,
       {"surrounds R S", "surrounds F R"},
       {"surrounds S R"}},
      {"Houses in the north, trees under them and water in the south.",
       kSuburb,
       {"direction F B S"},
       {"present B@southern third"}},
      {"Forest in the north and right above it a lake.",
       kSuburb,
       {"direction W F N"},
       {"present F@eastern third"}},
      {"Right beneath the forest is a lake.",
       kSuburb,
       {"direction W F S"},
       {"present W@eastern third"}},
      {"So there's a river, right, and a town.",
       kSuburb,
       {"present W"},
       {"present W@eastern third"}},
      // Near misses.
      {"A lake, right, and a forest, left.",
       kSuburb,
       {"present W@eastern third", "present F@western third"}},
      {"Houses, right.", kSuburb, {"present B@eastern third"}},
      {"A lake on the right beneath the forest.", kSuburb, {"present W@eastern third"}},
      {"West of the lake, forest. East of the lake, fields.",
       kSuburb,
       {"direction F W W", "direction A W E"}},
  };
}

std::vector<Sample> Sides() {
  return {
      {"On one side of the river there are fields and on the other there is nothing but forest.",
       kSuburb,
       {"between W A F"},
       {"dominant F"}},
      {"On one side of the road there are houses and on the other meadow.",
       kSuburb,
       {"between R B G"}},
      {"A road splits the land; houses on one side and fields on the other.",
       kSuburb,
       {"between R B A"},
       {"within B A"}},
      {"A river divides the map in two: forest on one side, farmland on the other.",
       kSuburb,
       {"between W F A"}},
      {"A road splits the land in two parts, one is forested, the other cultivated.",
       kSuburb,
       {"between R F A"}},
      {"The road has trees on one side and a lake on the other.", kSuburb, {"between R F W"}},
      {"The lake borders the forest on one side and the town on the other.",
       kSuburb,
       {"adjacent W F", "adjacent W B"},
       {"within W F"}},
      {"One half is water and the other is forest.",
       kSuburb,
       {"amount F 42..58", "amount W 42..58"}},
      // Near misses.
      {"Two lakes, one in the north, the other is in the south.", kSuburb, {"count W 2..2"}},
      {"A river crosses a forest, houses on one side.", kSuburb, {"through W F"}},
      {"The lake borders the forest and the town.", kSuburb, {"adjacent W F", "adjacent W B"}},
  };
}

class PlainNegativesTest : public testing::TestWithParam<Sample> {};
TEST_P(PlainNegativesTest, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainNegativesTest, ReadsCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Lacks, PlainNegativesTest, testing::ValuesIn(Lacks()));
INSTANTIATE_TEST_SUITE_P(Neither, PlainNegativesTest, testing::ValuesIn(Neither()));
INSTANTIATE_TEST_SUITE_P(Both, PlainNegativesTest, testing::ValuesIn(Both()));
INSTANTIATE_TEST_SUITE_P(Borders, PlainNegativesTest, testing::ValuesIn(Borders()));
INSTANTIATE_TEST_SUITE_P(Inserts, PlainNegativesTest, testing::ValuesIn(Inserts()));
INSTANTIATE_TEST_SUITE_P(Sides, PlainNegativesTest, testing::ValuesIn(Sides()));

}  // namespace
}  // namespace latticeworld
