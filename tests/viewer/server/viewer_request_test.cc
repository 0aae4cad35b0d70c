#include "latticeworld/viewer/server/viewer_request.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

ViewerRequest Parsed(const std::string& text) {
  std::string id, type;
  const auto request = ParseRequest(text, &id, &type);
  EXPECT_TRUE(request.ok()) << request.status().ToString();
  return request.ok() ? *request : ViewerRequest();
}

Status Refused(const std::string& text) {
  std::string id, type;
  const auto request = ParseRequest(text, &id, &type);
  EXPECT_FALSE(request.ok()) << text;
  EXPECT_EQ(request.status().code(), StatusCode::kInvalidArgument);
  return request.status();
}

TEST(ViewerRequestTest, ReadsEveryKey) {
  const ViewerRequest drive = Parsed(
      R"({"type": "drive", "robot": "robot_2", "linear_mps": 1.5, "lateral_mps": -1,
          "vertical_mps": 0.5, "angular_radps": -0.25, "id": "a"})");
  EXPECT_EQ(drive.type, RequestType::kDrive);
  EXPECT_EQ(drive.robot, "robot_2");
  EXPECT_EQ(drive.linear_mps, (std::array<double, 3>{1.5, -1.0, 0.5}));
  EXPECT_EQ(drive.angular_radps, -0.25);
  EXPECT_EQ(drive.id, "\"a\"");

  const ViewerRequest generate = Parsed(
      R"({"type": "generate", "layout": "Königssee\nand a wood", "environment": "rain", "seed": 7,
          "size_m": 128, "resolution_m": 1, "vocabulary": "wild", "generator": "remote"})");
  EXPECT_EQ(generate.layout, "Königssee\nand a wood");
  EXPECT_EQ(generate.environment, "rain");
  EXPECT_EQ(generate.seed, 7u);
  EXPECT_EQ(generate.size_m, 128.0);
  EXPECT_EQ(generate.resolution_m, 1.0);
  EXPECT_EQ(generate.vocabulary, "wild");
  EXPECT_EQ(generate.generator, "remote");

  const ViewerRequest weather = Parsed(R"({"type": "set_weather", "weather": "fog", "hour": 6.5})");
  EXPECT_EQ(weather.weather, "fog");
  EXPECT_EQ(weather.hour, 6.5);
  EXPECT_FALSE(weather.intensity.has_value());
  const ViewerRequest layers =
      Parsed(R"({"type": "subscribe", "layers": ["paths"], "robot": "scout"})");
  EXPECT_TRUE(layers.paths);
  EXPECT_FALSE(layers.lidar);
  EXPECT_EQ(Parsed(R"({"type": "step", "steps": 100000})").steps, 100000u);
  EXPECT_EQ(Parsed(R"({"type": "speed", "factor": 0})").factor, 0.0);
  EXPECT_EQ(Parsed(R"({"type": "load_world", "name": "lake"})").name, "lake");
}

TEST(ViewerRequestTest, NamesEverythingThatIsWrong) {
  const Status status = Refused(
      R"({"type": "generate", "layout": 3, "seed": -1, "size_m": "big", "sise_m": 4, "id": {}})");
  EXPECT_EQ(status.violations().size(), 5u) << status.ToString();
  for (const char* word : {"layout", "seed", "size_m", "sise_m", "id"}) {
    EXPECT_NE(status.message().find(word), std::string::npos) << word;
  }
  const Status fly = Refused(R"({"type": "fly", "id": {}})");
  EXPECT_EQ(fly.violations().size(), 2u) << fly.ToString();
  EXPECT_NE(fly.message().find("authenticate, subscribe"), std::string::npos);
}

TEST(ViewerRequestTest, CarriesWhatWorldServerJudges) {
  EXPECT_EQ(Parsed(R"({"type": "step", "steps": 100001})").steps, 100001u);
  EXPECT_EQ(Parsed(R"({"type": "speed", "factor": -0.001})").factor, -0.001);
  const ViewerRequest generate =
      Parsed(R"({"type": "generate", "size_m": -1, "resolution_m": 1e9, "vocabulary": "moon"})");
  EXPECT_EQ(generate.size_m, -1.0);
  EXPECT_EQ(generate.resolution_m, 1e9);
  EXPECT_EQ(generate.vocabulary, "moon");
  const ViewerRequest weather = Parsed(
      R"({"type": "set_weather", "weather": "hail", "intensity": 2, "hour": 25,
          "transition_s": -1})");
  EXPECT_EQ(weather.weather, "hail");
  EXPECT_EQ(weather.intensity, 2.0);
  EXPECT_EQ(weather.hour, 25.0);
  EXPECT_EQ(weather.transition_s, -1.0);
}

TEST(ViewerRequestTest, RefusesWhatItCannotCarry) {
  for (const char* text :
       {R"({"type": "step", "steps": 0})", R"({"type": "step", "steps": 1.5})",
        R"({"type": "step", "steps": 4294967296})", R"({"type": "speed", "factor": "fast"})",
        R"({"type": "speed", "factor": 1e999})", R"({"type": "drive", "robot": ""})",
        R"({"type": "drive", "robot": "a/b"})", R"({"type": "drive", "robot": "9a"})",
        R"({"type": "drive", "robot": "a", "linear_mps": null})",
        R"({"type": "drive", "robot": "a", "linear_mps": 1001})",
        R"({"type": "set_weather", "hour": [6]})", R"({"type": "subscribe"})",
        R"({"type": "subscribe", "layers": ["smell"]})",
        R"({"type": "reset", "seed": "18446744073709551616"})",
        R"({"type": "load_world", "name": "a\u0000b"})"}) {
    EXPECT_FALSE(Refused(text).ok()) << text;
  }
}

TEST(ViewerRequestTest, KeepsTheIdOfWhatItRefuses) {
  std::string id, type;
  EXPECT_FALSE(ParseRequest(R"({"id": 12, "type": "step", "steps": 0})", &id, &type).ok());
  EXPECT_EQ(id, "12");
  EXPECT_EQ(type, "step");
  EXPECT_FALSE(ParseRequest("{\"id\": 12", &id, &type).ok());
  EXPECT_EQ(id, "null");
  EXPECT_EQ(type, "");
}

TEST(ViewerRequestTest, NothingThatIsSentBreaksIt) {
  RandomStream random(9, "requests");
  const std::string legal =
      R"({"type": "drive", "robot": "robot", "linear_mps": 1.0, "angular_radps": [], "id": 3})";
  for (int i = 0; i < 5000; ++i) {
    std::string text = legal;
    for (int change = random.UniformInt(1, 6); change > 0; --change) {
      text[random.UniformInt(0, static_cast<int>(text.size()) - 1)] =
          static_cast<char>(random.UniformInt(0, 255));
    }
    std::string id, type;
    const auto request = ParseRequest(text, &id, &type);
    EXPECT_TRUE(request.ok() || !request.status().message().empty());
    EXPECT_FALSE(nlohmann::json::parse(id, nullptr, false).is_discarded()) << id;
  }
  EXPECT_FALSE(Refused(std::string(5000, '[')).ok());
}

}  // namespace
}  // namespace latticeworld
