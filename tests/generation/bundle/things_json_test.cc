#include "latticeworld/generation/bundle/things_json.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

auto Parse(const std::string& json) {
  return ParseThings(json, *Catalogue::BuiltIn(), Vocabulary::kSuburb);
}

TEST(ThingsJsonTest, PosesArrangementsAndRelationsAreRead) {
  const auto things = Parse(
      R"([{"kind": "bench", "name": "b1", "x": 3, "y": -8, "yaw_deg": 90},
          {"kind": "tree", "count": 3, "arrangement": "row", "spacing_m": 8, "relation": "near",
           "of": "village", "place": "upper left"},
          {"kind": "lamp", "relation": "around", "of": "b1"},
          {"kind": "well", "relation": "near", "of": "b1", "side": "north-west"},
          {"kind": "tent", "relation": "between", "of": "b1", "and": "forest"}])");
  ASSERT_TRUE(things.ok()) << things.status().ToString();
  ASSERT_EQ(things->size(), 5u);
  EXPECT_EQ((*things)[0].position->y_m, -8.0);
  EXPECT_EQ((*things)[1].target.letter, 'B');
  EXPECT_EQ((*things)[2].target.wish, 0);
  EXPECT_EQ((*things)[3].side, ThingSide::kNorthWest);
  EXPECT_EQ((*things)[4].second.letter, 'F');
  EXPECT_TRUE(Parse("")->empty());
}

TEST(ThingsJsonTest, EveryFaultIsNamedAtOnce) {
  const auto things = Parse(
      R"([{"kind": "bensh", "colour": 1}, {"kind": "tree", "count": 10000, "x": 1},
          {"kind": "well", "relation": "near"},
          {"kind": "well", "relation": "in", "of": "forest", "side": "up", "and": "water"},
          {"kind": "well", "relation": "around", "of": "forest", "side": "north"},
          {"kind": "well", "relation": "between", "of": "forest"}])");
  ASSERT_FALSE(things.ok());
  const std::string text = things.status().ToString();
  for (const char* part : {"things/0/kind", "nearest is bench", "things/0/colour", "things/1/count",
                           "things/1/y", "things/2/of", "things/3/side: is \"up\"; legal are any",
                           "things/3/and", "things/4/side", "things/5/and: is missing"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(ThingsJsonTest, WhatIsNoJsonOrNoArrayIsRefused) {
  for (const char* json : {"{", "{}", "7", "[1]", "[{}]", R"([{"kind": 7}])"}) {
    EXPECT_FALSE(Parse(json).ok()) << json;
  }
}

TEST(ThingsJsonTest, TheFileOfABundleIsReadBackAndDamageIsSeen) {
  const GridGeometry geometry = *GridGeometry::Create(64.0, 0.5);
  const ThingsFile file = {"[]", {{"well_1", "well", 0, 3, {1.5, -2.0}, 0.25}}};
  const auto read = DecodeThings(EncodeThings(file), geometry, 10);
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  EXPECT_EQ(read->request, "[]");
  ASSERT_EQ(read->things.size(), 1u);
  EXPECT_EQ(read->things[0].name, "well_1");
  EXPECT_EQ(read->things[0].asset, 3);
  EXPECT_EQ(read->things[0].position.x_m, 1.5);
  EXPECT_FALSE(DecodeThings(EncodeThings(file), geometry, 2).ok());
  ThingsFile twice = file;
  twice.things.push_back(file.things[0]);
  EXPECT_FALSE(DecodeThings(EncodeThings(twice), geometry, 10).ok());
  ThingsFile turned = file;
  turned.things[0].yaw_rad = 1e300;
  EXPECT_FALSE(DecodeThings(EncodeThings(turned), geometry, 10).ok());
}

}  // namespace
}  // namespace latticeworld
