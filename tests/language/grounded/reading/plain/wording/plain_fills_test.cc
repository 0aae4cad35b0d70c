#include <gtest/gtest.h>

#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/layout/vocabulary.h"

// What fills places, how far what is said reaches, and what follows one upon another.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Fills() {
  return {
      {"Fill the northern third with buildings and the southern third with crops.",
       kSuburb,
       {"dominant B@northern third", "dominant A@southern third"},
       {"present B@southern third", "present A@northern third"}},
      {"Cover the left half with forest, the right half with grass.",
       kSuburb,
       {"dominant F@western half", "dominant G@eastern half"},
       {"present F@eastern half"}},
      {"Put sand in the middle. Circle it with grassland.", kSuburb, {"surrounds G D"}},
      {"Lawns flank the stream.", kSuburb, {"both_sides G W"}},
      {"Two small woods flank the village on the left and on the right.",
       kSuburb,
       {"both_sides F B", "count F 2..2"},
       {"present B@western third"}},
      {"A forest, with a clearing of bare earth in the east.",
       kSuburb,
       {"present D@eastern third"},
       {"present G"}},
      {"Lots of trees but one big hole in the middle with sand.",
       kSuburb,
       {"present D@center"},
       {"present F@center"}},
      {"Forest with a hole in the middle.", kSuburb, {"present G@center"}},
      {"A cluster of huts in the centre, and a water hole in the east.",
       kSuburb,
       {"present B@center"}},
      {"Snow at the top, then scree, then meadow, and at the very bottom a valley with a river.",
       kWild,
       {"present W@southern quarter"},
       {"present B@southern quarter"}},
  };
}

std::vector<Sample> Scopes() {
  return {
      {"The far north is woods and there is no water anywhere.",
       kSuburb,
       {"dominant F@northern quarter", "absent W"},
       {"absent W@northern quarter"}},
      {"More sand than grass, more grass than water, and the water only in the northwest.",
       kSuburb,
       {"more_than D G", "more_than G W", "located W@upper left"},
       {"located D@upper left", "located G@upper left"}},
      {"Four villages joined by roads that meet in the center.",
       kSuburb,
       {"count B 4..4", "connects R B B", "present R@center"},
       {"present B@center"}},
      {"Two small islands with trees, and no people live there.", kSuburb, {"absent B"}},
      {"Grass and a pond. Nobody lives here.", kSuburb, {"absent B", "present W"}},
      {"A lake on the left as we walked north, a wall of trees on the right, and nothing but grass "
       "under our boots in between.",
       kSuburb,
       {"present W@western third", "between G W F"},
       {"present W@northern third", "dominant G"}},
      {"The town is bordered by a river on its north side and by farmland on every other side.",
       kSuburb,
       {"direction W B N", "surrounds A B"},
       {"adjacent A W"}},
      {"Grassland around a desert. A town touches the desert on its southern side.",
       kSuburb,
       {"direction B D S"},
       {"direction B G S"}},
      {"A town has the lake on its southern side.", kSuburb, {"direction W B S"}},
      {"A desert in the middle with grass around it. A road runs along its northern side.",
       kSuburb,
       {"surrounds G D", "direction R D N"},
       {"direction R G N"}},
      {"On the north side of the river are houses, on the other orchards.",
       kSuburb,
       {"direction B W N", "direction A W S"}},
      {"There is one river. Left side of the river is forest, right side is only field.",
       kSuburb,
       {"direction F W W", "direction A W E"}},
      {"Forest on three sides of a meadow, and a lake on the fourth.",
       kSuburb,
       {"present W"},
       {"amount W"}},
      {"A meadow enclosed on three sides by forest, open to the south.",
       kSuburb,
       {"adjacent F G"},
       {"surrounds G F"}},
      {"A lake at the heart of the realm.", kSuburb, {"present W@center"}, {"present F"}},
  };
}

std::vector<Sample> Chains() {
  return {
      {"Around the lake is sand, after the sand is forest.",
       kSuburb,
       {"surrounds D W", "surrounds F D"}},
      {"Around the lake is sand, then forest, and then fields.",
       kSuburb,
       {"surrounds D W", "surrounds F D", "surrounds A F"}},
      {"The pond lies enclosed by an orchard, and the orchard in turn by a ring of trees.",
       kSuburb,
       {"surrounds A W", "surrounds F A"}},
      {"First comes snow at the top, second comes rock, third comes forest and last comes a pond "
       "at "
       "the bottom.",
       kWild,
       {"present S@northern third", "present W@southern third", "order SRF>S"},
       {"amount F", "present R@southern third"}},
      {"A road goes from the pond in the south until it reaches a small town at the top edge.",
       kSuburb,
       {"connects R W B", "present B@northern edge"}},
      {"Two parallel roads run north and south.",
       kSuburb,
       {"course R northern edge>southern edge", "count R 2..2"},
       {"present R@northern edge"}},
      {"A lake in the corner down left.",
       kSuburb,
       {"present W@south-west corner"},
       {"present W@western third"}},
      {"Apples grow in the east and wheat in the west.",
       kSuburb,
       {"present A@eastern third", "present A@western third"}},
  };
}

class PlainFillsTest : public testing::TestWithParam<Sample> {};

TEST_P(PlainFillsTest, AreRead) {
  ExpectRead(GetParam());
  ExpectReadInCapitals(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Fills, PlainFillsTest, testing::ValuesIn(Fills()));
INSTANTIATE_TEST_SUITE_P(Scopes, PlainFillsTest, testing::ValuesIn(Scopes()));
INSTANTIATE_TEST_SUITE_P(Chains, PlainFillsTest, testing::ValuesIn(Chains()));

}  // namespace
}  // namespace latticeworld
