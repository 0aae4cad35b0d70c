#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/language/grounded/reading/layout_parser.h"
#include "latticeworld/layout/vocabulary.h"

// Constructions of English that say more than their words do one by one: what is left out, what
// points forward, what goes on.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Elided() {
  return {
      {"Orchards cover the upper half, a town the lower.",
       kSuburb,
       {"dominant A@northern half", "present B@southern half"}},
      {"A lane from the left edge to the right one.",
       kSuburb,
       {"course R western edge>eastern edge"}},
      {"Put the barn in the lower right corner, sorry, lower left.",
       kSuburb,
       {"present B@south-west corner"},
       {"present B@south-east corner"}},
      {"Scree fills the top left quarter, ice the bottom right one.",
       kWild,
       {"dominant R@north-western quarter", "present S@south-eastern quarter"}},
      {"Woods 50, heath 30, water 20.", kWild, {"amount W"}, {"count W 20..20"}},
      {"Anticlockwise from the top right: woods, a pond, houses, fields.",
       kSuburb,
       {"present F@north-east corner", "present W@north-west corner", "present B@south-west corner",
        "present A@south-east corner"}},
      {"Four quadrants: firs top left, ice top right, heath bottom left, scree bottom right.",
       kWild,
       {"dominant F@north-western quarter", "dominant R@south-eastern quarter"}},
      {"The left side is all wood, the right side all meadow.",
       kSuburb,
       {"dominant F@western third", "dominant G@eastern third"}},
      {"A quarry in the north-west corner and a barn in the opposite corner.",
       kSuburb,
       {"present B@south-east corner"}},
      {"Make the left half mirror the right half: a pond in each.",
       kSuburb,
       {"present W@western half", "present W@eastern half"}},
  };
}

std::vector<Sample> Sides() {
  return {
      {"An inn with meadows to its east and to its west.",
       kSuburb,
       {"direction G B E", "direction G B W"}},
      {"A village with fields to the north and south and a wood to the west.",
       kSuburb,
       {"direction A B N", "direction A B S", "direction F B W"}},
      {"With a lake to its south and a wood to its north, the hamlet lies in the middle.",
       kSuburb,
       {"direction W B S", "direction F B N"}},
      {"Nestled between a wood to its north and a pond to its south, our farmhouse is quiet.",
       kSuburb,
       {"between B F W", "direction F B N", "direction W B S"}},
      {"A chapel with water on three sides of it.", kSuburb, {"surrounds W B"}, {"count W 3..3"}},
      {"A barn in the middle. Cornfields to the left of it, grass to the right.",
       kSuburb,
       {"direction A B W", "direction G B E"}},
      {"A town bordered by forest on the north and by fields on the south.",
       kSuburb,
       {"direction F B N", "direction A B S"}},
      {"A stream from west to east, reeds on both sides of it, and behind the reeds on both sides "
       "rocks.",
       kWild,
       {"direction R W N", "direction R W S"}},
      {"A river from north to south with a wood on its left bank, and a lawn on the right.",
       kSuburb,
       {"direction F W W"}},
      {"No huts on the east side of the brook.", kSuburb, {"absent B@eastern edge"}},
      {"Between the southern edge and the farmhouse in the centre there are fields.",
       kSuburb,
       {"direction A B S"}},
      {"Line the northern edge with trees and put a pond in the middle.",
       kSuburb,
       {"present F@northern edge", "present W@center"},
       {"present F@center"}},
      {"An inlet cuts in from the west and ends in the middle. A port lies at the head of the "
       "inlet.",
       kSuburb,
       {"course W western edge>center", "direction B W E"}},
      {"A brook. Both banks: heath.", kWild, {"both_sides B W"}},
      {"South and west of the pond there is heath.", kSuburb, {"direction G W SW"}},
  };
}

std::vector<Sample> Chains() {
  return {
      {"In the west the sea, behind it dunes, behind the dunes a village and then woods.",
       kSuburb,
       {"direction D W E", "direction B D E"}},
      {"From the lake in the east you step onto a beach, and behind it stand cottages.",
       kSuburb,
       {"adjacent D W", "direction D W W", "direction B D W", "order WDB>W"}},
      {"Stripes from top to bottom:\n1. heath\n2. a brook\n3. woods", kWild, {"order BWF>S"}},
      {"From west to east: fields, a road, houses.", kSuburb, {"order ARB>E"}},
      {"A pond. To the left of it, in this order: lawn, houses, woods.", kSuburb, {"order WGBF>W"}},
      {"Ice in the north, then going south scree, then heath.", kWild, {"order SRB>S"}},
      {"A town in the centre with a ring of fields around it and woods beyond the fields.",
       kSuburb,
       {"surrounds A B", "surrounds F A"}},
  };
}

std::vector<Sample> Lines() {
  return {
      {"A river enters from the north. It forks: one arm leaves in the west, the other in the "
       "east.",
       kSuburb,
       {"course W northern edge>western edge", "course W northern edge>eastern edge"}},
      {"Two brooks, one from the west, the other from the east, flow together in the middle and "
       "leave through the south.",
       kWild,
       {"course W western edge>southern edge", "course W eastern edge>southern edge"}},
      {"One lane runs from west to east, and from the northern edge another comes down and ends at "
       "it.",
       kSuburb,
       {"course R western edge>eastern edge"}},
      {"A crossroads in the centre.", kSuburb, {"crosses R R"}},
      {"A brook hugging the northern edge.", kWild, {"along W@northern edge"}},
      {"A fjord cuts in from the west and ends in the middle.",
       kWild,
       {"course W western edge>center"}},
      {"Surround the village with a ring road.", kSuburb, {"shape R ring", "surrounds R B"}},
      {"Houses and a factory. Separate the two with a belt of trees.",
       kSuburb,
       {"between F B B"},
       {}},
      {"Our robot drives from a barn to a mill along a winding track.",
       kSuburb,
       {"shape R winding", "connects R B B"},
       {}},
      {"A castle with one drive leading in from the south.", kSuburb, {"adjacent R B"}},
  };
}

std::vector<Sample> Numbers() {
  return {
      {"Five ponds. All but one lie in the wood that fills the left half; the odd one out is among "
       "the fields, which fill the right half.",
       kSuburb,
       {"count W 5..5", "count W 4..4@western half", "count W 1..1@eastern half"}},
      {"Heath dotted with small ponds, eight or more.", kWild, {"count W 8.."}},
      {"The only water is one small pond.", kSuburb, {"count W 1..1"}},
      {"A track leads to the barn, and that is the only road.", kSuburb, {"count R 1..1"}},
      {"Two tarns in the upper half: one big, one small.", kWild, {"count W 2..2"}},
      {"A big lake with two islands, one of them rocky, the other wooded.",
       kWild,
       {"within R W", "within F W"}},
      {"Three islets in a lake, covered with trees.", kWild, {"within F W"}},
      {"Woods with three clearings, grassy ones.", kWild, {"count B 3..3"}},
      {"The lake is twice as large as the wood.", kSuburb, {"more_than W F"}},
  };
}

std::vector<Sample> Denials() {
  return {
      {"Heath and a tarn. Nothing wooded.", kWild, {"absent F"}},
      {"Two hamlets, neither with a road.", kSuburb, {"absent R"}},
      {"A lake in the middle. Above it there is not one tree.", kWild, {"absent F@northern third"}},
      {"A river that stops short of the southern edge.", kWild, {"absent W@southern edge"}},
      {"Fields and meadows, woodland excluded.", kSuburb, {"absent F"}},
      {"Fields; a pond is optional.", kSuburb, {}, {"present W"}},
      // A text that breaks off.
      {"A pond in the north and everything", kSuburb, {"present W@northern third"}},
      {"A church, no, forget the church. A mill in the north.",
       kSuburb,
       {"present B@northern third"}},
      {"Grass nowhere but on one lawn in the top left corner.",
       kSuburb,
       {"located G@north-west corner"}},
  };
}

class ReadingConstructions : public testing::TestWithParam<Sample> {};

TEST_P(ReadingConstructions, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(ReadingConstructions, ReadsTheSameInCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Elided, ReadingConstructions, testing::ValuesIn(Elided()));
INSTANTIATE_TEST_SUITE_P(Sides, ReadingConstructions, testing::ValuesIn(Sides()));
INSTANTIATE_TEST_SUITE_P(Chains, ReadingConstructions, testing::ValuesIn(Chains()));
INSTANTIATE_TEST_SUITE_P(Lines, ReadingConstructions, testing::ValuesIn(Lines()));
INSTANTIATE_TEST_SUITE_P(Numbers, ReadingConstructions, testing::ValuesIn(Numbers()));
INSTANTIATE_TEST_SUITE_P(Denials, ReadingConstructions, testing::ValuesIn(Denials()));

// Some of what covers a share of a place, split off from it, have no place of their own: what else
// there is of their class may lie there too, so that they are no bound of it from above.
TEST(ReadingConstructionsTest, ShareOfAPlaceIsNoUpperBoundForSomeOfItElsewhere) {
  const LayoutPlan plan = ParseLayoutInstruction(
      "Around 30 percent of the left side is grass, nine cells or more. Three of them lie by the "
      "orchard.",
      kWild);
  int amounts = 0;
  for (const Claim& claim : plan.claims) {
    if (claim.kind != ClaimKind::kAmount) continue;
    ++amounts;
    EXPECT_EQ(claim.subject, 'B');
    EXPECT_EQ(claim.most, Claim::kUnsaid) << claim.words;
  }
  EXPECT_EQ(amounts, 2);
}

}  // namespace
}  // namespace latticeworld
