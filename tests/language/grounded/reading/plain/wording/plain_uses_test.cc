#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// Keys and values, who uses the land, what divides it, twos and threes, and what the rest is.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Labels() {
  return {
      {"heath with tarns. bare rock: 0. ice: 0. rest = heath",
       kWild,
       {"absent R", "absent S", "rest B"},
       {"present R", "present S"}},
      {"trees=off; grass=off; houses=off", kSuburb, {"absent F", "absent G", "absent B"}},
      {"forest=70 %, water=10 %, rock=20 %, snow=0 %. Rock only in the upper half.",
       kWild,
       {"amount F", "amount W", "amount R", "absent S", "located R@northern half"},
       {"absent F", "absent W"}},
      {"Northern half: taiga, southern half: bog.",
       kSuburb,
       {"dominant F@northern half", "dominant W@southern half"}},
      {"villages - NE, SE. lake - W. woods - none.",
       kSuburb,
       {"present B@upper right", "present B@lower right", "present W@western third", "absent F"}},
      {"A ridge of rock splits the woods in 2.", kWild, {"both_sides F R"}},
      {"In the east are 2 small villages and a road that joins them.",
       kSuburb,
       {"count B 2..2", "connects R B B"}},
      {"2 to 4 ponds, a 2 cell wide road", kSuburb, {"count W 2..4"}, {"count R 2..2"}},
      {"Streets? None.", kSuburb, {"absent R"}, {"present R"}},
      {"A round lake. Roads? None at all.", kSuburb, {"shape W round", "absent R"}},
      {"Three ponds at least.", kSuburb, {"count W 3.."}, {"count W 3..3"}},
      {"Huts dotted about, 5 clusters minimum.", kSuburb, {"count B 5.."}},
      {"Fields in the NW and SE quadrant, forest in the other 2.",
       kSuburb,
       {"present F@north-eastern quarter", "present F@south-western quarter"}},
      {"Two roads, both N to S. fields left of them and right of them.",
       kSuburb,
       {"course R northern edge>southern edge", "count R 2..2"},
       {"course A northern edge>southern edge"}},
      {"Theres a lake in the north. There isnt a road. I dont want houses.",
       kSuburb,
       {"present W@northern third", "absent R", "absent B"}},
  };
}

std::vector<Sample> Uses() {
  return {
      {"About two thirds of the parish is open grass.", kSuburb, {"amount G"}, {"present B"}},
      {"People live on both banks of the river.", kSuburb, {"present B", "both_sides B W"}},
      {"A town in the upper left quarter; let cows graze the other three.",
       kSuburb,
       {"present G@north-eastern quarter", "present G@south-western quarter",
        "present G@south-eastern quarter"}},
      {"The north is under the plough.", kSuburb, {"present A@northern third"}},
      {"You can forget about forests. A lake in the north.",
       kSuburb,
       {"absent F", "present W@northern third"}},
      {"Mostly town, hardly any green.", kSuburb, {"dominant B", "amount G"}},
      {"The road to the estate arrives from the west and not, as in your last draft, from the "
       "east.",
       kSuburb,
       {"adjacent R B"},
       {"present R@eastern edge"}},
      {"Two cottages, one on each bank of the river.", kSuburb, {"count B 2..2", "both_sides B W"}},
      {"Three lakes, lying one below the other, none touching the next. Pines round each of them.",
       kWild,
       {"count W 3..3"},
       {"count W 1..1"}},
      {"A round lake in the middle and a ring of cliffs about the lake.", kWild, {"surrounds R W"}},
      {"All along the top it's snow.", kWild, {"present S@northern edge"}},
      {"A hamlet. The nearest stream runs east of it, from north to south.",
       kSuburb,
       {"course W northern edge>southern edge", "direction W B E"}},
      {"A corridor of heath from the southern edge to the northern, walled by rock on the left "
       "hand and on the right.",
       kWild,
       {"both_sides B R"}},
      {"A loop lane in the middle of the map with a lake inside the loop.",
       kSuburb,
       {"shape R ring", "surrounds R W"}},
      {"The track is one closed loop. The infield is sand.",
       kSuburb,
       {"shape R ring", "surrounds R D"}},
      {"One small pond in the middle, and that is the only water.",
       kSuburb,
       {"count W 1..1"},
       {"count W 2..2"}},
      {"A lake in the north. Anything you like except houses.", kSuburb, {"absent B"}},
      {"There are two woods, a larger and a smaller one. The former fills the north-west, the "
       "latter hides in the south-east.",
       kSuburb,
       {"count F 2..2", "present F@upper left", "present F@lower right"}},
      {"Bare ground in the east, pasture in the west. A road follows the line where the two meet.",
       kSuburb,
       {"between R D G"}},
      {"A lake in the north. Farmland in all the space that's left.", kSuburb, {"rest A"}},
      {"Nothing much but forest.", kWild, {"dominant F"}},
      {"Town in the middle, boxed in by a ring road.", kSuburb, {"surrounds R B"}},
  };
}

std::vector<Sample> Pairs() {
  return {
      {"There are two lakes, a big one in the north and a small one in the south.",
       kSuburb,
       {"count W 2..2", "present W@northern third", "present W@southern third"}},
      {"One road leads from the village to the lake and another from the village to the forest.",
       kSuburb,
       {"connects R B W", "connects R B F"},
       {"count R 1..1", "adjacent W F"}},
      {"Ring road. Town inside.", kSuburb, {"shape R ring", "surrounds R B"}},
      {"A ring of trees with a house inside it.", kSuburb, {"surrounds F B"}},
      {"A road leads from the western edge into the village and ends there.",
       kSuburb,
       {"present R@western edge", "adjacent R B"},
       {"present B@eastern edge"}},
      {"A road from the village going north to the edge.",
       kSuburb,
       {"present R@northern edge", "adjacent R B"},
       {"present B@northern third"}},
      {"A single house in the middle of nowhere, just grass around it.",
       kSuburb,
       {"present B@center", "count B 1..1", "surrounds G B"},
       {"absent B"}},
      {"Make the left side more forested than the right side.",
       kSuburb,
       {"present F@western third"},
       {"present F@eastern third"}},
      {"Rocks scattered all over the grassland.", kWild, {"scattered R"}, {"scattered B"}},
      {"No vegetation.", kWild, {"absent F", "absent B"}},
      {"A wide river with rocky banks.", kWild, {"both_sides R W"}},
  };
}

std::vector<Sample> Measures() {
  return {
      {"forest 40 %, bushes 30 %, rock 20 % and water 10 %.",
       kWild,
       {"amount F 32..48", "amount B 22..38", "amount R 12..28"}},
      {"forest 40%, rock 50%, and water for the remaining 10%.",
       kWild,
       {"amount F 32..48", "amount R 42..58"}},
      {"forest 40, fields 30, water 10 and houses 20 percent",
       kSuburb,
       {"amount F 32..48", "amount A 22..38", "amount B 12..28"},
       {"count W 10..10"}},
      {"Equal amounts of forest and grass.", kSuburb, {"amount F 40..60"}},
      {"Housing may take up to 20 percent.", kSuburb, {"amount B 0..20"}},
      {"Put a 5 by 5 lake in the center.", kSuburb, {"present W@center"}, {"count W 5..5"}},
      {"Change the right third to farmland.", kSuburb, {"dominant A@eastern third"}},
      {"The river makes a big curve around the village.",
       kSuburb,
       {"shape W bent", "adjacent W B"},
       {"shape W ring"}},
      {"All the houses are in the north.", kSuburb, {"located B@northern third"}},
      {"The buildings are all located on the left side.", kSuburb, {"located B@western third"}},
      {"Seven lakes, every one of them in the western half.",
       kSuburb,
       {"count W 7..7", "located W@western half"}},
      {"The map is split by a river into an eastern and a western part. The eastern part is "
       "forest.",
       kSuburb,
       {"course W northern edge>southern edge", "present F@eastern third"},
       {"present W@eastern edge"}},
      {"A river splits the map into a left and a right part; the left one is forest and the right "
       "one is grass.",
       kSuburb,
       {"dominant F@western half", "dominant G@eastern half"},
       {"present W@western third"}},
      {"Half of the forest is in the north, the other half in the south.",
       kSuburb,
       {"present F@northern third", "present F@southern third"},
       {"amount F 42..58"}},
      {"Forest in the lower half and nothing growing in the upper half.",
       kWild,
       {"absent F@northern half", "absent B@northern half"},
       {"present F@northern half"}},
      {"Houses around a green, the green with a small pond in its middle.",
       kSuburb,
       {"surrounds B G", "within W G"}},
      {"A castle with a moat all around it.", kSuburb, {"shape W ring", "surrounds W B"}},
  };
}

std::vector<Sample> Rests() {
  return {
      {"Everything except the lake is forest.", kSuburb, {"dominant F", "present W"}},
      {"Aside from the lake it's all trees.", kSuburb, {"dominant F"}, {"adjacent F W"}},
      {"Use meadow as filler. A lake in the north.", kSuburb, {"rest G"}},
      {"A road and a house. Where there is no road or house, put grass.",
       kSuburb,
       {"rest G"},
       {"adjacent G R"}},
      {"Surround everything with forest.", kSuburb, {"present F@edges"}},
      {"More than half of the map is forest.", kSuburb, {"amount F"}},
      {"More than half of the houses are in the north.", kSuburb, {}, {"amount B"}},
  };
}

std::vector<Sample> Journeys() {
  return {
      {"Runners go north: across a strip of grass, then through the trees, then up to a village.",
       kSuburb,
       {"order GFB>N"}},
      {"You run north: fields first, then the town, then a forest, and finally a meadow.",
       kSuburb,
       {"order ABFG>N"}},
      {"From the left edge inwards: water, sand, grass.", kSuburb, {"order WDG>E"}},
      {"From the center outwards: water, sand, grass.",
       kSuburb,
       {"surrounds D W", "surrounds G D"}},
      {"Layers from the top down: forest, fields, a village.", kSuburb, {"order FAB>S"}},
  };
}

std::vector<Sample> Divisions() {
  return {
      {"A straight road divides the map into a forested north and an open south.",
       kSuburb,
       {"course R western edge>eastern edge", "dominant F@northern third",
        "dominant G@southern third"},
       {"present R@northern third"}},
      {"Put a lake in one corner and a village in the opposite corner.",
       kSuburb,
       {"present W@north-west corner", "present B@south-east corner"},
       {"present B@north-west corner"}},
      {"Half forest, half field, with a road along the border.",
       kSuburb,
       {"between R F A"},
       {"along R@edges"}},
      {"A pond in front of the house and a forest behind it.",
       kSuburb,
       {"direction W B S", "direction F B N"},
       {"direction F W S"}},
      {"A river runs diagonally and a road runs parallel to it.", kSuburb, {"parallel R W"}},
      {"The lower right quarter is a lake. The other three quarters are forest.",
       kSuburb,
       {"present W@south-eastern quarter", "present F@north-western quarter"},
       {"present F@western three quarters"}},
      {"Cover the top third with forest, leave the middle third empty and fill the bottom third "
       "with water.",
       kSuburb,
       {"dominant F@northern third", "dominant G@middle rows", "dominant W@southern third"},
       {"present W@northern third"}},
      {"About a quarter water, the rest split evenly between forest and farmland.",
       kSuburb,
       {"amount W", "amount F", "amount A"},
       {"rest W", "between W F A"}},
      {"Half the map is water, and the rest is land with some houses.",
       kSuburb,
       {"amount W", "present B"},
       {"dominant B", "rest B"}},
      {"A village by the lake and another one in the forest.",
       kSuburb,
       {"adjacent B W", "within B F"},
       {"within W F"}},
      {"Two small lakes and some bare rock between them.",
       kWild,
       {"count W 2..2", "between R W W"}},
      {"A rocky island in a lake. A forest in the middle of the island.",
       kWild,
       {"within R W", "within F R"},
       {"within F B"}},
      {"A lake shaped like an L.", kSuburb, {"shape W bent"}},
      {"Half of the land is forest and the other half is rock, separated by a river.",
       kSuburb,
       {"amount F", "amount D", "between W F D"}},
      {"The northern half is forest, the southern half is grass and a river runs along the "
       "boundary.",
       kSuburb,
       {"dominant F@northern half", "dominant G@southern half", "between W F G"},
       {"present W@southern half"}},
      {"The fields are bordered by trees on the north and by a road on the south.",
       kSuburb,
       {"direction F A N", "direction R A S"},
       {"present A@southern third"}},
      {"Three horizontal bands. Top: forest. Middle: grass. Bottom: water.",
       kSuburb,
       {"present F@northern third", "present G@middle rows", "present W@southern third"}},
      {"Trees line the river.", kSuburb, {"along F W"}},
      {"A road runs beside the river all the way.", kSuburb, {"along R W"}},
      {"The road makes a right angle turn in the center.",
       kSuburb,
       {"present R@center", "shape R bent"},
       {"present R@eastern third"}},
      {"Put trees everywhere except along the road.", kSuburb, {"apart F R"}, {"along F R"}},
      {"Leave some space between the forest and the road.", kSuburb, {"apart F R"}},
  };
}

// What the turns must keep off.
std::vector<Sample> Others() {
  return {
      {"Two lakes in the west and one in the east.", kSuburb, {"count W 3..3"}},
      {"Two lakes in the west, one in the north-west and one in the south-west.",
       kSuburb,
       {"count W 2..2", "present W@upper left", "present W@lower left"}},
      {"Six houses in the north, three by the lake and three by the road.",
       kSuburb,
       {"count B 6..6"}},
      {"Don't forget trees around the lake.", kSuburb, {"surrounds F W"}, {"absent F"}},
      {"A lake in the north. Surrounded by forest, the village lies in the south.",
       kSuburb,
       {"surrounds F B"},
       {"surrounds F W"}},
      {"In the north, a lake: deep and wide.", kSuburb, {"present W@northern third"}},
      {"On the left, houses: five of them.", kSuburb, {"present B@western third", "count B 5..5"}},
      {"A road goes from the lake to the village, where it ends.",
       kSuburb,
       {"connects R W B"},
       {"present B@eastern edge"}},
      {"Houses along the road and the river, well apart.", kSuburb, {"scattered B"}, {"apart R W"}},
      {"A pond in the north west corner of the field.", kSuburb, {"within W A"}},
      {"No houses but a lake in the south.", kSuburb, {"absent B", "present W@southern third"}},
      {"A road from the village in the south to the edge.", kSuburb, {"present B@southern third"}},
      {"The trees are green.", kSuburb, {"present F"}, {"present G"}},
      {"Two lakes: one in one corner, the other one in the middle.",
       kSuburb,
       {"present W@center"},
       {"present W@south-east corner"}},
      {"One house on each side of the map.", kSuburb, {"present B@western edge"}, {"count B 2..2"}},
  };
}

class PlainUsesTest : public testing::TestWithParam<Sample> {};
TEST_P(PlainUsesTest, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainUsesTest, ReadsCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Labels, PlainUsesTest, testing::ValuesIn(Labels()));
INSTANTIATE_TEST_SUITE_P(Uses, PlainUsesTest, testing::ValuesIn(Uses()));
INSTANTIATE_TEST_SUITE_P(Measures, PlainUsesTest, testing::ValuesIn(Measures()));
INSTANTIATE_TEST_SUITE_P(Pairs, PlainUsesTest, testing::ValuesIn(Pairs()));
INSTANTIATE_TEST_SUITE_P(Others, PlainUsesTest, testing::ValuesIn(Others()));
INSTANTIATE_TEST_SUITE_P(Rests, PlainUsesTest, testing::ValuesIn(Rests()));
INSTANTIATE_TEST_SUITE_P(Journeys, PlainUsesTest, testing::ValuesIn(Journeys()));
INSTANTIATE_TEST_SUITE_P(Divisions, PlainUsesTest, testing::ValuesIn(Divisions()));

}  // namespace
}  // namespace latticeworld
