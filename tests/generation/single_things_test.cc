// Every kind, arrangement and relation of single things, said in three ways: in free words, in the
// small language and as JSON.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/generation/bundle/things_json.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/scene/props/thing_claims.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

// A village in the west, a road from north to south, a lake in the east, a stream in the far west
// and a hill in the south.
std::shared_ptr<const Terrain> MakeLand() {
  const auto is_lake = [](WorldPoint p) { return std::hypot(p.x_m - 80.0, p.y_m - 30.0) < 25.0; };
  const auto is_stream = [](WorldPoint p) { return std::abs(p.x_m + 112.0) < 3.0; };
  TestGround ground;
  ground.letter_at = [=](WorldPoint point) {
    if (is_lake(point) || is_stream(point)) return 'W';
    if (point.x_m < -70.0 && point.x_m > -100.0) return 'B';
    return std::abs(point.x_m - 20.0) < 3.0 ? 'R' : 'G';
  };
  ground.height_at_m = [=](WorldPoint point) {
    if (is_lake(point) || is_stream(point)) return -1.0;
    return 0.5 + 8.0 * std::exp(-(std::pow(point.x_m + 20.0, 2) + std::pow(point.y_m + 70.0, 2)) /
                                (2.0 * 25.0 * 25.0));
  };
  ground.water_at_m = [=](WorldPoint point) {
    return is_lake(point) || is_stream(point) ? 0.0 : double{NAN};
  };
  return MakeTerrain(ground);
}

std::vector<ThingWish> ReadBy(InstructionReader* reader, const std::string& text) {
  LayoutRequest request;
  request.instruction = text;
  request.vocabulary = Vocabulary::kSuburb;
  std::vector<ModelReply> replies;
  return reader->ReadLayout(request, Progress(), &replies)->plan.things;
}
std::vector<ThingWish> OfWords(const std::string& text) {
  return ReadBy(MakeRuleReader().get(), text);
}
std::vector<ThingWish> OfSentences(const std::string& text) {
  return ReadBy(MakeControlledReader().get(), text);
}
std::vector<ThingWish> OfJson(const std::string& json) {
  const auto things = ParseThings(json, *Catalogue::BuiltIn(), Vocabulary::kSuburb);
  EXPECT_TRUE(things.ok()) << things.status().ToString();
  return things.ok() ? *things : std::vector<ThingWish>();
}

void ExpectAlike(const std::vector<ThingWish>& wishes, const std::vector<ThingWish>& others) {
  ASSERT_EQ(wishes.size(), others.size());
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const ThingWish &a = wishes[i], &b = others[i];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.count, b.count) << a.kind;
    EXPECT_EQ(a.arrangement, b.arrangement) << a.kind;
    EXPECT_EQ(a.spacing_m, b.spacing_m) << a.kind;
    EXPECT_EQ(a.size, b.size) << a.kind;
    EXPECT_EQ(a.relation, b.relation) << a.kind;
    EXPECT_EQ(a.target.letter, b.target.letter) << a.kind;
    EXPECT_EQ(a.target.wish, b.target.wish) << a.kind;
    EXPECT_EQ(a.distance_m, b.distance_m) << a.kind;
    EXPECT_EQ(a.facing.letter, b.facing.letter) << a.kind;
    EXPECT_EQ(a.facing.wish, b.facing.wish) << a.kind;
    EXPECT_EQ(a.heading_rad.has_value(), b.heading_rad.has_value()) << a.kind;
    EXPECT_NEAR(a.heading_rad.value_or(0.0), b.heading_rad.value_or(0.0), 1e-6) << a.kind;
  }
}

void ExpectToStand(const std::shared_ptr<const Terrain>& land,
                   const std::vector<ThingWish>& wishes) {
  SceneRequest request = MakeRequest(land, MakeEnvironment(0.02), /*seed=*/5);
  request.things = wishes;
  const auto answer = BuildScene(request, Progress());
  ASSERT_TRUE(answer.ok()) << answer.status().ToString();
  for (const ThingOutcome& outcome : MeasureThings(*answer->scene, wishes)) {
    EXPECT_TRUE(outcome.holds) << outcome.kind << ": " << outcome.explanation;
  }
}

TEST(SingleThingsTest, EveryKindStandsAndIsReadInWordsInTheSmallLanguageAndAsJson) {
  const auto land = MakeLand();
  for (const ThingKind& kind : AllThingKinds()) {
    SCOPED_TRACE(kind.name);
    std::vector<ThingWish> wishes = OfJson(R"([{"kind": ")" + kind.name + R"("}])");
    // A house and a bridge in words are land.
    if (kind.name != "house" && kind.name != "footbridge") {
      const bool vowel = std::string("aeiou").find(kind.name[0]) != std::string::npos;
      ExpectAlike(OfWords("A lone " + kind.name + " in the north."), wishes);
      ExpectAlike(OfSentences((vowel ? "An " : "A ") + kind.name + " in the north."), wishes);
    }
    if (kind.name == "pier") {
      wishes[0].relation = ThingRelation::kNear;
      wishes[0].target.letter = 'W';
    }
    ExpectToStand(land, wishes);
  }
}

struct Way {
  const char* words;
  const char* sentences;
  const char* json;
};
constexpr Way kWays[] = {
    {"Three oaks in a row every 12 m beside a village.",
     "3 oaks are in a row every 12 m. The oaks are near the village.",
     R"([{"kind": "oak", "count": 3, "arrangement": "row", "spacing_m": 12, "relation": "near",
          "of": "village"}])"},
    {"Eight boulders form a ring.", "8 boulders are in a ring.",
     R"([{"kind": "boulder", "count": 8, "arrangement": "ring"}])"},
    {"A grid of nine tents.", "9 tents are in a grid.",
     R"([{"kind": "tent", "count": 9, "arrangement": "grid"}])"},
    {"Five huts in a cluster near the lake.",
     "5 huts are in a cluster. The huts are near the lake.",
     R"([{"kind": "hut", "count": 5, "arrangement": "cluster", "relation": "near",
          "of": "lake"}])"},
    {"A lone church in the west. A pair of lamps in front of the church.",
     "A church. 2 lamps are in a pair. The lamps are in front of the church.",
     R"([{"kind": "church", "name": "c"},
         {"kind": "lamp", "count": 2, "arrangement": "pair", "relation": "in front of",
          "of": "c"}])"},
    {"Six lamps along the road, 20 m apart.",
     "6 lamps are along the road. The lamps are 20 m apart.",
     R"([{"kind": "lamp", "count": 6, "relation": "along", "of": "road", "spacing_m": 20}])"},
    {"Four benches around a well.", "4 benches surround a well.",
     R"([{"kind": "well", "name": "w"},
         {"kind": "bench", "count": 4, "relation": "around", "of": "w"}])"},
    {"A bench beside the lake, facing the lake.",
     "A bench is near the lake. The bench faces the lake.",
     R"([{"kind": "bench", "relation": "near", "of": "lake", "facing": "lake"}])"},
    {"A sign in the center facing north.", "A sign in the center. The sign faces the north.",
     R"([{"kind": "sign", "yaw_deg": 90}])"},
    {"A large tent 12 m from a well.", "A large tent is 12 m from a well.",
     R"([{"kind": "well", "name": "w"},
         {"kind": "tent", "size": 1.4, "relation": "near", "of": "w", "distance_m": 12}])"},
    {"A lone tower near the hill.", "A tower is near the hill.",
     R"([{"kind": "tower", "relation": "near", "of": "hill"}])"},
    {"Three crates on the road.", "3 crates are inside the road.",
     R"([{"kind": "crate", "count": 3, "relation": "in", "of": "road"}])"},
    {"A fence along the road.", "A fence is along the road.",
     R"([{"kind": "fence", "relation": "along", "of": "road"}])"},
    {"A hedge around a well.", "A hedge surrounds a well.",
     R"([{"kind": "well", "name": "w"}, {"kind": "hedge", "relation": "around", "of": "w"}])"},
    {"Two lone birches. The birches stand near the lake.",
     "2 birches. The birches are near the lake.",
     R"([{"kind": "birch", "count": 2, "relation": "near", "of": "lake"}])"},
};

TEST(SingleThingsTest, ArrangementsAndRelationsMeanTheSameInAllThreeWaysAndTheirClaimsHold) {
  const auto land = MakeLand();
  for (const Way& way : kWays) {
    SCOPED_TRACE(way.words);
    const std::vector<ThingWish> wishes = OfJson(way.json);
    ExpectAlike(OfWords(way.words), wishes);
    ExpectAlike(OfSentences(way.sentences), wishes);
    ExpectToStand(land, wishes);
  }
}

TEST(SingleThingsTest, AChurchOnTheHillStandsOnHighGround) {
  const std::vector<ThingWish> wishes = OfWords("A lone church on the hill.");
  ASSERT_EQ(wishes.size(), 1u);
  EXPECT_EQ(wishes[0].target.letter, kHighGround);
  ExpectToStand(MakeLand(), wishes);
}

TEST(SingleThingsTest, AFenceAroundAThingHasOneWayIn) {
  const std::vector<ThingWish> wishes = OfWords("A fence around a tower.");
  SceneRequest request = MakeRequest(MakeLand(), MakeEnvironment(0.0), /*seed=*/2);
  request.things = wishes;
  const auto answer = BuildScene(request, Progress());
  ASSERT_TRUE(answer.ok());
  int pieces = 0;
  for (const SceneThing& thing : answer->scene->things) pieces += thing.kind == "fence" ? 1 : 0;
  EXPECT_GE(pieces, 3);
  EXPECT_LE(pieces, 8);
}

// What a world of those words warns of.
std::vector<std::string> WarningsOf(const std::vector<ThingWish>& wishes,
                                    const std::shared_ptr<const Terrain>& land) {
  SceneRequest request = MakeRequest(land, MakeEnvironment(0.0), /*seed=*/2);
  request.things = wishes;
  const auto answer = BuildScene(request, Progress());
  return answer.ok() ? answer->warnings : std::vector<std::string>{answer.status().ToString()};
}

// Stones and posts stand in shallow water, houses in none.
TEST(SingleThingsTest, AHouseInALakeIsToldToHaveNoGround) {
  const auto land = MakeLand();
  for (const char* kind : {"barn", "church", "house"}) {
    const std::string json =
        std::string(R"([{"kind": ")") + kind + R"(", "relation": "in", "of": "lake"}])";
    SceneRequest request = MakeRequest(land, MakeEnvironment(0.0), /*seed=*/2);
    request.things = OfJson(json);
    const SceneAnswer answer = BuildScene(request, Progress()).value();
    EXPECT_TRUE(answer.scene->things.empty()) << kind;
    ASSERT_FALSE(answer.warnings.empty()) << kind;
    EXPECT_NE(answer.warnings.front().find("0 of 1 stand: there is water"), std::string::npos)
        << answer.warnings.front();
    const auto outcomes = MeasureThings(*answer.scene, request.things);
    ASSERT_FALSE(outcomes.empty());
    EXPECT_FALSE(outcomes.front().holds);
  }
}

TEST(SingleThingsTest, WhatCannotBeIsSaidWithTheReason) {
  const auto dry = MakeUniform(Vocabulary::kSuburb, 'G', 128.0);
  struct Bad {
    std::vector<ThingWish> wishes;
    const char* reason;
  };
  const Bad bads[] = {
      {OfJson(R"([{"kind": "bridge"}])"), "no water of 3 to 12 m"},
      {OfWords("A lone pier in the north."), "there is no water"},
      {OfWords("A row of 10,000 trees."), "at most 500"},
      {OfWords("A lone tower near the hill."), "is not there"},
      {OfJson(R"([{"kind": "well", "x": 500, "y": 0}])"), "the world ends there"},
      {OfJson(R"([{"kind": "bench", "place": "upper left", "relation": "near", "of": "lake"}])"),
       "is not there"},
  };
  for (const Bad& bad : bads) {
    SCOPED_TRACE(bad.reason);
    ASSERT_FALSE(bad.wishes.empty());
    const std::vector<std::string> warnings = WarningsOf(bad.wishes, dry);
    bool said = false;
    for (const std::string& warning : warnings) {
      said = said || warning.find(bad.reason) != std::string::npos;
    }
    EXPECT_TRUE(said) << (warnings.empty() ? "no warning" : warnings.front());
  }
}

}  // namespace
}  // namespace latticeworld
