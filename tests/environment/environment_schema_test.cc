#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "catalogue/larch.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

// Why `value` breaks `schema`; empty when it does not. Only the keywords that our schema uses.
std::string Breaks(const Json& schema, const Json& value, const std::string& at) {
  if (schema.contains("enum")) {
    const Json& legal = schema["enum"];
    return std::find(legal.begin(), legal.end(), value) == legal.end() ? at + ": enum" : "";
  }
  const std::string type = schema["type"];
  if (type == "object") {
    if (!value.is_object()) return at + ": object";
    for (const Json& key : schema["required"]) {
      if (!value.contains(key.get<std::string>())) return at + ": required";
    }
    for (const auto& [key, one] : value.items()) {
      if (!schema["properties"].contains(key)) return at + ": additionalProperties " + key;
      const std::string reason = Breaks(schema["properties"][key], one, at + "/" + key);
      if (!reason.empty()) return reason;
    }
    return "";
  }
  if (type == "array") {
    if (!value.is_array()) return at + ": array";
    for (const Json& one : value) {
      const std::string reason = Breaks(schema["items"], one, at + "/-");
      if (!reason.empty()) return reason;
    }
    return "";
  }
  if (type == "integer" ? !value.is_number_integer() : !value.is_number()) return at + ": " + type;
  const double number = value.get<double>();
  if (schema.contains("minimum") && number < schema["minimum"].get<double>()) return at + ": min";
  if (schema.contains("maximum") && number > schema["maximum"].get<double>()) return at + ": max";
  return "";
}

Json ExampleJson() {
  EnvironmentConfig environment;
  environment.fine = DeriveFineAttributes(environment.coarse);
  environment.agents = {{AgentCategory::kSheep, 3, AgentState::kGrazing, Region::kLower}};
  return Json::parse(ToJson(environment));
}

TEST(EnvironmentSchemaTest, WhatWeWriteObeysIt) {
  EXPECT_EQ(Breaks(Json::parse(EnvironmentSchema()), ExampleJson(), ""), "");
}

TEST(EnvironmentSchemaTest, SchemaAndParserAgreeOnEveryEnumValue) {
  const Json schema = Json::parse(EnvironmentSchema());
  const Json& coarse = schema["properties"]["coarse"]["properties"];
  for (const auto& [key, one] : coarse.items()) {
    for (const Json& legal : one["enum"]) {
      Json json = ExampleJson();
      json["coarse"][key] = legal;
      json["fine"].clear();
      // Without fine attributes parsing fails, but never because of this value.
      const Status status = ParseEnvironment(json.dump()).status();
      for (const Violation& violation : status.violations()) {
        ASSERT_EQ(violation.code, "missing_key") << violation.message;
      }
    }
  }
}

TEST(EnvironmentSchemaTest, NamesTheRulesThatItCannotSay) {
  const std::string description = Json::parse(EnvironmentSchema())["description"];
  for (const char* id : {"own-season", "lying-snow", "winter-growth", "sandstorm", "summer-thaw"}) {
    EXPECT_NE(description.find(id), std::string::npos) << id;
  }
  // It only weighs what is drawn.
  EXPECT_EQ(description.find("pine-land"), std::string::npos);
}

TEST(EnvironmentSchemaTest, HasTheValuesOfAUsersCatalogue) {
  const auto catalogue = Catalogue::Extended({{"larch.json", LarchFile()}}).value();
  const Json schema = Json::parse(EnvironmentSchema(*catalogue));
  EnvironmentConfig environment;
  environment.coarse.season = Season::kAutumn;
  environment.fine = DeriveFineAttributes(environment.coarse, *catalogue);
  environment.fine_of(AssetType::kForest).season_variant = "golden larch";
  const std::string json = ToJson(environment, *catalogue);
  EXPECT_EQ(Breaks(schema, Json::parse(json), ""), "");
  EXPECT_NE(Breaks(Json::parse(EnvironmentSchema()), Json::parse(json), ""), "");
  EXPECT_TRUE(ParseEnvironment(json, *catalogue).ok());
  EXPECT_EQ(ParseEnvironment(json).status().violations()[0].code, "unknown_value");
}

TEST(EnvironmentSchemaTest, WhatBreaksItIsRefusedByTheParserToo) {
  const Json schema = Json::parse(EnvironmentSchema());
  const Json example = ExampleJson();
  int broken = 0;
  const Json flat = example.flatten();
  for (const auto& [path, value] : flat.items()) {
    for (const Json& other : {Json("nonsense"), Json(-1), Json(1e9), Json(true)}) {
      Json json = example;
      json[Json::json_pointer(path)] = other;
      if (Breaks(schema, json, "").empty()) continue;
      ++broken;
      ASSERT_FALSE(ParseEnvironment(json.dump()).ok()) << path << " = " << other;
    }
  }
  EXPECT_GT(broken, 100);
}

}  // namespace
}  // namespace latticeworld
