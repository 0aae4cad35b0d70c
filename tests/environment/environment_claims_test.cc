#include "latticeworld/environment/environment_claims.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "latticeworld/environment/environment_claims_json.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

EnvironmentConfig Winter() {
  EnvironmentConfig config;
  config.coarse.season = Season::kWinter;
  config.coarse.weather = Weather::kSnow;
  config.fine = DeriveFineAttributes(config.coarse);
  config.agents = {{AgentCategory::kSheep, 4, AgentState::kIdle, Region::kUpperLeft},
                   {AgentCategory::kSheep, 5, AgentState::kGrazing, Region::kLower},
                   {AgentCategory::kGoblin, 2, AgentState::kAttacking, Region::kCenter}};
  return config;
}

EnvironmentClaim Parsed(const std::string& json) {
  const auto claims = ParseEnvironmentClaims("[" + json + "]");
  EXPECT_TRUE(claims.ok()) << claims.status().ToString();
  return claims.ok() ? claims->front() : EnvironmentClaim();
}

EnvironmentClaimMeasure MeasureOf(const std::string& json) {
  const EnvironmentClaimMeasure measure = Measure(Parsed(json), Winter());
  EXPECT_EQ(measure.holds, measure.distance == 0.0) << json;
  EXPECT_LE(measure.distance, 1.0) << json;
  EXPECT_FALSE(measure.explanation.empty()) << json;
  return measure;
}

TEST(EnvironmentClaimsTest, HoldsWhereTheConfigurationSaysSo) {
  for (
      const std::string json : {
          R"({"kind": "coarse", "attribute": "season", "values": ["autumn", "winter"]})",
          R"({"kind": "variant", "asset": "lake", "key": "season_variant", "values": ["frozen"]})",
          R"({"kind": "density", "asset": "grass", "most": 0.3})",
          R"({"kind": "parameter", "asset": "architecture", "key": "scale", "least": 1, "most": 1})",
          R"({"kind": "parameter", "asset": "crops", "key": "rotation_yaw", "least": 350, "most": 10})",
          R"({"kind": "agents", "category": "sheep", "least_quantity": 9, "most_quantity": 9})",
          R"({"kind": "agents", "category": "sheep", "least_quantity": 5, "most_quantity": 5})",
          R"({"kind": "agents", "category": "sheep", "least_quantity": 4, "states": ["idle"],
               "positions": ["upper left", "upper"]})",
          R"({"kind": "agents", "category": ["goblin", "horse"], "most_quantity": 2})",
          R"({"kind": "no_agents", "category": "whale"})",
          R"({"kind": "total_agents", "least_quantity": 11, "most_quantity": 11})",
      }) {
    EXPECT_TRUE(MeasureOf(json).holds) << json;
  }
}

TEST(EnvironmentClaimsTest, FailsWhereItSaysOtherwise) {
  for (
      const std::string json : {
          R"({"kind": "coarse", "attribute": "weather", "values": ["rain"]})",
          R"({"kind": "variant", "asset": "lake", "key": "season_variant", "values": ["open"]})",
          R"({"kind": "density", "asset": "grass", "least": 0.9})",
          R"({"kind": "parameter", "asset": "crops", "key": "rotation_yaw", "least": 10, "most": 350})",
          R"({"kind": "agents", "category": "sheep", "least_quantity": 6, "most_quantity": 8})",
          R"({"kind": "agents", "category": "sheep", "least_quantity": 5, "states": ["idle"]})",
          R"({"kind": "agents", "category": "sheep", "least_quantity": 1, "positions": ["center"]})",
          R"({"kind": "agents", "category": "horse", "least_quantity": 1})",
          R"({"kind": "no_agents", "category": "goblin"})",
          R"({"kind": "no_agents", "category": ""})",
          R"({"kind": "total_agents", "most_quantity": 10})",
      }) {
    EXPECT_FALSE(MeasureOf(json).holds) << json;
  }
}

TEST(EnvironmentClaimsTest, DistanceGrowsWithHowWrongItIs) {
  const auto distance = [](const std::string& tail) {
    return MeasureOf(R"({"kind": "agents", "category": "sheep", )" + tail + "}").distance;
  };
  EXPECT_LT(distance(R"("least_quantity": 10)"), distance(R"("least_quantity": 30)"));
  EXPECT_LT(distance(R"("least_quantity": 5, "states": ["idle"])"),
            distance(R"("least_quantity": 5, "states": ["flying"], "positions": ["center"])"));
  EXPECT_EQ(MeasureOf(R"({"kind": "agents", "category": "whale", "least_quantity": 1})").distance,
            1.0);
  EXPECT_LT(MeasureOf(R"({"kind": "density", "asset": "grass", "least": 0.3})").distance,
            MeasureOf(R"({"kind": "density", "asset": "grass", "least": 0.9})").distance);
}

TEST(EnvironmentClaimsTest, ExplainsWhatIsAndWhatIsAsked) {
  EXPECT_EQ(MeasureOf(R"({"kind": "coarse", "attribute": "weather", "values": ["sunny", "fog"]})")
                .explanation,
            "weather is snow; sunny or fog is asked");
  EXPECT_EQ(MeasureOf(R"({"kind": "agents", "category": "goblin", "least_quantity": 3,
                          "most_quantity": 3})")
                .explanation,
            "2 goblin; 3 are asked");
}

template <typename Enum>
Json NamesOf(const std::vector<Enum>& values) {
  Json names = Json::array();
  for (const Enum value : values) names.push_back(NameOf(value));
  return names;
}

Json CategoryJson(const std::vector<AgentCategory>& categories) {
  if (categories.empty()) return "";
  if (categories.size() == 1) return NameOf(categories.front());
  return NamesOf(categories);
}

// One line, every key that counts written out.
std::string ToJson(const EnvironmentClaim& claim) {
  Json json;
  json["kind"] = NameOf(claim.kind);
  switch (claim.kind) {
    case EnvironmentClaimKind::kCoarse:
      json["attribute"] = NameOf(claim.coarse_key);
      json["values"] = claim.values;
      break;
    case EnvironmentClaimKind::kDensity:
      json["asset"] = NameOf(claim.asset);
      json["least"] = claim.least;
      json["most"] = claim.most;
      break;
    case EnvironmentClaimKind::kVariant:
      json["asset"] = NameOf(claim.asset);
      json["key"] = NameOf(claim.variant_key);
      json["values"] = claim.values;
      break;
    case EnvironmentClaimKind::kParameter:
      json["asset"] = NameOf(claim.asset);
      json["key"] = NameOf(claim.parameter_key);
      json["least"] = claim.least;
      json["most"] = claim.most;
      break;
    case EnvironmentClaimKind::kAgents:
      json["category"] = CategoryJson(claim.categories);
      json["least_quantity"] = claim.least_quantity;
      json["most_quantity"] = claim.most_quantity;
      json["states"] = NamesOf(claim.states);
      json["positions"] = NamesOf(claim.positions);
      break;
    case EnvironmentClaimKind::kNoAgents:
      json["category"] = CategoryJson(claim.categories);
      break;
    case EnvironmentClaimKind::kTotalAgents:
      json["least_quantity"] = claim.least_quantity;
      json["most_quantity"] = claim.most_quantity;
      break;
  }
  json["words"] = claim.words;
  return json.dump();
}

TEST(EnvironmentClaimsTest, JsonComesBackAsItWent) {
  const std::string json =
      R"({"kind":"agents","category":["goblin","sheep"],"least_quantity":2,"most_quantity":7,)"
      R"("states":["idle"],"positions":["lower left","anywhere"],"words":"two \"or\" more"})";
  EXPECT_EQ(ToJson(Parsed(json)), json);
  for (
      const std::string one : {
          R"({"kind":"coarse","attribute":"season","values":["spring"],"words":""})",
          R"({"kind":"density","asset":"road","least":0.25,"most":1.0,"words":"x"})",
          R"({"kind":"variant","asset":"road","key":"material","values":["gravel"],"words":""})",
          R"({"kind":"parameter","asset":"lake","key":"height_m","least":-1.0,"most":1.0,"words":""})",
          R"({"kind":"no_agents","category":"","words":""})",
          R"({"kind":"total_agents","least_quantity":0,"most_quantity":3,"words":""})",
      }) {
    EXPECT_EQ(ToJson(Parsed(one)), one);
  }
}

struct Refusal {
  std::string json;
  std::string pointer;
  std::string code;
};

TEST(EnvironmentClaimsTest, EveryViolationNamesItsKey) {
  for (const Refusal& refusal : std::vector<Refusal>{
           {"[]", "/0", "wrong_type"},
           {"{", "", "parse_error"},
           {R"({"kind": "wish"})", "/0/kind", "unknown_value"},
           {R"({"kind": "coarse", "attribute": "season", "values": ["fog"]})", "/0/values/0",
            "unknown_value"},
           {R"({"kind": "coarse", "attribute": "season", "values": []})", "/0/values",
            "missing_value"},
           {R"({"kind": "coarse", "attribute": "season", "value": ["fog"]})", "/0/values",
            "missing_key"},
           {R"({"kind": "density", "asset": "grass"})", "/0/least", "missing_key"},
           {R"({"kind": "density", "asset": "grass", "least": 2})", "/0/least", "out_of_range"},
           {R"({"kind": "density", "asset": "grass", "least": 0.5, "most": 0.4})", "/0/most",
            "out_of_range"},
           {R"({"kind": "parameter", "asset": "grass", "key": "scale", "least": 1})", "/0/key",
            "unknown_value"},
           {R"({"kind": "agents", "category": "", "least_quantity": 1})", "/0/category",
            "missing_key"},
           {R"({"kind": "agents", "category": "cow", "least_quantity": 1})", "/0/category",
            "unknown_value"},
           {R"({"kind": "agents", "category": "sheep", "least_quantity": 0})", "/0/least_quantity",
            "out_of_range"},
           {R"({"kind": "agents", "category": "sheep", "least_quantity": 1.5})",
            "/0/least_quantity", "wrong_type"},
           {R"({"kind": "agents", "category": "sheep", "least_quantity": 1, "states": "idle"})",
            "/0/states", "wrong_type"},
           {R"({"kind": "no_agents", "category": "sheep", "words": 3})", "/0/words", "wrong_type"},
       }) {
    const auto claims = ParseEnvironmentClaims("[" + refusal.json + "]");
    ASSERT_FALSE(claims.ok()) << refusal.json;
    ASSERT_FALSE(claims.status().violations().empty()) << refusal.json;
    EXPECT_EQ(claims.status().violations().front().pointer, refusal.pointer) << refusal.json;
    EXPECT_EQ(claims.status().violations().front().code, refusal.code) << refusal.json;
  }
}

TEST(EnvironmentClaimsTest, PointersIntoAnArrayBeginWithTheIndex) {
  const auto claims = ParseEnvironmentClaims(
      R"([{"kind": "no_agents", "category": "sheep"}, {"kind": "no_agents"}, 5])");
  ASSERT_FALSE(claims.ok());
  ASSERT_EQ(claims.status().violations().size(), 2u);
  EXPECT_EQ(claims.status().violations()[0].pointer, "/1/category");
  EXPECT_EQ(claims.status().violations()[1].pointer, "/2");
}

// Once telling what was given took more stack than there is.
TEST(EnvironmentClaimsTest, WhatIsNestedTooDeepIsRefused) {
  const std::string deep = std::string(1000, '[') + std::string(1000, ']');
  for (const std::string& json :
       {deep, R"([{"kind": "no_agents", "category": )" + deep + "}]",
        R"([{"kind": "no_agents", "category": "", "x": )" + deep + "}]"}) {
    const auto claims = ParseEnvironmentClaims(json);
    ASSERT_FALSE(claims.ok());
    EXPECT_EQ(claims.status().violations().front().code, "too_deep");
  }
}

}  // namespace
}  // namespace latticeworld
