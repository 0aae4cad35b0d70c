#include "latticeworld/generation/bundle/manifest.h"

#include <gtest/gtest.h>

#include <regex>

#include "latticeworld/common/digest.h"

namespace latticeworld {
namespace {

Manifest MakeManifest() {
  Manifest manifest;
  manifest.world_id = "world-0123456789ab";
  manifest.geo = GeoOrigin{40.0 / 3.0, -105.25, 1234.5};
  manifest.request.visual_kind = VisualKind::kElevation;
  manifest.request.visual_name = "N40W106.hgt";
  manifest.request.elevation.centered = false;
  manifest.request.elevation.latitude_deg = 13.3;
  manifest.request.elevation.longitude_deg = -105.25;
  manifest.request.elevation.keep_altitude = true;
  manifest.request.layout_instruction = "ein \"See\" — é";
  manifest.request.vocabulary = "wild";
  manifest.request.generator = "grounded";
  manifest.request.seed = 18446744073709551615u;
  manifest.request.size_m = 100.0 / 3.0;
  manifest.height_png_scale_m = 12.25;
  manifest.height_png_offset_m = -3.5;
  manifest.water_png_scale_m = 0.1;
  manifest.octree_resolution_m = 0.5;
  manifest.atmosphere.wind_mps = {0.1, 0.2, 0.0};
  manifest.warnings = {"one", "two"};
  manifest.stages = {{"relief", 0.25}};
  manifest.files = {{"layout.txt", 1056, std::string(64, 'a')}};
  return manifest;
}

// The manifest with something in it changed and the digest made right again, as a program that does
// not know our rules would write it.
std::string Forged(const std::string& what, const std::string& with) {
  std::string content = EncodeManifest(MakeManifest());
  const std::size_t offset = content.find(what);
  EXPECT_NE(offset, std::string::npos) << what;
  content.replace(offset, what.size(), with);
  const std::string key = "\"manifest_sha256\": \"";
  const std::size_t digits = content.rfind(key) + key.size();
  content.replace(digits, 64, std::string(64, '0'));
  return content.replace(digits, 64, Sha256Hex(content));
}

TEST(ManifestTest, GivesBackEveryField) {
  const Manifest manifest = MakeManifest();
  const auto decoded = DecodeManifest(EncodeManifest(manifest));
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  EXPECT_EQ(decoded->world_id, manifest.world_id);
  ASSERT_TRUE(decoded->geo.has_value());
  EXPECT_EQ(decoded->geo->latitude_deg, 40.0 / 3.0);
  EXPECT_EQ(decoded->geo->longitude_deg, -105.25);
  EXPECT_EQ(decoded->geo->altitude_m, 1234.5);
  EXPECT_EQ(decoded->request.visual_kind, VisualKind::kElevation);
  EXPECT_EQ(decoded->request.visual_name, "N40W106.hgt");
  EXPECT_FALSE(decoded->request.elevation.centered);
  EXPECT_EQ(decoded->request.elevation.latitude_deg, 13.3);
  EXPECT_EQ(decoded->request.elevation.longitude_deg, -105.25);
  EXPECT_TRUE(decoded->request.elevation.keep_altitude);
  EXPECT_EQ(decoded->request.layout_instruction, manifest.request.layout_instruction);
  EXPECT_EQ(decoded->request.seed, manifest.request.seed);
  EXPECT_EQ(decoded->request.size_m, manifest.request.size_m);
  EXPECT_EQ(decoded->height_png_scale_m, 12.25);
  EXPECT_EQ(decoded->height_png_offset_m, -3.5);
  EXPECT_EQ(decoded->water_png_scale_m, 0.1);
  EXPECT_EQ(decoded->atmosphere.wind_mps, manifest.atmosphere.wind_mps);
  EXPECT_EQ(decoded->warnings, manifest.warnings);
  ASSERT_EQ(decoded->files.size(), 1u);
  EXPECT_EQ(decoded->files[0].bytes, 1056u);
  EXPECT_EQ(EncodeManifest(*decoded), EncodeManifest(manifest));
}

TEST(ManifestTest, OnlyMapsOfOtherValuesSaySo) {
  Manifest manifest = MakeManifest();
  EXPECT_EQ(EncodeManifest(manifest).find("map_values"), std::string::npos);
  EXPECT_EQ(DecodeManifest(EncodeManifest(manifest))->map_values, MapValues::kGraded);
  manifest.map_values = MapValues::kTrinary;
  const auto decoded = DecodeManifest(EncodeManifest(manifest));
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  EXPECT_EQ(decoded->map_values, MapValues::kTrinary);
}

TEST(ManifestTest, AWorldMayLieNowhereOnTheEarth) {
  Manifest manifest = MakeManifest();
  manifest.geo.reset();
  const auto decoded = DecodeManifest(EncodeManifest(manifest));
  ASSERT_TRUE(decoded.ok()) << decoded.status().ToString();
  EXPECT_FALSE(decoded->geo.has_value());
}

TEST(ManifestTest, SeesAChangeOfAnyByte) {
  const std::string content = EncodeManifest(MakeManifest());
  for (std::size_t i = 0; i < content.size(); ++i) {
    std::string changed = content;
    changed[i] ^= 1;
    EXPECT_FALSE(DecodeManifest(changed).ok()) << "byte " << i;
  }
}

TEST(ManifestTest, IsRefusedWhereverItIsCut) {
  const std::string content = EncodeManifest(MakeManifest());
  for (std::size_t length = 0; length + 1 < content.size(); ++length) {
    EXPECT_FALSE(DecodeManifest(content.substr(0, length)).ok()) << "cut to " << length;
  }
}

TEST(ManifestTest, NamesBothVersionsOfAnotherFormat) {
  for (const std::string& content : {Forged("\"format_version\": 7", "\"format_version\": 9"),
                                     std::string("{\"format_version\": 9, \"what\": \"ever\"}")}) {
    const auto decoded = DecodeManifest(content);
    ASSERT_FALSE(decoded.ok());
    EXPECT_EQ(decoded.status().code(), StatusCode::kFailedPrecondition);
    EXPECT_NE(decoded.status().message().find("version 9"), std::string::npos);
    EXPECT_NE(decoded.status().message().find("versions 5 to 7"), std::string::npos);
  }
}

// Format 5 has one name for who read and who answered, and no unit of elevation.
TEST(ManifestTest, ReadsTheFormatBefore) {
  const std::pair<std::string, std::pair<std::string, std::string>> names[] = {
      {"grounded", {"rules", "grounded"}},
      {"interpreted", {"remote", "grounded"}},
      {"controlled", {"controlled", "grounded"}},
      {"reader", {"model", "grounded"}},
      {"local", {"rules", "local"}}};
  for (const auto& [name, wanted] : names) {
    Manifest manifest = MakeManifest();
    manifest.request.generator = name;
    std::string content = EncodeManifest(manifest);
    content =
        std::regex_replace(content, std::regex("\"format_version\": 6"), "\"format_version\": 5");
    content = std::regex_replace(content, std::regex("\\s*\"(reader|unit)\": \"\",?"), "");
    content = std::regex_replace(content, std::regex(",(\\s*\\})"), "$1");
    const std::string key = "\"manifest_sha256\": \"";
    const std::size_t digits = content.rfind(key) + key.size();
    content.replace(digits, 64, std::string(64, '0'));
    content.replace(digits, 64, Sha256Hex(content));
    const auto decoded = DecodeManifest(content);
    ASSERT_TRUE(decoded.ok()) << name << ": " << decoded.status().ToString();
    EXPECT_EQ(decoded->request.reader, wanted.first);
    EXPECT_EQ(decoded->request.generator, wanted.second);
    EXPECT_EQ(decoded->request.elevation.unit, ElevationUnit::kJudged);
  }
}

TEST(ManifestTest, NamesIllegalValues) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {Forged("\"vocabulary\": \"wild\"", "\"vocabulary\": \"sea\""), "suburb, wild"},
      {Forged("\"vocabulary\": \"wild\"", "\"vocabulary\": \"\""), "suburb, wild"},
      {Forged("\"seed\": 18446744073709551615", "\"seed\": -1"), "seed is -1"},
      {Forged("\"seed\": 18446744073709551615", "\"seed\": 1.5"), "seed is 1.5"},
      {Forged("\"visual_kind\": \"elevation\"", "\"visual_kind\": \"film\""), "none, height_map"},
      {Forged("\"latitude_deg\": 13.3,", "\"latitude_deg\": 93.3,"), "latitude_deg is 93.3"},
      {Forged("\"longitude_deg\": -105.25", "\"longitude_deg\": -365.0"), "longitude_deg is"},
      {Forged("\"altitude_m\": 1234.5", "\"altitude_m\": null"), "altitude_m is null"},
      {Forged("\"altitude_m\": 1234.5", "\"altitude_m\": 1e300"), "altitude_m is 1e+300"},
      {Forged("\"geo\"", "\"place\""), "geo is missing"},
      {Forged("\"keep_altitude\": true", "\"keep_altitude\": 1"), "keep_altitude is 1"},
      {Forged("\"weather\": \"sunny\"", "\"weather\": \"hail\""), "weather is"},
      {Forged("\"sun_intensity\": 1.0", "\"sun_intensity\": 2.0"), "sun_intensity is 2.0"},
      {Forged("\"gust_mps\": 0.0", "\"gust_mps\": 1e300"), "gust_mps is 1e+300"},
      {Forged("\"rain_mmph\": 0.0", "\"rain_mmph\": 1e300"), "rain_mmph is 1e+300"},
      {Forged("\"snowfall_mmph\": 0.0", "\"snowfall_mmph\": 1e300"), "snowfall_mmph is 1e+300"},
      {Forged("\"snow_depth_m\": 0.0", "\"snow_depth_m\": 1e300"), "snow_depth_m is 1e+300"},
      {Forged("\"water_rise_m\": 0.0", "\"water_rise_m\": -1e300"), "water_rise_m is -1e+300"},
      {Forged("\n      0.1,\n", "\n      1e300,\n"), "wind_mps is"},
      {Forged("\"bytes\": 1056", "\"bytes\": \"1056\""), "bytes is"},
      {Forged("\"warnings\"", "\"warning\""), "warnings is missing"},
      {Forged("\"warnings\"", "\"more\": 1, \"warnings\""), "is unknown"},
      {Forged("\"two\"", "2"), "warning is 2"},
  };
  for (const auto& [content, message] : cases) {
    const auto decoded = DecodeManifest(content);
    ASSERT_FALSE(decoded.ok()) << message;
    EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
    EXPECT_NE(decoded.status().message().find(message), std::string::npos)
        << message << " | " << decoded.status().message();
  }
}

TEST(ManifestTest, SurvivesHostileJson) {
  const std::string deep(1 << 20, '[');
  for (const std::string& content :
       {std::string(), std::string("null"), std::string("[]"), std::string("{}"), deep,
        std::string("{\"manifest_sha256\": 1}"), std::string("\xff\xfe"),
        std::string("{\"manifest_sha256\": \"")}) {
    EXPECT_FALSE(DecodeManifest(content).ok());
  }
}

TEST(ManifestTest, ADeepValueEndsInAnAnswer) {
  const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
  const auto decoded = DecodeManifest(Forged("\"world-0123456789ab\"", deep));
  ASSERT_FALSE(decoded.ok());
  EXPECT_EQ(decoded.status().code(), StatusCode::kDataLoss);
  EXPECT_NE(decoded.status().message().find("nested deeper than 8"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
