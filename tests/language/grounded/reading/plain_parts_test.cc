#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "language/grounded/reading/reading_sample.h"
#include "latticeworld/language/grounded/reading/band_words.h"
#include "latticeworld/language/grounded/reading/slants.h"
#include "latticeworld/layout/layout_mask.h"
#include "latticeworld/layout/vocabulary.h"

// Parts of the map that words number, cut off by a line or leave over; parts of a count.
namespace latticeworld {
namespace {

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Stripes() {
  return {
      {"Band one, counted from the top, is lake. Band two is forest. Band three is town.",
       kSuburb,
       {"dominant W@northern third", "dominant F@middle rows", "dominant B@southern third"}},
      {"Four strips side by side. The first is wood, the second water, the third fields, the last "
       "houses.",
       kSuburb,
       {"dominant F@western quarter", "dominant W@band 2 of 4", "dominant A@band 3 of 4",
        "dominant B@eastern quarter"},
       {"amount A"}},
      {"First stripe from the right: meadow. Second: wood. Third: fields.",
       kSuburb,
       {"dominant G@eastern third", "dominant F@middle columns", "dominant A@western third"}},
      {"Five equal rows. Number one is lake, number two is grass, three is forest, four is fields, "
       "five is town.",
       kSuburb,
       {"amount W", "amount A", "dominant W@band 1 of 5", "dominant B@band 5 of 5"}},
      {"The map is cut into three horizontal bands. The top one is forest, the middle one is "
       "fields, the bottom one is water.",
       kSuburb,
       {"dominant F@northern third", "dominant A@middle rows", "dominant W@southern third"}},
      {"Divide the map into four columns: snow, rock, grass and forest.",
       kWild,
       {"dominant S@western quarter", "dominant F@eastern quarter"}},
      {"The northern quarter: forest; the next quarter: fields; the third quarter: meadow; the "
       "southern quarter: a lake.",
       kSuburb,
       {"dominant F@northern quarter", "dominant A@band 2 of 4", "dominant G@band 3 of 4",
        "present W@southern quarter"}},
      {"From left to right: houses, fields, wood. Equal widths.",
       kSuburb,
       {"amount B", "amount A", "amount F", "dominant F@eastern third"}},
      {"Left column woods, middle column a river, right column houses.",
       kSuburb,
       {"dominant F@western third",
        "course W middle columns, its one end>middle columns, its other end"}},
      {"Stacked in horizontal bands: houses at the top, fields in the middle, water at the bottom.",
       kSuburb,
       {"dominant B@northern third", "dominant A@middle rows", "dominant W@southern third"}},
      {"The land drops in three steps towards the south-east corner: snow, rock, forest.",
       kWild,
       {"order SRF>SE"}},
      // These number no stripes.
      {"The upper part is snow, the lower part water, and the part between is woods.",
       kWild,
       {"between F S W"},
       {"dominant S@northern half"}},
      {"Two ponds. The first is round, the second long.", kSuburb, {"count W 2..2"}},
      {"The first part of the road is straight, and a third of the map is forest.",
       kSuburb,
       {"amount F"},
       {"present F@western half"}},
  };
}

std::vector<Sample> Corners() {
  return {
      {"Of the four corners three are fields; the other one, the north-western, is a lake.",
       kSuburb,
       {"present A@south-east corner", "present A@north-east corner", "present A@south-west corner",
        "present W@north-west corner"},
       {"present A@north-west corner"}},
      {"Three corners are woods. In the fourth there is a village.",
       kSuburb,
       {"present F@north-west corner", "present B@south-east corner"},
       {"amount F"}},
      {"Three of the four edges are wooded, the fourth, the northern one, is water.",
       kSuburb,
       {"present F@western edge", "present F@southern edge", "present W@northern edge"}},
      {"A lake touches the west, north and east edges. The remaining edge is fields.",
       kSuburb,
       {"present W@northern edge", "present A@southern edge"},
       {"rest A"}},
      {"Trees in the top left corner and in the bottom right corner, a wall of rock from the other "
       "corner to the other corner.",
       kWild,
       {"course R north-east corner>south-west corner"}},
      {"The lake is in one corner, the top right; the village in the opposite corner.",
       kSuburb,
       {"present W@north-east corner", "present B@south-west corner"},
       {"present W@corners"}},
      {"A wood in each corner except the north-eastern, which is a pond.",
       kSuburb,
       {"present F@north-west corner", "present F@south-east corner",
        "present W@north-east corner"},
       {"present F@north-east corner"}},
      {"Water along every edge except the northern.",
       kSuburb,
       {"present W@western edge", "present W@southern edge"},
       {"present W@northern edge"}},
      {"A village in the south-west corner and a lake in the corner diagonally opposite.",
       kSuburb,
       {"present W@north-east corner"},
       {"present W@north-west corner"}},
  };
}

std::vector<Sample> Slants() {
  return {
      {"Everything below a line from the lower left corner to the upper right corner is forest, "
       "the "
       "rest is grass.",
       kSuburb,
       {"dominant F@south-east of a line", "rest G"},
       {"dominant G@upper right"}},
      {"North-east of a line from the upper left to the lower right corner snow, south-west of it "
       "rock.",
       kWild,
       {"dominant S@north-east of a line", "dominant R@south-west of a line"}},
      {"The diagonal from the top right corner to the bottom left corner divides the map: forest "
       "above it, fields below it.",
       kSuburb,
       {"dominant F@north-west of a line", "dominant A@south-east of a line"}},
      {"Half forest, half fields, cut along the diagonal: the north-east belongs to the forest, "
       "the "
       "south-west to the fields.",
       kSuburb,
       {"present F@north-east of a line", "present A@south-west of a line", "amount F"}},
      {"Below a line from the middle of the left edge to the top right corner it is all fields.",
       kSuburb,
       {"dominant A@south-east of a line"}},
  };
}

std::vector<Sample> Portions() {
  return {
      {"There are four ponds: three are in the north, the fourth in the south.",
       kSuburb,
       {"count W 4..4", "count W 3..3@northern third", "count W 1..1@southern third"},
       {"amount W"}},
      {"Three hamlets. The first two lie west of the river, the third east of it.",
       kSuburb,
       {"count B 3..3", "direction B W W", "direction B W E"}},
      {"Five huts. Two stand in the north, another two in the south, the last one in the middle.",
       kSuburb,
       {"count B 5..5", "present B@northern third", "present B@southern third",
        "present B@center"}},
      {"Seven ponds, the first four of them in the wood, the rest in the meadow.",
       kSuburb,
       {"count W 7..7", "within W F", "within W G"}},
      {"Houses: ten. Ponds: two, one north and one south.",
       kSuburb,
       {"count B 10..10", "count W 1..1@northern third", "count W 1..1@southern third"}},
      {"Ten houses in the west, five more in the east.",
       kSuburb,
       {"count B 15..15", "count B 5..5@eastern third"},
       {"count B 5..5"}},
      {"The settlement consists of three clusters, two in the west, the third in the east.",
       kSuburb,
       {"count B 3..3", "count B 2..2@western third", "count B 1..1@eastern third"}},
  };
}

class PlainParts : public testing::TestWithParam<Sample> {};

TEST_P(PlainParts, ReadsTheClaims) { ExpectRead(GetParam()); }
TEST_P(PlainParts, ReadsTheSameInCapitals) { ExpectReadInCapitals(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Stripes, PlainParts, testing::ValuesIn(Stripes()));
INSTANTIATE_TEST_SUITE_P(Corners, PlainParts, testing::ValuesIn(Corners()));
INSTANTIATE_TEST_SUITE_P(Slants, PlainParts, testing::ValuesIn(Slants()));
INSTANTIATE_TEST_SUITE_P(Portions, PlainParts, testing::ValuesIn(Portions()));

TEST(BandWordsTest, NameEveryBand) {
  for (const Heading way : {Heading{1, 0}, Heading{-1, 0}, Heading{0, 1}, Heading{0, -1}}) {
    for (int of = 2; of <= Band::kMost; ++of) {
      LayoutMask all;
      for (int nth = 1; nth <= of; ++nth) {
        const Band band{nth, of, way};
        const std::optional<Band> read = BandNamed(WordOf(band));
        ASSERT_TRUE(read.has_value()) << WordOf(band);
        EXPECT_EQ(WordOf(*read), WordOf(band));
        const LayoutMask mask = MaskOf(ZoneOfBand(band));
        EXPECT_TRUE((mask & all).empty()) << WordOf(band) << " overlaps one before it";
        all = all | mask;
      }
      EXPECT_EQ(all.count(), kLayoutSize * kLayoutSize);
    }
  }
  for (const char* word : {"band", "band#", "band#1", "band#0/3e", "band#4/3e", "band#1/99e"}) {
    EXPECT_FALSE(BandNamed(word).has_value()) << word;
  }
}

TEST(SlantsTest, PartTheMapInTwo) {
  const RimPoint west{0, 1};
  const RimPoint north_east{2, 0};
  const std::optional<Slant> above = SlantToward(west, north_east, {0, -1});
  const std::optional<Slant> below = SlantToward(west, north_east, {0, 1});
  ASSERT_TRUE(above.has_value());
  ASSERT_TRUE(below.has_value());
  const LayoutMask high = MaskOf(ZoneOfSlant(*above));
  const LayoutMask low = MaskOf(ZoneOfSlant(*below));
  EXPECT_TRUE((high & low).empty());
  EXPECT_EQ(high.count() + low.count(), kLayoutSize * kLayoutSize);
  EXPECT_TRUE(high.Contains({0, 0}));
  EXPECT_TRUE(low.Contains({kLayoutSize - 1, kLayoutSize - 1}));
  // The side keeps its name, whichever end of the line comes first.
  const std::optional<Slant> turned = SlantToward(north_east, west, {0, -1});
  ASSERT_TRUE(turned.has_value());
  EXPECT_TRUE((MaskOf(ZoneOfSlant(*turned)) - high).empty());
  const std::optional<Slant> read = SlantNamed(WordOf(*above));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(WordOf(*read), WordOf(*above));
}

TEST(SlantsTest, NameNoSideAlongTheLine) {
  EXPECT_FALSE(SlantToward({0, 0}, {2, 2}, {1, 1}).has_value());
  for (const char* word : {"slant", "slant#", "slant#0022", "slant#0093+", "slant#00222+"}) {
    EXPECT_FALSE(SlantNamed(word).has_value()) << word;
  }
}

}  // namespace
}  // namespace latticeworld
