#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Rows that are told as a journey, what words point to, parts of the map and what the rest is.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Journeys() {
  return {
      {"Walking north from the lake in the south you pass a field, a wood and finally reach the "
       "village.",
       kSuburb,
       {"order WAFB>N", "present W@southern third"},
       {"adjacent A B"}},
      {"Heading east you cross fields, then a wood, then reach a town.", kSuburb, {"order AFB>E"}},
      {"Starting in the south-west with fields, moving through a village in the middle, and ending "
       "with a forest in the north-east.",
       kSuburb,
       {"present A@lower left", "present B@center", "present F@upper right"},
       {"within A B"}},
      {"From the north: snow, followed by rock, followed by forest.", kWild, {"order SRF>S"}},
      {"Snow-capped peaks in the north gradually give way to rocky slopes, then to forest and "
       "finally to a lake in the south.",
       kWild,
       {"order SRFW>S"},
       {"adjacent S F", "adjacent S W"}},
      {"Fields on the left turn into meadow and then into forest.", kSuburb, {"order AGF>E"}},
  };
}

std::vector<Sample> Sides() {
  return {
      {"A lake in the west, a village to the east of it and a wood to the east of that.",
       kSuburb,
       {"direction B W E", "direction F B E"}},
      {"The fields are south of the village and the wood is south of those.",
       kSuburb,
       {"direction A B S", "direction F A S"}},
      {"The village sits west of the river, the fields east of it, and further east still the "
       "forest.",
       kSuburb,
       {"direction A W E", "direction F A E"},
       {"present F@eastern third"}},
      {"On the right there's a lake, to the left of it a village, and further left a forest.",
       kSuburb,
       {"direction B W W", "direction F B W"}},
      {"North of the town is a wood, and further north a lake.",
       kSuburb,
       {"direction W F N"},
       {"present W@northern third"}},
      {"A river divides the land into two halves, forest on the western side and fields on the "
       "eastern one.",
       kSuburb,
       {"present F@western third", "present A@eastern third"},
       {"count W 2..2", "through W F"}},
      {"A river divides the map into two unequal parts.", kSuburb, {"present W"}, {"count W 2..2"}},
      {"A river runs diagonally across the map.", kSuburb, {"present W"}},
  };
}

std::vector<Sample> Followers() {
  return {
      {"A road runs along the northern shore of the lake.",
       kSuburb,
       {"along R W", "direction R W N"}},
      {"A road hugs the river.", kSuburb, {"along R W"}},
      {"The track skirts the forest.", kSuburb, {"along R F"}},
      {"Two roads run parallel to each other from east to west, with houses between them.",
       kSuburb,
       {"parallel R R", "between B R R"}},
      {"The road mirrors the course of the river.", kSuburb, {"parallel R W"}},
      {"Three roads down the map, side by side.",
       kSuburb,
       {"parallel R R", "course R northern edge>southern edge"}},
      {"A road runs the length of the map.", kSuburb, {"course R northern edge>southern edge"}},
  };
}

std::vector<Sample> Others() {
  return {
      {"A forest occupies the western half; the other half is grassland.",
       kSuburb,
       {"dominant F@western half", "dominant G@eastern half"}},
      {"Forest in the top half, with a cabin in it; the other half is open grass.",
       kSuburb,
       {"within B F", "dominant G@southern half"}},
      {"The top third is forest, the other two thirds are water.",
       kSuburb,
       {"dominant W@southern two thirds"},
       {"present W@northern third"}},
      {"One half is water, the other half is forest.", kSuburb, {"amount W", "amount F"}},
      {"The map is split into two halves: forest and grass.", kSuburb, {"amount F", "amount G"}},
      {"A road with houses on one side and fields on the other.",
       kSuburb,
       {"between R B A", "adjacent B R", "adjacent A R"},
       {"within B A", "adjacent B A"}},
      {"Forest on one side of the river, grass on the other.",
       kSuburb,
       {"between W F G"},
       {"adjacent G F"}},
      {"A village where the sand meets the grass.", kSuburb, {"adjacent B D", "adjacent B G"}},
      {"A lake inside a forest inside a desert.",
       kSuburb,
       {"within W F", "within F D"},
       {"within W D"}},
      {"A house in the fields in the north.", kSuburb, {"within B A", "present A@northern third"}},
      {"A lake with forest on three sides.", kSuburb, {"surrounds F W"}, {"dominant F"}},
      {"Keep the center empty.", kSuburb, {"dominant G@center"}},
      {"2 rivers, both N->S.",
       kSuburb,
       {"course W northern edge>southern edge", "count W 2..2"},
       {"present W@southern edge"}},
      {"A road in the shape of an S.", kSuburb, {"shape R winding"}, {"present R@southern third"}},
  };
}

std::vector<Sample> Pointers() {
  return {
      {"A small forest west of the house and a big one east of it.",
       kSuburb,
       {"direction F B W", "direction F B E"},
       {"amount B"}},
      {"There's a river, north of which everything is forest, and south of which everything is "
       "fields.",
       kSuburb,
       {"direction F W N", "direction A W S"}},
      {"A lake in the north, from which a river flows to the south edge.",
       kSuburb,
       {"course W northern third>southern edge"}},
      {"A pond, around it sand, around that forest.",
       kSuburb,
       {"surrounds D W", "surrounds F D"},
       {"surrounds D F"}},
      {"Concentric rings: water in the middle, then sand, then grass, then forest at the edge.",
       kSuburb,
       {"surrounds D W", "surrounds G D", "surrounds F G", "present F@edges"}},
  };
}

std::vector<Sample> Plainly() {
  return {
      {"From west to east I'd like first a forest, then open grassland, then some fields, and "
       "finally a lake at the far right.",
       kSuburb,
       {"order FGAW>E"},
       {"course F western edge>eastern edge"}},
      {"A river comes in from the north, makes one wide bend in the middle, and flows out on the "
       "east side.",
       kSuburb,
       {"course W northern edge>eastern edge", "shape W bent"}},
      {"river runing along the souther edge", kSuburb, {"along W@southern edge"}},
      {"The road is always near the shore of the lake, like half circle.",
       kSuburb,
       {"along R W"},
       {"shape R ring"}},
      {"Mostly bare ground, like a quarry.", kSuburb, {"dominant D"}},
      {"A pond. Leave the remainder to cornfields.", kSuburb, {"rest A"}},
      {"Sea in the north, and the rest of it forest.", kSuburb, {"rest F"}},
      {"A city what is crossed by two streets, first from north to south and second from west to "
       "east.",
       kSuburb,
       {"course R northern edge>southern edge", "course R western edge>eastern edge"}},
      {"The ground east of the road is used for farming.", kSuburb, {"direction A R E"}},
      {"A river that splits in two arms around a sandy iland.", kSuburb, {"surrounds W D"}},
      {"Trees line the shore of the lake all around.",
       kSuburb,
       {"surrounds F W"},
       {"surrounds W F"}},
      {"The river makes many curves.", kSuburb, {"shape W winding"}, {"count W 4.."}},
      {"A road passes south of all three. Fields, a village and a lake from west to east.",
       kSuburb,
       {"order ABW>E"},
       {"count R 3..3"}},
      {"A road crosses a river in the middle. Houses around the bridge.",
       kSuburb,
       {"adjacent B R", "adjacent B W"}},
      {"lake. big. middle.", kSuburb, {"present W@center"}},
      {"Two rivers, one in the west and one in the east. In the land between them: fields.",
       kSuburb,
       {"between A W W"}},
      {"A wood in the upper right corner and a lake besides the wood.", kSuburb, {"adjacent W F"}},
      {"Fields, and a track splitting it down the middle from north to south.",
       kSuburb,
       {"course R northern edge>southern edge"}},
  };
}

std::vector<Sample> Denials() {
  return {
      {"There's no forest anywhere, nor are there any roads.", kSuburb, {"absent F", "absent R"}},
      {"Snow in the top half. Lake-free and boulder-free.", kWild, {"absent W", "absent R"}},
      {"Fields. Never saw a house, a stream or so much as a puddle.",
       kSuburb,
       {"absent B", "absent W"}},
      {"A lake with forest all the way around.", kSuburb, {"surrounds F W"}},
      {"A road along the bottom of the map.", kSuburb, {"along R@southern edge"}},
      {"A barn well away from any trees, ten cells at the very least, but on the road.",
       kSuburb,
       {"apart B F"},
       {"count B 10..10"}},
      {"Snow 30, rock 30, forest 20, all figures in percent.",
       kWild,
       {"amount S", "amount R", "amount F"},
       {"count S 24..24"}},
      {"A glacier and a forest, the latter several times the size of the former.",
       kWild,
       {"more_than F S"},
       {"count F 3.."}},
      {"The forest on the right, no, hang on, on the left.",
       kSuburb,
       {"present F@western third"},
       {"present F@eastern third"}},
  };
}

std::vector<Sample> Wholes() {
  return {
      {"The western third should be woodland. In the middle third put farms. The eastern third is "
       "for the lake.",
       kSuburb,
       {"present A@middle columns"},
       {"present A@middle rows"}},
      {"Snow in the upper third, rock in the second third and forest in the bottom third.",
       kWild,
       {"dominant R@middle rows"},
       {"within R S"}},
      {"Buildings fill the whole map except for a park in the middle.",
       kSuburb,
       {"dominant B", "present G@center"},
       {"scattered B"}},
      {"Start from an all-forest map, then carve out a lake in the middle.",
       kSuburb,
       {"dominant F", "present W@center"}},
      {"A frame of trees around the whole map.", kSuburb, {"present F@edges"}},
  };
}

std::vector<Sample> Bases() {
  return {
      {"A lake in the middle. The background is grass.",
       kSuburb,
       {"rest G"},
       {"present G@northern third"}},
      {"Houses in the north. Default terrain: forest.", kSuburb, {"rest F"}},
      {"A road, a pond and some houses; grass fills in the gaps.", kSuburb, {"rest G"}},
      {"A pond. Anything not mentioned can be forest.", kSuburb, {"rest F"}, {"absent F"}},
      {"A lake in the foreground. The background is forest.",
       kSuburb,
       {"present F@northern third"}},
      {"The bulk is forest.", kSuburb, {"dominant F"}},
      {"The lion's share is farmland.", kSuburb, {"dominant A"}},
  };
}

class PlainJourneysTest : public testing::TestWithParam<Sample> {};

TEST_P(PlainJourneysTest, AreRead) {
  ExpectRead(GetParam());
  ExpectReadInCapitals(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Journeys, PlainJourneysTest, testing::ValuesIn(Journeys()));
INSTANTIATE_TEST_SUITE_P(Sides, PlainJourneysTest, testing::ValuesIn(Sides()));
INSTANTIATE_TEST_SUITE_P(Followers, PlainJourneysTest, testing::ValuesIn(Followers()));
INSTANTIATE_TEST_SUITE_P(Others, PlainJourneysTest, testing::ValuesIn(Others()));
INSTANTIATE_TEST_SUITE_P(Pointers, PlainJourneysTest, testing::ValuesIn(Pointers()));
INSTANTIATE_TEST_SUITE_P(Plainly, PlainJourneysTest, testing::ValuesIn(Plainly()));
INSTANTIATE_TEST_SUITE_P(Denials, PlainJourneysTest, testing::ValuesIn(Denials()));
INSTANTIATE_TEST_SUITE_P(Wholes, PlainJourneysTest, testing::ValuesIn(Wholes()));
INSTANTIATE_TEST_SUITE_P(Bases, PlainJourneysTest, testing::ValuesIn(Bases()));

}  // namespace
}  // namespace latticeworld
