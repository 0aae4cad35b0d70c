#include "latticeworld/language/places.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

// The names of the zones, with "| ..." where words are left; "none" where there is no place.
std::string Zones(std::string_view text, std::string_view preposition = "") {
  const std::vector<Token> tokens = Tokenize(text);
  const PlaceMatch match =
      preposition.empty() ? MatchPlace(tokens, 0) : MatchPlaceAfter(preposition, tokens, 0);
  if (match.tokens == 0) return "none";
  std::string names;
  for (const Place& place : match.places) names += (names.empty() ? "" : ", ") + place.zone.name;
  if (match.of_other) names += " of other";
  if (match.tokens < tokens.size()) {
    names += " | " + JoinWords(tokens, match.tokens, tokens.size());
  }
  return names;
}

TEST(PlacesTest, SidesNinthsAndCorners) {
  EXPECT_EQ(Zones("north"), "northern third");
  EXPECT_EQ(Zones("the SOUTH of the map"), "southern third");
  EXPECT_EQ(Zones("left-hand side"), "western third");
  EXPECT_EQ(Zones("the right"), "eastern third");
  EXPECT_EQ(Zones("upper left"), "upper left");
  EXPECT_EQ(Zones("top-left part of the picture"), "upper left");
  EXPECT_EQ(Zones("NW"), "upper left");
  EXPECT_EQ(Zones("south east"), "lower right");
  EXPECT_EQ(Zones("north-east corner of the map"), "north-east corner");
  EXPECT_EQ(Zones("NW-corner"), "north-west corner");
  EXPECT_EQ(Zones("the centre of the grid"), "center");
  EXPECT_EQ(Zones("the very middle"), "center");
  EXPECT_EQ(Zones("heart of the map"), "center");
  EXPECT_EQ(Zones("middle of the left side"), "middle left");
  EXPECT_EQ(Zones("north-central"), "upper");
}

TEST(PlacesTest, HalvesThirdsQuartersAndFractions) {
  EXPECT_EQ(Zones("northern half"), "northern half");
  EXPECT_EQ(Zones("the bottom third"), "southern third");
  EXPECT_EQ(Zones("the northernmost quarter"), "northern quarter");
  EXPECT_EQ(Zones("the far west"), "western quarter");
  EXPECT_EQ(Zones("the south-western quadrant"), "south-western quarter");
  EXPECT_EQ(Zones("bottom right quarter"), "south-eastern quarter");
  EXPECT_EQ(Zones("the middle third"), "middle rows");
  EXPECT_EQ(Zones("the central columns"), "middle columns");
  EXPECT_EQ(Zones("upper two thirds of the area"), "northern two thirds");
  EXPECT_EQ(Zones("lower 3/4"), "southern 3 quarters");
  EXPECT_EQ(Zones("the top 20%"), "northern 20 %");
  EXPECT_EQ(Zones("the top five rows"), "northern 5 rows");
  const Place two_thirds = MatchPlace(Tokenize("eastern two-thirds"), 0).places.front();
  EXPECT_NEAR(two_thirds.zone.boxes.front().u_min, 1.0 / 3.0, 1e-9);
  EXPECT_EQ(two_thirds.main, Region::kMiddleRight);
  const Place half = MatchPlace(Tokenize("northern half"), 0).places.front();
  EXPECT_EQ(half.regions.size(), 3u);
  EXPECT_DOUBLE_EQ(half.box.v_max, 0.5);
}

TEST(PlacesTest, EdgesBandsAndInterior) {
  EXPECT_EQ(Zones("eastern edge"), "eastern edge");
  EXPECT_EQ(Zones("the western fringe of the map"), "western edge");
  EXPECT_EQ(Zones("the edges"), "edges");
  EXPECT_EQ(Zones("the rim of the map"), "edges");
  EXPECT_EQ(Zones("the interior"), "interior");
  EXPECT_EQ(Zones("a strip along the southern edge"), "southern edge");
  EXPECT_EQ(Zones("a band across the middle"), "middle rows");
  EXPECT_EQ(Zones("a vertical band down the middle"), "middle columns");
  EXPECT_EQ(Zones("a wide band across the north"), "northern third");
  EXPECT_EQ(Zones("a northern band", ""), "none");  // an article belongs to the noun
  EXPECT_EQ(Zones("northern band"), "northern quarter");
  EXPECT_EQ(Zones("middle of the eastern edge"), "middle of the eastern edge");
}

TEST(PlacesTest, SeveralPlacesAtOnce) {
  EXPECT_EQ(Zones("all four corners"),
            "north-west corner, north-east corner, south-west corner, south-east corner");
  EXPECT_EQ(Zones("opposite corners"), "north-west corner, south-east corner");
  EXPECT_EQ(Zones("the top corners"), "north-west corner, north-east corner");
  EXPECT_EQ(Zones("both southern corners"), "south-west corner, south-east corner");
  EXPECT_EQ(Zones("a corner"), "corners");
  EXPECT_EQ(Zones("both sides"), "western third, eastern third");
  EXPECT_EQ(Zones("all four edges"), "northern edge, western edge, eastern edge, southern edge");
  EXPECT_EQ(Zones("northern and southern halves"), "northern half, southern half");
  EXPECT_EQ(Zones("the north-west and the south-east corners"),
            "north-west corner, south-east corner");
  // Two places that share no noun are two matches.
  EXPECT_EQ(Zones("the north and the south"), "northern third | and the south");
}

TEST(PlacesTest, PlacesBesideAndWithinPlaces) {
  EXPECT_EQ(Zones("just north of the centre"), "just north of the center");
  EXPECT_EQ(Zones("slightly left of the middle"), "just west of the center");
  EXPECT_EQ(Zones("the western half of the northern half"), "north-western quarter");
  EXPECT_EQ(Zones("the top of the left third"), "upper left");
  EXPECT_EQ(Zones("halfway between the centre and the northern edge"),
            "between center and northern edge");
  EXPECT_EQ(Zones("north by north-west"), Zones("NNW"));
  const Place wind = MatchPlace(Tokenize("NNW"), 0).places.front();
  EXPECT_EQ(wind.main, Region::kUpperLeft);
  EXPECT_NEAR(wind.box.u_max, 0.5, 1e-9);
  EXPECT_EQ(Zones("background"), "northern third");
  EXPECT_EQ(Zones("the foreground of the picture"), "southern third");
  EXPECT_EQ(Zones("everywhere"), "anywhere");
  EXPECT_EQ(Zones("the whole map"), "anywhere");
  EXPECT_EQ(Zones("the diagonal"), "diagonal");
  EXPECT_TRUE(MatchPlace(Tokenize("the entire northern half"), 0).whole);
}

TEST(PlacesTest, PrepositionsBendThem) {
  EXPECT_EQ(Zones("the south", "along"), "southern edge");
  EXPECT_EQ(Zones("the western side", "along"), "western edge");
  EXPECT_EQ(Zones("the middle", "across"), "middle rows");
  EXPECT_EQ(Zones("the middle", "down"), "middle columns");
  EXPECT_EQ(Zones("the northern half", "along"), "northern half");
  EXPECT_EQ(Zones("the south", "in"), "southern third");
}

TEST(PlacesTest, WordsThatAreNoPlaces) {
  EXPECT_EQ(Zones("right next to"), "none");
  EXPECT_EQ(Zones("right in the middle"), "none");
  EXPECT_EQ(Zones("left over"), "none");
  EXPECT_EQ(Zones("edge of the forest"), "none");
  EXPECT_EQ(Zones("both sides of the river"), "none");
  EXPECT_EQ(Zones("north-south"), "none");
  EXPECT_EQ(Zones("south-facing slope"), "none");
  EXPECT_EQ(Zones("north of the lake"), "northern third of other | of the lake");
  EXPECT_EQ(Zones("the heart of the forest"), "center of other | of the forest");
  // A verb.
  const std::vector<Token> verb = Tokenize("a forest borders the lake");
  EXPECT_EQ(MatchPlace(verb, 2).tokens, 0u);
  const std::vector<Token> rest = Tokenize("whatever is left");
  EXPECT_EQ(MatchPlace(rest, 2).tokens, 0u);
}

TEST(PlacesTest, NamedZonesAreThoseOfTheLayout) {
  for (const std::string_view name : ZoneNames()) {
    const Zone zone = *FindZone(name);
    if (zone.is_anywhere() || name == "interior" || name == "edges") continue;
    // "upper" and "lower" name ninths in the layout, sides in words.
    if (name == "upper" || name == "lower") continue;
    EXPECT_EQ(Zones(name), name);
  }
}

TEST(HeadingTest, ReadsSidesOfThings) {
  const auto heading = [](std::string_view text) {
    const HeadingMatch match = MatchHeading(Tokenize(text), 0);
    return std::to_string(match.tokens) + ":" + std::to_string(match.heading.east) + "," +
           std::to_string(match.heading.south);
  };
  EXPECT_EQ(heading("north of the lake"), "1:0,-1");
  EXPECT_EQ(heading("the south-western shore of the lake"), "4:-1,1");
  EXPECT_EQ(heading("left side of the road"), "2:-1,0");
  EXPECT_EQ(heading("centre of the lake"), "0:0,0");
}

TEST(AxisTest, ReadsBothEnds) {
  const auto axis = [](std::string_view text) {
    const AxisMatch match = MatchAxis(Tokenize(text), 0);
    if (match.tokens == 0) return std::string("none");
    return std::to_string(match.from.east) + "," + std::to_string(match.from.south) + " to " +
           std::to_string(match.to.east) + "," + std::to_string(match.to.south);
  };
  EXPECT_EQ(axis("N-S"), "0,-1 to 0,1");
  EXPECT_EQ(axis("east/west"), "1,0 to -1,0");
  EXPECT_EQ(axis("NE to SW"), "1,-1 to -1,1");
  EXPECT_EQ(axis("north-west to south-east"), "-1,-1 to 1,1");
  EXPECT_EQ(axis("left to right"), "-1,0 to 1,0");
  EXPECT_EQ(axis("top to the bottom"), "0,-1 to 0,1");
  EXPECT_EQ(axis("north to west"), "none");
  EXPECT_EQ(axis("north"), "none");
}

TEST(PlacesTest, HeadingsAndRegionsBelongTogether) {
  for (int index = 0; index < 9; ++index) {
    const auto region = static_cast<Region>(index);
    EXPECT_EQ(RegionOf(HeadingOf(region)), region);
    EXPECT_EQ(PlaceOf(region).zone, ZoneOf(region));
    EXPECT_EQ(PlaceOf(region).main, region);
  }
  EXPECT_TRUE(PlaceOf(Region::kAnywhere).zone.is_anywhere());
  EXPECT_EQ(ZoneOf(Heading{0, -1}).name, "northern third");
  EXPECT_EQ(RimZoneOf(Heading{0, -1}).name, "northern edge");
  EXPECT_EQ(RimZoneOf(Heading{1, 1}).name, "south-east corner");
}

}  // namespace
}  // namespace latticeworld
