// What cannot be, asked for in words or as JSON: the world is made all the same and a warning says
// what it lacks and why, or the request is refused before anything is made.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

GenerationRequest RequestOf(const std::string& layout, double size_m = 64.0) {
  GenerationRequest request;
  request.layout_instruction = layout;
  request.seed = 3;
  request.size_m = size_m;
  request.resolution_m = 1.0;
  return request;
}

std::string WarningsOf(const std::string& layout, double size_m = 64.0) {
  const auto world =
      MakeDefaultWorldGenerator().Generate(RequestOf(layout, size_m), Progress()).value();
  std::string all;
  for (const std::string& warning : world->warnings) all += warning + "\n";
  return all;
}

struct Bad {
  const char* layout;
  const char* warning;
};

TEST(BadLandWordsTest, WhatALandCannotBeIsSaidInClearWords) {
  for (const Bad& bad : std::vector<Bad>{
           {"A mountain 9,000 m high.", "9000 m +- 15 % is asked"},
           {"A mountain 9,000 m high.", "is the most that its width of"},
           {"A hill in the north. The hill is 20 m high. The hill is 120 m high.",
            "cannot both be: the later height counts"},
           {"The land is flat. The land is rugged.", "are said of the same land"},
           {"A bridge in the center. Grassland everywhere.",
            "a bridge is asked for, and there is "
            "none"},
           {"A row of 10,000 trees.", "a world holds at most 500 things"},
           {"A lighthouse in the north.", "there is no such kind of thing; the nearest is a tower"},
           {"A lone pier in the north. Grassland everywhere.", "there is no water"},
           {"A barn in the lake.", "no house stands in water"},
           {"A road of 8 degrees from the west to the east.", "climbs nothing"},
       }) {
    const std::string warnings = WarningsOf(bad.layout);
    EXPECT_NE(warnings.find(bad.warning), std::string::npos) << bad.layout << "\n" << warnings;
  }
}

TEST(BadLandWordsTest, AnObjectOfAnUnknownKindIsRefusedWithTheNearestBeforeAnythingIsMade) {
  GenerationRequest request = RequestOf("A lake in the north.");
  request.things = R"([{"kind": "lamb post"}])";
  const auto world = MakeDefaultWorldGenerator().Generate(request, Progress());
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(world.status().code(), StatusCode::kInvalidArgument);
  EXPECT_NE(world.status().ToString().find("lamp"), std::string::npos) << world.status().ToString();
}

// Two requests of one generator: what was made before is the same after one was refused.
TEST(BadLandWordsTest, AWorldThatIsThereStaysWhenTheNextIsRefused) {
  WorldGenerator generator = MakeDefaultWorldGenerator();
  const auto first = generator.Generate(RequestOf("A hill in the north."), Progress()).value();
  const std::string id = first->id;
  GenerationRequest refused = RequestOf("A hill in the north.");
  refused.things = R"([{"kind": "zorb"}])";
  EXPECT_FALSE(generator.Generate(refused, Progress()).ok());
  EXPECT_EQ(first->id, id);
  EXPECT_EQ(generator.Generate(RequestOf("A hill in the north."), Progress()).value()->id, id);
}

}  // namespace
}  // namespace latticeworld
