#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Lists of short sentences, each of which says one thing of what was named before.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> OnlyOnes() {
  return {
      {"Exactly one road. A road connects the houses and the lake.",
       kSuburb,
       {"count R 1..1", "connects R B W"}},
      {"Exactly one lake. A lake inside the forest. The lake is round.",
       kSuburb,
       {"count W 1..1", "within W F", "shape W round"}},
      {"Exactly one village. A village in the center.",
       kSuburb,
       {"count B 1..1", "present B@center"}},
      {"Exactly one lake. A small lake in the west.", kSuburb, {"count W 1..1"}},
      {"There is only one river. A canal runs from the northern edge to the southern edge.",
       kSuburb,
       {"count W 1..1", "course W northern edge>southern edge"}},
      {"Exactly one patch of snow. Rock surrounds the snow.",
       kWild,
       {"count S 1..1", "surrounds R S"}},
      {"Exactly one forest. A forest in the north.", kWild, {"count F 1..1"}},
      {"Exactly one group of buildings. Buildings in the west.",
       kSuburb,
       {"count B 1..1", "present B@western third"}},
      {"One single lake. Houses around a lake.", kSuburb, {"count W 1..1", "surrounds B W"}},
      {"Exactly one body of water. A lake in the middle. The lake is round.",
       kSuburb,
       {"count W 1..1", "shape W round"}},
      {"Exactly one ridge of rock. A ridge of rock runs from west to east.",
       kWild,
       {"count R 1..1", "course R western edge>eastern edge"}},
      // Others than that one.
      {"A single road crosses the map from west to east. A road branches off it to the village.",
       kSuburb,
       {"course R western edge>eastern edge"}},
      {"Exactly one road. A road runs from the western edge to the eastern edge. A road leads from "
       "the lake to the village.",
       kSuburb,
       {"course R western edge>eastern edge"}},
      {"Exactly one lake in the north. A lake in the south.", kSuburb, {}, {"count W 1..1"}},
      {"Exactly one lake. Another lake in the west.", kSuburb, {}, {"count W 1..1"}},
      {"Exactly one lake in the forest. A lake in the farmland.", kSuburb, {}, {"count W 1..1"}},
      {"Only one house stands by the lake. A house in the forest.", kSuburb, {}, {"count B 1..1"}},
  };
}

std::vector<Sample> Several() {
  return {
      {"Exactly two lakes. A lake in the west. A lake in the east.",
       kSuburb,
       {"count W 2..2", "present W@western third", "present W@eastern third"}},
      {"Exactly two lakes in the middle third. A lake in the west. A lake in the east.",
       kSuburb,
       {"count W 2..2"}},
      {"Exactly two villages. A village in the north. A village in the south. A road connects the "
       "two villages.",
       kSuburb,
       {"count B 2..2", "connects R B B"}},
      {"Exactly three lakes. A lake in the northern third. A lake in the southern third.",
       kWild,
       {"count W 3..3"}},
      {"Exactly three ponds. Two ponds in the north. One pond in the south.",
       kSuburb,
       {"count W 3..3"},
       {"count W 5..5"}},
      {"Exactly four ponds. A pond in each corner.",
       kSuburb,
       {"count W 4..4", "present W@north-west corner"}},
      {"A village in the north. A village in the south. Exactly two villages.",
       kSuburb,
       {"count B 2..2"}},
      {"Exactly two roads. Two parallel roads. The roads run from the northern edge to the "
       "southern edge. Houses lie between the two roads.",
       kSuburb,
       {"parallel R R", "between B R R", "course R northern edge>southern edge"},
       {"count R 4..4"}},
      {"Exactly two roads. Two straight roads cross in the middle.", kSuburb, {"crosses R R"}},
      {"Exactly two water bodies. Each lies in the interior. No building is near the water.",
       kSuburb,
       {"count W 2..2", "present W@interior"}},
      {"Two lakes in the west. A lake in the east.", kSuburb, {}, {"count W 2..2"}},
      {"Exactly two lakes in the west. A lake in the east.", kSuburb, {}, {"count W 2..2"}},
      {"Exactly three ponds. A pond in the north. A pond in the south. A pond in the west. A pond "
       "in the east.",
       kSuburb,
       {},
       {"count W 3..3"}},
      {"Exactly four meadows. The meadows are inside the forest. A house inside every meadow.",
       kSuburb,
       {"count G 4..4", "count B 4..4", "within B G", "within G F"}},
      {"Four ponds. A house next to each pond.", kSuburb, {"count B 4..4", "adjacent B W"}},
      {"A house inside every meadow.", kSuburb, {"within B G"}, {"count B 1..1"}},
  };
}

std::vector<Sample> Shapes() {
  return {
      {"A road runs from the western edge to the eastern edge. A straight road.",
       kSuburb,
       {"course R western edge>eastern edge", "shape R straight"}},
      {"A canal runs from the western edge to the eastern edge. A straight river.",
       kSuburb,
       {"shape W straight"}},
      {"A lake in the center. A long narrow lake. The lake is diagonal.",
       kSuburb,
       {"shape W elongated"}},
      {"A lake in the northern half. A long narrow lake. The lake runs from west to east.",
       kWild,
       {"shape W elongated", "present W@northern half"}},
      {"A river runs from the northern edge to the southern edge. Houses along the river. A "
       "winding "
       "river.",
       kSuburb,
       {"shape W winding"}},
      {"A straight strip of grassland.", kWild, {"shape B straight"}, {"shape B elongated"}},
      {"A lake in the west. A round lake in the east.", kSuburb, {}, {"shape W round"}},
      {"A road runs from the western edge to the eastern edge. A winding path.",
       kSuburb,
       {},
       {"shape R winding"}},
      {"A lake in the west. Forest in the east. A road in the north. A round pond.",
       kSuburb,
       {},
       {"shape W round"}},
  };
}

std::vector<Sample> Bounds() {
  return {
      {"At least four groves. At most five groves.", kSuburb, {"count F 4..5"}, {"count F 5.."}},
      {"At most six ponds. At least four ponds.", kWild, {"count W 4..6"}},
      {"At least three lakes. At most two lakes.", kSuburb, {}, {"count W 3..2", "count W 2..2"}},
      {"At least four ponds. At most five houses.", kSuburb, {"count W 4..", "count B 1..5"}},
      {"Several groves. The groves do not touch each other.",
       kSuburb,
       {"count F 3..", "apart F F"}},
      {"Exactly four ponds. Grassland surrounds the ponds. The ponds do not touch each other.",
       kSuburb,
       {"count W 4..4", "apart W W", "surrounds G W"},
       {"apart W G"}},
      {"Exactly four ponds. Grassland surrounds the ponds. None of the ponds touch.",
       kSuburb,
       {"count W 4..4", "apart W W"},
       {"absent W"}},
      {"The houses do not touch each other.", kSuburb, {"apart B B"}, {"scattered B"}},
      {"The road and the river do not touch each other.", kSuburb, {"apart W R"}},
  };
}

std::vector<Sample> Amounts() {
  return {
      {"At least 10 percent forest. At most 20 percent forest.", kSuburb, {"amount F 10..20"}},
      {"Forest covers at least 10 percent of the map. Forest covers at most 20 percent of the map.",
       kSuburb,
       {"amount F 10..20"}},
      {"Water covers at most a fifth of the map. Water covers at least a tenth of the map.",
       kWild,
       {"amount W 10..20"}},
      {"At least 30 percent of the map is snow. At most 40 percent of the map is snow.",
       kWild,
       {"amount S 30..40"}},
      {"At least 10 percent forest. At most 20 percent farmland.",
       kSuburb,
       {},
       {"amount F 10..20", "amount A 10..20"}},
      {"At least 30 percent of the map is forest, no, at most 20 percent.",
       kSuburb,
       {},
       {"amount F 30..20"}},
  };
}

std::vector<Sample> Spread() {
  return {
      {"Houses are scattered all over the map.", kSuburb, {"scattered B"}},
      {"Trees are scattered across the whole map.", kSuburb, {"scattered F"}, {"dominant F"}},
      {"Bushes are sprinkled across the entire map.", kWild, {"scattered B"}, {"dominant B"}},
      {"Forest is spread across the whole map.", kSuburb, {"dominant F"}, {"scattered F"}},
      {"Forest covers more of the map than anything else.", kSuburb, {"dominant F"}, {"rest F"}},
      {"More farmland than any other land.", kSuburb, {"dominant A"}, {"rest A"}},
      {"There is more snow than any other kind of ground. A lake in the north.",
       kWild,
       {"dominant S"}},
      {"More forest than farmland.", kSuburb, {"more_than F A"}, {"dominant F"}},
      {"Exactly four villages. No village holds more than half of the buildings.",
       kSuburb,
       {"count B 4..4"},
       {"absent B"}},
      {"Three lakes. None of the lakes holds more than half of the water.",
       kWild,
       {"count W 3..3"},
       {"absent W"}},
      {"No village in the forest.", kSuburb, {"apart B F"}},
      {"A lake in the center. Only grassland south of the lake.",
       kSuburb,
       {"direction G W S"},
       {"dominant G", "amount G"}},
      {"Only snow is north of the lake.", kWild, {"direction S W N"}, {"amount S"}},
      {"Only forest.", kSuburb, {"dominant F", "amount F"}},
      {"Only forest in the north.", kSuburb, {"dominant F@northern third"}},
  };
}

class ListedSentencesTest : public testing::TestWithParam<Sample> {};
TEST_P(ListedSentencesTest, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(ListedSentencesTest, ReadsCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(OnlyOnes, ListedSentencesTest, testing::ValuesIn(OnlyOnes()));
INSTANTIATE_TEST_SUITE_P(Several, ListedSentencesTest, testing::ValuesIn(Several()));
INSTANTIATE_TEST_SUITE_P(Shapes, ListedSentencesTest, testing::ValuesIn(Shapes()));
INSTANTIATE_TEST_SUITE_P(Bounds, ListedSentencesTest, testing::ValuesIn(Bounds()));
INSTANTIATE_TEST_SUITE_P(Amounts, ListedSentencesTest, testing::ValuesIn(Amounts()));
INSTANTIATE_TEST_SUITE_P(Spread, ListedSentencesTest, testing::ValuesIn(Spread()));

}  // namespace
}  // namespace latticeworld
