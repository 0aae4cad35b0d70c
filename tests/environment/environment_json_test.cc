#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

template <typename Enum>
Enum Draw(RandomStream* random) {
  const auto names = EnumNames(Enum{});
  return names[static_cast<std::size_t>(random->UniformInt(0, static_cast<int>(names.size()) - 1))]
      .value;
}

EnvironmentConfig RandomEnvironment(std::uint64_t seed) {
  RandomStream random(seed, "environment");
  EnvironmentConfig environment;
  environment.coarse = {Draw<TerrainType>(&random), Draw<Season>(&random),
                        Draw<ArtisticStyle>(&random), Draw<Weather>(&random),
                        Draw<TimeOfDay>(&random)};
  environment.fine = SampleFineAttributes(environment.coarse, *Catalogue::BuiltIn(), &random);
  for (int i = random.UniformInt(0, 5); i > 0; --i) {
    AgentGroup group{Draw<AgentCategory>(&random), random.UniformInt(1, 100), AgentState::kIdle,
                     Draw<Region>(&random)};
    const AgentState state = Draw<AgentState>(&random);
    if (CanBe(group.category, state)) group.state = state;
    environment.agents.push_back(group);
  }
  return environment;
}

// The violations of the example's JSON after `change`.
template <typename Change>
std::vector<Violation> ViolationsAfter(Change&& change) {
  Json json = Json::parse(ToJson(RandomEnvironment(1)));
  change(json);
  return ParseEnvironment(json.dump()).status().violations();
}

TEST(EnvironmentJsonTest, ReadsBackWhatItWrites) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const EnvironmentConfig environment = RandomEnvironment(seed);
    const std::string json = ToJson(environment);
    const Result<EnvironmentConfig> read = ParseEnvironment(json);
    ASSERT_TRUE(read.ok()) << read.status().ToString();
    ASSERT_EQ(ToJson(*read), json);
    ASSERT_EQ(read->fine_of(AssetType::kStone).rotation_deg,
              environment.fine_of(AssetType::kStone).rotation_deg);
    ASSERT_EQ(read->agents.size(), environment.agents.size());
  }
}

TEST(EnvironmentJsonTest, EachMissingKeyIsNamed) {
  const Json whole = Json::parse(ToJson(RandomEnvironment(1)));
  int removed = 0;
  const Json flat = whole.flatten();
  for (const auto& [path, value] : flat.items()) {
    const Json::json_pointer pointer(path);
    if (pointer.back().find_first_not_of("0123456789") == std::string::npos) continue;
    Json json = whole;
    json.at(pointer.parent_pointer()).erase(pointer.back());
    const auto violations = ParseEnvironment(json.dump()).status().violations();
    ASSERT_EQ(violations.size(), 1u) << path;
    EXPECT_EQ(violations[0].code, "missing_key");
    EXPECT_EQ(violations[0].pointer, path);
    ++removed;
  }
  EXPECT_GT(removed, 30);
}

TEST(EnvironmentJsonTest, EachValueOfAWrongTypeIsNamed) {
  const Json whole = Json::parse(ToJson(RandomEnvironment(1)));
  const Json flat = whole.flatten();
  for (const auto& [path, value] : flat.items()) {
    for (const Json& wrong :
         {Json(nullptr), Json(true), Json(Json::array()), Json(Json::object())}) {
      Json json = whole;
      json[Json::json_pointer(path)] = wrong;
      const auto violations = ParseEnvironment(json.dump()).status().violations();
      ASSERT_EQ(violations.size(), 1u) << path << " = " << wrong;
      EXPECT_EQ(violations[0].code, "wrong_type") << path;
      EXPECT_EQ(violations[0].pointer, path);
    }
  }
}

TEST(EnvironmentJsonTest, UnknownKeysAreErrorsAtEveryLevel) {
  const Json whole = Json::parse(ToJson(RandomEnvironment(1)));
  for (const char* path : {"", "/coarse", "/fine", "/fine/grass"}) {
    Json json = whole;
    json[Json::json_pointer(std::string(path) + "/colour")] = 1;
    const auto violations = ParseEnvironment(json.dump()).status().violations();
    ASSERT_EQ(violations.size(), 1u) << path;
    EXPECT_EQ(violations[0].code, "unknown_key");
    EXPECT_EQ(violations[0].pointer, std::string(path) + "/colour");
  }
}

TEST(EnvironmentJsonTest, AllViolationsComeAtOnce) {
  const auto violations = ViolationsAfter([](Json& json) {
    json["coarse"].erase("season");
    json["coarse"]["weather"] = "hail";
    json["fine"]["grass"]["density"] = "much";
    json["fine"]["sea"] = 1;
  });
  std::vector<std::string> codes;
  for (const Violation& violation : violations) codes.push_back(violation.code);
  std::sort(codes.begin(), codes.end());
  EXPECT_EQ(codes, (std::vector<std::string>{"missing_key", "unknown_key", "unknown_value",
                                             "wrong_type"}));
}

TEST(EnvironmentJsonTest, ValuesOutOfRangeAndConflictsAreRefused) {
  const auto code = [](const char* path, const Json& value) {
    const auto violations = ViolationsAfter([&](Json& json) {
      json["coarse"]["season"] = "winter";
      json[Json::json_pointer(path)] = value;
    });
    for (const Violation& violation : violations) {
      if (violation.pointer == path) return violation.code;
    }
    return std::string("none");
  };
  EXPECT_EQ(code("/fine/grass/density", 1.01), "out_of_range");
  EXPECT_EQ(code("/fine/grass/density", -0.01), "out_of_range");
  EXPECT_EQ(code("/fine/stone/rotation/2", 360.0), "out_of_range");
  EXPECT_EQ(code("/fine/architecture/scale", 0.0), "out_of_range");
  EXPECT_EQ(code("/fine/desert/wind", 1e300), "out_of_range");
  EXPECT_EQ(code("/fine/forest/season_variant", "summer oak"), "conflict");
  EXPECT_EQ(code("/fine/forest/season_variant", "plastic"), "unknown_value");
}

TEST(EnvironmentJsonTest, AgentsAreBoundedAndFitTheirState) {
  const auto code = [](const Json& agents) {
    const auto violations = ViolationsAfter([&](Json& json) { json["agents"] = agents; });
    return violations.empty() ? std::string("ok") : violations[0].code;
  };
  const auto group = [](const char* category, const Json& quantity, const char* state) {
    return Json{
        {"category", category}, {"quantity", quantity}, {"state", state}, {"position", "center"}};
  };
  EXPECT_EQ(code(Json::array({group("sheep", 9, "grazing")})), "ok");
  EXPECT_EQ(code(Json::array({group("sheep", 0, "grazing")})), "out_of_range");
  EXPECT_EQ(code(Json::array({group("sheep", 1.5, "grazing")})), "wrong_type");
  EXPECT_EQ(code(Json::array({group("sheep", 99999999999999ULL, "grazing")})), "out_of_range");
  EXPECT_EQ(code(Json::array({group("goblin", 1, "grazing")})), "conflict");
  EXPECT_EQ(code(Json::array({group("dragon", 1, "idle")})), "unknown_value");
  EXPECT_EQ(code(Json::array({group("sheep", 500, "idle"), group("horse", 500, "idle"),
                              group("horse", 1, "idle")})),
            "out_of_range");
}

// Arrays are kept up to the first element too many, and so are the faults within them.
TEST(EnvironmentJsonTest, GroupsBeyondTheLimitAreNotRead) {
  const auto violations = ViolationsAfter(
      [](Json& json) { json["agents"] = std::vector<Json>(300000, Json::object()); });
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].code, "out_of_range");
  EXPECT_EQ(violations[0].pointer, "/agents");
  EXPECT_EQ(violations[0].given, "more than 1000");
}

TEST(EnvironmentJsonTest, MessagesQuoteWhatWasGiven) {
  const auto said = [](const char* path, const Json& value) {
    const auto violations = ViolationsAfter([&](Json& json) {
      json["agents"] = Json::parse(
          R"([{"category": "sheep", "quantity": 1, "state": "idle", "position": "center"}])");
      json[Json::json_pointer(path)] = value;
    });
    EXPECT_EQ(violations.size(), 1u);
    return violations.empty() ? std::string() : violations[0].message + " | " + violations[0].given;
  };
  EXPECT_EQ(
      said("/agents/0/quantity", 99999999999),
      "must be from 1 to " + std::to_string(kMaxGroupQuantity) + ", not 99999999999 | 99999999999");
  EXPECT_EQ(said("/agents/0/quantity", 1.0), "must be a whole number, not 1.0 (number) | 1.0");
  EXPECT_EQ(said("/agents/0/quantity", "many"),
            "must be a whole number, not \"many\" (string) | \"many\"");
  EXPECT_EQ(said("/fine/stone/rotation", Json::array({0, "a"})),
            "must be an array [roll, pitch, yaw] of three degrees, not [0,\"a\"] (array) | "
            "[0,\"a\"]");
}

TEST(EnvironmentJsonTest, DuplicateKeysAreRefused) {
  std::string json = ToJson(RandomEnvironment(1));
  json.insert(json.find("\"season\""), "\"season\": \"winter\", ");
  const Status status = ParseEnvironment(json).status();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.violations()[0].code, "duplicate_key");
  EXPECT_EQ(status.violations()[0].pointer, "/coarse/season");
}

TEST(EnvironmentJsonTest, ADuplicateInsideAnArrayIsPlaced) {
  Json json = Json::parse(ToJson(RandomEnvironment(1)));
  const Json sheep = {
      {"category", "sheep"}, {"quantity", 1}, {"state", "idle"}, {"position", "center"}};
  json["agents"] = Json::array({sheep, sheep, sheep});
  std::string text = json.dump();
  text.insert(text.rfind("\"state\""), "\"state\": \"idle\", ");
  const Status status = ParseEnvironment(text).status();
  ASSERT_EQ(status.violations().size(), 1u) << status.ToString();
  EXPECT_EQ(status.violations()[0].pointer, "/agents/2/state");
}

TEST(EnvironmentJsonTest, PointersEscapeOddKeys) {
  const auto violations = ViolationsAfter([](Json& json) { json["a/b~c"] = 1; });
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].pointer, "/a~1b~0c");
}

TEST(EnvironmentJsonTest, AFloodOfKeysEndsInABoundedAnswer) {
  std::string flat = "{", nested = "{\"agents\": [";
  for (int i = 0; flat.size() < 1000000; ++i) flat += "\"k" + std::to_string(i) + "\": 0, ";
  while (nested.size() < 1000000) nested += "{\"x\": {\"y\": 0}, \"x\": 1}, ";
  flat += "\"last\": 0}";
  nested += "{}]}";
  for (const std::string& text :
       {flat, nested, "{\"" + std::string(1000000, 'k') + "\": {\"\": 0}}"}) {
    const Status status = ParseEnvironment(text).status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_LE(status.violations().size(), 501u);
    EXPECT_LT(status.message().size(), 100000u);
  }
  // Twice the same key at each of 80,000 levels: paths to all of them would take gigabytes.
  std::string deep;
  while (deep.size() < 900000) deep += "{\"a\":0,\"a\":";
  deep += "0" + std::string(deep.size() / 11, '}');
  EXPECT_NE(ParseEnvironment(deep).status().message().find("nested deeper"), std::string::npos);
  // The first 64 keys of an object are kept to be named, and no more.
  EXPECT_LE(ParseEnvironment(flat).status().violations().size(), 80u);
}

TEST(EnvironmentJsonTest, WhatIsNoJsonIsRefused) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[1,2"), std::string("\xff\xfe"),
        std::string("{\"coarse\": NaN}"), std::string(100000, '['), std::string(2 << 20, ' '),
        ToJson(RandomEnvironment(2)) + "x"}) {
    const Status status = ParseEnvironment(text).status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_LT(status.message().size(), 1000u);
  }
  EXPECT_FALSE(ParseEnvironment("[]").ok());
  EXPECT_FALSE(ParseEnvironment("null").ok());
}

TEST(EnvironmentJsonTest, NestingIsBounded) {
  const auto message = [](int depth) {
    return ParseEnvironment("{\"deep\": " + std::string(depth - 1, '[') + "0" +
                            std::string(depth - 1, ']') + "}")
        .status()
        .message();
  };
  EXPECT_EQ(message(8).find("nested deeper"), std::string::npos) << message(8);
  EXPECT_NE(message(9).find("nested deeper than 8"), std::string::npos) << message(9);
}

TEST(EnvironmentJsonTest, CutDocumentsNeverPass) {
  const std::string json = ToJson(RandomEnvironment(3));
  for (std::size_t length = 0; length + 2 < json.size(); length += 7) {
    ASSERT_FALSE(ParseEnvironment(json.substr(0, length)).ok()) << length;
  }
}

TEST(EnvironmentJsonTest, DamagedDocumentsAreRefusedOrReadAsALegalEnvironment) {
  RandomStream random(1, "damage");
  const std::vector<std::string> splices = {"{",    "}",       "[",    "]",       "\"",
                                            ",",    ":",       "-",    "e9",      "1e999",
                                            "null", "\\ud800", "\xff", "\\u0000", "/~"};
  for (int i = 0; i < 1500; ++i) {
    std::string text = ToJson(RandomEnvironment(static_cast<std::uint64_t>(i % 20)));
    for (int k = random.UniformInt(1, 3); k > 0; --k) {
      const auto at =
          static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(text.size()) - 1));
      switch (random.UniformInt(0, 2)) {
        case 0:
          text[at] = static_cast<char>(text[at] ^ 1 << random.UniformInt(0, 7));
          break;
        case 1:
          text.erase(at, static_cast<std::size_t>(random.UniformInt(1, 30)));
          break;
        default:
          text.insert(at, splices[static_cast<std::size_t>(
                              random.UniformInt(0, static_cast<int>(splices.size()) - 1))]);
      }
      if (text.empty()) text = " ";
    }
    const Result<EnvironmentConfig> read = ParseEnvironment(text);
    if (read.ok()) {
      ASSERT_TRUE(Validate(*read).empty()) << i;
    } else {
      ASSERT_EQ(read.status().code(), StatusCode::kInvalidArgument) << i;
    }
  }
}

}  // namespace
}  // namespace latticeworld
