#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Turns of phrase that are put in plainer words before they are read.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Relations() {
  return {
      {"Apart from a pond in the south, the whole map is forest.",
       kSuburb,
       {"dominant F", "present W@southern third"},
       {"scattered W"}},
      {"The hamlet is separated from the sea by a belt of trees.", kSuburb, {"between F B W"}},
      {"The two hamlets are separated by a wood.", kSuburb, {"between F B B", "count B 2..2"}},
      {"The river splits the town into a northern and a southern half.",
       kSuburb,
       {"both_sides B W"},
       {"present W@northern edge", "count W 2..2"}},
      {"No trees within 3 cells of a barn.", kSuburb, {"apart F B"}, {"absent B", "absent F"}},
      {"The woods are as far from the lake as possible.", kSuburb, {"apart F W"}},
      {"The forest stops where the meadow begins.", kSuburb, {"adjacent F G"}},
      {"The river bends round the town.", kSuburb, {"adjacent W B"}, {"surrounds W B"}},
      {"The town hugs the coast, which runs down the eastern side.",
       kSuburb,
       {"adjacent B W", "present W@eastern third"}},
      {"On one side of the river there are fields, on the other side a wood.",
       kSuburb,
       {"between W A F"}},
      {"Fields to the left and to the right of the road.", kSuburb, {"both_sides A R"}},
      {"A river from west to east with a hamlet on each bank.", kSuburb, {"both_sides B W"}},
      {"A brook runs past the hamlet on the east.", kSuburb, {"direction W B E"}},
  };
}

std::vector<Sample> Amounts() {
  return {
      {"Water covers more than 40 percent.", kSuburb, {"amount W"}},
      {"Fields cover more than the forest.", kSuburb, {"more_than A F"}},
      {"Lots of forest, less grassland.", kSuburb, {"more_than F G"}},
      {"The fields cover more ground than everything else together.", kSuburb, {"dominant A"}},
      {"A pond. Fill whatever is left over with grass.", kSuburb, {"rest G"}},
      {"There are five ponds, three of them in the north.",
       kSuburb,
       {"count W 5..5"},
       {"count W 3..3"}},
      {"A pond in every quarter of the map.",
       kSuburb,
       {"present W@north-western quarter", "present W@south-eastern quarter"}},
  };
}

std::vector<Sample> Refusals() {
  return {
      {"A wood, a lake and a town, but no houses in the wood.",
       kSuburb,
       {"present F", "present B", "apart B F"},
       {"absent B", "absent F"}},
      {"Do not put houses near the lake.", kSuburb, {"apart B W"}, {"absent B", "absent W"}},
      {"Houses on both sides of the road but none near the river.",
       kSuburb,
       {"both_sides B R", "apart B W"},
       {"adjacent B W"}},
      {"Neither the barn nor the lake touches the road.",
       kSuburb,
       {"apart B R", "apart W R"},
       {"absent B", "absent W"}},
      {"Not much water, maybe 5 percent, woods 40, fields 40.",
       kSuburb,
       {"amount W", "amount F", "amount A"},
       {"absent W"}},
      {"No road reaches the eastern edge.", kSuburb, {"absent R@eastern edge"}},
      {"The barn is nearer to the lake than the wood.",
       kSuburb,
       {"adjacent B W"},
       {"more_than B F"}},
  };
}

std::vector<Sample> Rows() {
  return {
      {"First comes the town, then a meadow, then the woods, from left to right.",
       kSuburb,
       {"order BGF>E"}},
      {"From top to bottom you see ice, then rock, then heath.", kWild, {"order SRB>S"}},
      {"The lake is round and the wood long and thin.",
       kSuburb,
       {"shape W round", "shape F elongated"}},
      {"Around the town fields, around the fields forest.",
       kSuburb,
       {"surrounds A B", "surrounds F A"}},
      {"The town is surrounded by fields on all sides and those by forest.",
       kSuburb,
       {"surrounds A B", "surrounds F A"},
       {"present B@northern edge"}},
      {"Two parallel roads cross a river at right angles.",
       kSuburb,
       {"crosses R W"},
       {"present R@eastern third"}},
      {"Three of the four quarters are wooded; in the fourth, top right, lies a town.",
       kSuburb,
       {"present F@south-eastern quarter", "present B@north-eastern quarter"},
       {"present F@north-eastern quarter"}},
      {"Ice in two of the corners: top left and top right.",
       kWild,
       {"present S@upper left", "present S@upper right"},
       {"present S@south-west corner"}},
  };
}

std::vector<Sample> Allotments() {
  return {
      {"The eastern half is a third forest, a third grass and a third houses.",
       kSuburb,
       {"present F@eastern half", "amount F@eastern half", "amount G@eastern half",
        "amount B@eastern half"},
       {"dominant F@eastern half"}},
      {"Water in the western half. The eastern half should be farmland, grass and houses, "
       "roughly a third each.",
       kSuburb,
       {"present A@eastern half", "amount A@eastern half", "amount G@eastern half"}},
      {"Four fifths of the map is snow. The other fifth is half rock and half water.",
       kWild,
       {"amount S", "amount R", "amount W"}},
      {"A quarter of the map is water and a tenth is houses.", kSuburb, {"amount W", "amount B"}},
      {"The right half is split between a field at the top and a lake at the bottom.",
       kSuburb,
       {"dominant A@north-eastern quarter", "dominant W@south-eastern quarter"},
       {"present A@northern third"}},
      {"Split the map in half vertically: left forest, right water.",
       kSuburb,
       {"dominant F@western half", "dominant W@eastern half"}},
      {"The forest should take up the most space, followed by the fields.",
       kSuburb,
       {"dominant F", "more_than F A"},
       {"along A F"}},
      {"There should be more water than houses, but less than forest.",
       kSuburb,
       {"more_than W B", "more_than F W"}},
  };
}

std::vector<Sample> Counts() {
  return {
      {"Three houses in the north and two in the south.",
       kSuburb,
       {"count B 5..5"},
       {"count B 2..2"}},
      {"Two lakes in the west and one in the east.",
       kSuburb,
       {"present W@western third", "present W@eastern third"},
       {"count W 2..2"}},
      {"On the left there are three houses, on the right only one.",
       kSuburb,
       {"present B@western third", "present B@eastern third"},
       {"count B 1..1"}},
      {"Three lakes: a big one in the middle and two small ones in the north.",
       kSuburb,
       {"count W 3..3"},
       {"count W 4..4"}},
      {"The two northern corners are forest, the two southern ones are fields.",
       kSuburb,
       {"present A@south-west corner", "present A@south-east corner"},
       {"present A@southern third"}},
      {"Half of the houses are by the lake, the others by the road.",
       kSuburb,
       {"adjacent B W", "adjacent B R"},
       {"rest W"}},
      {"Most of the houses are in the west, a few in the east.",
       kSuburb,
       {"present B@western third", "present B@eastern third"},
       {"count B 2..5"}},
      {"Five houses, of which two stand by the lake.", kSuburb, {"count B 5..5"}, {"count B 2..2"}},
      {"Of the three lakes two are in the north.",
       kSuburb,
       {"count W 3..3", "present W@northern third"},
       {"count W 2..2"}},
      {"There are trees on both sides of the river and a path along its left side.",
       kSuburb,
       {"direction R W W"},
       {"direction R F W"}},
      {"Top: forest. Bottom: fields. Between them a river from left to right.",
       kSuburb,
       {"between W F A"},
       {"between W A A"}},
      {"In the west a forest, in the east a lake, in between a village.",
       kSuburb,
       {"between B F W"},
       {"present B@eastern third"}},
  };
}

std::vector<Sample> Exceptions() {
  return {
      {"A village with forest on all sides but the west.",
       kSuburb,
       {"surrounds F B"},
       {"present F@western edge"}},
      {"The lake is surrounded by forest on all sides except the south, where there are "
       "fields.",
       kSuburb,
       {"surrounds F W", "direction A W S"},
       {"absent W@southern third"}},
      {"The lake is surrounded by forest on three sides and by fields on the fourth.",
       kSuburb,
       {"surrounds F W", "adjacent W A"},
       {"surrounds W F"}},
      {"No buildings at all except one farm in the south.",
       kSuburb,
       {"present A@southern third"},
       {"absent A@southern third", "absent B@southern third"}},
      {"No houses apart from one in the center.",
       kSuburb,
       {"present B@center", "count B 1..1"},
       {"absent B@center"}},
      {"No forest except in the north.",
       kSuburb,
       {"located F@northern third"},
       {"absent F@northern third"}},
      {"Only the northern part is forested.", kSuburb, {"located F@northern third"}},
      {"Houses in the north only.", kSuburb, {"located B@northern third"}},
      {"Trees grow along the road only.", kSuburb, {"along F R"}, {"dominant F"}},
      {"Apart from the lake and the village the map is all grass.",
       kSuburb,
       {"dominant G"},
       {"adjacent G B"}},
      {"West of the road there are only houses and east of it only meadows.",
       kSuburb,
       {"direction B R W", "direction G R E"},
       {"dominant G@eastern third"}},
  };
}

class PlainWords : public testing::TestWithParam<Sample> {};

TEST_P(PlainWords, AreReadAsMeant) { ExpectRead(GetParam()); }
TEST_P(PlainWords, InCapitalsToo) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Relations, PlainWords, testing::ValuesIn(Relations()));
INSTANTIATE_TEST_SUITE_P(Amounts, PlainWords, testing::ValuesIn(Amounts()));
INSTANTIATE_TEST_SUITE_P(Refusals, PlainWords, testing::ValuesIn(Refusals()));
INSTANTIATE_TEST_SUITE_P(Rows, PlainWords, testing::ValuesIn(Rows()));
INSTANTIATE_TEST_SUITE_P(Allotments, PlainWords, testing::ValuesIn(Allotments()));
INSTANTIATE_TEST_SUITE_P(Counts, PlainWords, testing::ValuesIn(Counts()));
INSTANTIATE_TEST_SUITE_P(Exceptions, PlainWords, testing::ValuesIn(Exceptions()));

}  // namespace
}  // namespace latticeworld
