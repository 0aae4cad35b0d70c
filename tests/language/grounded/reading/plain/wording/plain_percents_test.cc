#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Shares told one after the other or of a place, parts of what there is, little and much elsewhere,
// all places but one, numbers between bounds.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Shares() {
  return {
      {"60% should be farmland, 30% should be forest and 10% water.",
       kSuburb,
       {"amount A 52..68", "amount F 22..38", "amount W"},
       {"present W"}},
      {"Two thirds of the map are forest and one third is water.",
       kSuburb,
       {"amount F", "amount W"},
       {"present W"}},
      {"Half the area is rock, the other half is snow.",
       kWild,
       {"amount R 42..58", "amount S 42..58"}},
      {"Farmland fills 30% and the other 70% is forest.",
       kSuburb,
       {"amount A 22..38", "amount F 62..78"}},
      {"Snow at least 30% and rock at most 25%.", kWild, {"amount S", "amount R"}},
      {"The lake should be about 20% and the meadow 60%.",
       kSuburb,
       {"amount W 12..28", "amount G 52..68"}},
      {"The town has 15% of the map, the woods have 40%.",
       kSuburb,
       {"amount B 7..23", "amount F 32..48"},
       {"adjacent F B"}},
      {"60% grass, the remaining 40% is split evenly between forest and water.",
       kSuburb,
       {"amount G 52..68", "amount F 12..28", "amount W 12..28"}},
      {"80% snow, the rest is half rock and half water.",
       kWild,
       {"amount S 72..88", "amount R", "amount W"},
       {"rest R"}},
      {"At most 8% of the map should be streets.", kSuburb, {"amount R"}, {"present R"}},
      {"The share of buildings must not exceed 15 percent.", kSuburb, {"amount B"}},
      {"Forest >= 40%, water < 10%.", kSuburb, {"amount F", "amount W"}},
      {"trees: 0.7, fields: 0.3", kSuburb, {"amount F 62..78", "amount A 22..38"}},
      {"forest = 30, grass = 70",
       kSuburb,
       {"amount F 22..38", "amount G 62..78"},
       {"count F 24..24"}},
      // Near misses.
      {"70% of the map is forest.", kSuburb, {"amount F 62..78"}},
      {"A third lake in the north.", kSuburb, {"present W@northern third"}, {"amount W"}},
      {"The village has a lake.", kSuburb, {"present B", "present W"}},
      {"forest: 5, lakes: 2", kSuburb, {"present F"}, {"amount F"}},
  };
}

std::vector<Sample> SharesOfPlaces() {
  return {
      {"40% of the south is water.", kSuburb, {"amount W 32..48@southern third"}, {"amount W"}},
      {"The east is half fields and half houses.",
       kSuburb,
       {"amount A 42..58@eastern third", "amount B 42..58@eastern third"}},
      {"South half: 70% bushes, 30% rock.",
       kWild,
       {"amount B 62..78@southern half", "amount R 22..38@southern half"}},
      {"In the west 60% is forest and 40% is grass.",
       kSuburb,
       {"amount F 52..68@western third", "amount G 32..48@western third"}},
      {"A quarter of the right half is forest, the remainder is meadow.",
       kSuburb,
       {"amount F 17..33@eastern half", "amount G 67..83@eastern half"},
       {"rest G"}},
      {"Hardly any trees on the left.", kSuburb, {"amount F 0..8@western third"}, {"amount F"}},
      // Near misses.
      {"In the north, 30% of the map is forest.", kSuburb, {"amount F 22..38"}},
      {"A lake in the north covers 20% of the map.", kSuburb, {"amount W 12..28"}},
      {"A map with 40% forest and one lake in the centre.",
       kSuburb,
       {"amount F 32..48", "present W@center"},
       {"present F@center"}},
      {"In the north 60 percent forest, in the south 60 percent grass.",
       kSuburb,
       {"amount F 52..68@northern third", "amount G 52..68@southern third"},
       {"present F@southern third"}},
      {"In the west 60 percent is water, and in the east 40 percent is forest.",
       kSuburb,
       {"amount W 52..68@western third", "amount F 32..48@eastern third"}},
  };
}

std::vector<Sample> Parts() {
  return {
      {"Half of the meadow lies in the south.",
       kSuburb,
       {"located G@southern third"},
       {"amount G"}},
      {"Most of the fields are on the right.", kSuburb, {"located A@eastern third"}},
      {"A third of the houses stand in the east.",
       kSuburb,
       {"located B@eastern third"},
       {"amount B"}},
      {"Most of the snow is in the upper half.", kWild, {"located S@northern half"}},
      {"All snow lies in the top left corner.", kWild, {"located S@north-west corner"}},
      {"All the trees are on the left.", kSuburb, {"located F@western third"}},
      // Near misses.
      {"Most of the map is forest.", kSuburb, {"dominant F"}, {"located F@northern third"}},
      {"Half of the houses are in the north, the other half in the south.",
       kSuburb,
       {"present B@northern third", "present B@southern third"},
       {"amount B"}},
  };
}

std::vector<Sample> Elsewhere() {
  return {
      {"No trees, plenty of water.", kSuburb, {"absent F", "amount W"}, {"absent W"}},
      {"No rocks and some bushes.", kWild, {"absent R", "present B"}, {"absent B"}},
      {"No water in the west, but some in the east.",
       kSuburb,
       {"absent W@western third", "present W@eastern third"}},
      {"No houses on the left, four on the right.",
       kSuburb,
       {"absent B@western third", "present B@eastern third", "count B 4..4"}},
      {"The south has no snow, the north has a lot.",
       kWild,
       {"absent S@southern third", "present S@northern third"}},
      {"There are no fields in the east. There are many in the west.",
       kSuburb,
       {"absent A@eastern third", "present A@western third"}},
      {"Lots of forest in the north, hardly any in the south.",
       kSuburb,
       {"present F@northern third", "amount F 0..8@southern third"}},
      {"The middle is free of trees, the edges are covered with them.",
       kSuburb,
       {"absent F@center", "dominant F@edges"}},
      {"Not many houses.", kSuburb, {"count B 1..5"}, {"absent B"}},
      {"There should not be too much water.", kSuburb, {"amount W"}, {"absent W"}},
      {"Only little forest.", kSuburb, {"amount F"}, {"dominant F"}},
      {"No big lake, just small ponds.", kSuburb, {"present W"}, {"absent W", "dominant W"}},
      {"Besides a small pond there is no water.", kSuburb, {"present W"}, {"absent W"}},
      {"Three houses in the north, two in the south.",
       kSuburb,
       {"count B 5..5", "present B@northern third", "present B@southern third"}},
      {"In the lower left there is rock, in the lower right too.",
       kWild,
       {"present R@lower left", "present R@lower right"}},
      // Near misses.
      {"No houses, roads or fields.", kSuburb, {"absent B", "absent R", "absent A"}},
      {"No lake in the north, but a river in the south.",
       kSuburb,
       {"absent W@northern third", "present W@southern third"}},
      {"A few little ponds.", kSuburb, {"count W 2..5"}},
      {"There are houses near the lake in the north, and a few in the south.",
       kSuburb,
       {"present B@southern third"},
       {"present W@southern third"}},
      {"There are trees along the road in the west, and some in the east.",
       kSuburb,
       {"present F@eastern third"},
       {"present R@eastern third"}},
      {"The west has houses along a river, the east has none.",
       kSuburb,
       {"absent B@eastern third"},
       {"absent W@eastern third"}},
      {"In the north there are trees along the river, in the south too.",
       kSuburb,
       {"present F@southern third"},
       {"present W@southern third"}},
      {"A lake near the forest. The north is covered by trees, the south is full of them.",
       kSuburb,
       {"present F@southern third"}},
  };
}

std::vector<Sample> PlacesAndNumbers() {
  return {
      {"One pond and forest everywhere else.", kSuburb, {"present W", "rest F"}, {"rest W"}},
      {"Some rocks, a lake, and snow elsewhere.", kWild, {"present R", "present W", "rest S"}},
      {"A single hut, otherwise fields.", kSuburb, {"present B", "rest A"}},
      {"The lower left corner has water, the other corners have trees.",
       kSuburb,
       {"present W@south-west corner", "present F@north-west corner", "present F@north-east corner",
        "present F@south-east corner"},
       {"present W@north-west corner"}},
      {"Every edge is forest except the northern one.",
       kSuburb,
       {"dominant F@southern edge", "dominant F@western edge", "dominant F@eastern edge"},
       {"dominant F@northern edge"}},
      {"All sides are snow, only the eastern one is rock.",
       kWild,
       {"dominant S@northern edge", "dominant R@eastern edge"},
       {"dominant S@eastern edge"}},
      {"Every edge wooded save the southern, which is water.",
       kSuburb,
       {"present F@northern edge", "dominant W@southern edge"},
       {"present F@southern edge", "present W@northern edge"}},
      {"Fields in every quarter except the lower left.",
       kSuburb,
       {"present A@north-western quarter"},
       {"present A@south-western quarter"}},
      {"Two houses in each corner.", kSuburb, {"count B 8..8"}, {"count B 2..2"}},
      {"One lake per quarter.", kSuburb, {"count W 4..4"}, {"amount W"}},
      {"A path along each edge.", kSuburb, {"along R@northern edge", "along R@western edge"}},
      {"One or two lakes.", kSuburb, {"count W 1..2"}},
      {"More than two but fewer than five houses.", kSuburb, {"count B 3..4"}},
      {"At least 3 lakes but no more than 6.", kSuburb, {"count W 3..6"}},
      {"Rows 1 to 16 are forest, rows 17 to 32 are grass.",
       kSuburb,
       {"dominant F@northern half", "dominant G@southern half"},
       {"count F 16..17"}},
      {"The north-east quarter is partly water.",
       kSuburb,
       {"present W@north-eastern quarter"},
       {"dominant W@north-eastern quarter"}},
      {"Forest is the largest area.", kSuburb, {"dominant F"}},
      {"The first half (top) is town, the second half (bottom) is forest.",
       kSuburb,
       {"dominant B@northern half", "dominant F@southern half"}},
      // Near misses.
      {"A village with forest on all sides except the west.", kSuburb, {"surrounds F B"}},
      {"One cottage on each side of the river.", kSuburb, {"count B 2..2", "both_sides B W"}},
      {"A lake in the middle, fields and forest elsewhere.", kSuburb, {"present A", "present F"}},
      {"At least two lakes and at most three villages.",
       kSuburb,
       {"count W 2..", "count B 1..3"},
       {"count W 2..3"}},
      {"At least one road and no more than three lakes in the north.",
       kSuburb,
       {"count W 1..3"},
       {"count R 1..3"}},
      {"At least two ponds and at most four lakes.", kSuburb, {"count W 2..4"}},
      {"Percentage of forest: 40, lakes: 2.",
       kSuburb,
       {"amount F 32..48", "present W"},
       {"amount W 0..7"}},
  };
}

class PlainPercentsTest : public testing::TestWithParam<Sample> {};
TEST_P(PlainPercentsTest, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainPercentsTest, ReadsCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Shares, PlainPercentsTest, testing::ValuesIn(Shares()));
INSTANTIATE_TEST_SUITE_P(SharesOfPlaces, PlainPercentsTest, testing::ValuesIn(SharesOfPlaces()));
INSTANTIATE_TEST_SUITE_P(Parts, PlainPercentsTest, testing::ValuesIn(Parts()));
INSTANTIATE_TEST_SUITE_P(Elsewhere, PlainPercentsTest, testing::ValuesIn(Elsewhere()));
INSTANTIATE_TEST_SUITE_P(PlacesAndNumbers, PlainPercentsTest,
                         testing::ValuesIn(PlacesAndNumbers()));

}  // namespace
}  // namespace latticeworld
