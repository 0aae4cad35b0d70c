#include "latticeworld/generation/bundle/manifest.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/common/digest.h"
#include "latticeworld/generation/json_fields.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;
using jf::Json;

constexpr std::string_view kDigestKey = "\"manifest_sha256\": \"";
constexpr std::size_t kDigestDigits = 64;

constexpr double kHighest_m = 1e6;  // over the ellipsoid
// Beyond every weather, so that no computation with it can overflow.
constexpr double kMostRain_mmph = 1e4;
constexpr double kMostWind_mps = 1e3;
constexpr double kDeepestSnow_m = 100.0;
constexpr double kMostRise_m = 1e4;

Json Encode(const ElevationOptions& elevation) {
  return {{"centered", elevation.centered},
          {"latitude_deg", elevation.latitude_deg},
          {"longitude_deg", elevation.longitude_deg},
          {"keep_altitude", elevation.keep_altitude},
          {"unit", NameOf(elevation.unit)}};
}

ElevationOptions DecodeElevation(const Json& json) {
  jf::ExpectKeys(json, {"centered", "latitude_deg", "longitude_deg", "keep_altitude", "unit"});
  ElevationOptions elevation;
  elevation.centered = jf::Boolean(json, "centered");
  elevation.latitude_deg = jf::Number(json, "latitude_deg", -90.0, 90.0);
  elevation.longitude_deg = jf::Number(json, "longitude_deg", -180.0, 180.0);
  elevation.keep_altitude = jf::Boolean(json, "keep_altitude");
  elevation.unit = jf::Named<ElevationUnit>(json, "unit");
  return elevation;
}

// null: the world lies nowhere on the earth.
Json Encode(const std::optional<GeoOrigin>& geo) {
  if (!geo) return Json();
  return {{"latitude_deg", geo->latitude_deg},
          {"longitude_deg", geo->longitude_deg},
          {"altitude_m", geo->altitude_m}};
}

std::optional<GeoOrigin> DecodeGeo(const Json& json) {
  if (json.is_null()) return std::nullopt;
  jf::ExpectKeys(json, {"latitude_deg", "longitude_deg", "altitude_m"});
  return GeoOrigin{jf::Number(json, "latitude_deg", -90.0, 90.0),
                   jf::Number(json, "longitude_deg", -180.0, 180.0),
                   jf::Number(json, "altitude_m", -kHighest_m, kHighest_m)};
}

Json Encode(const GenerationRequest& request) {
  return {{"layout_instruction", request.layout_instruction},
          {"environment_instruction", request.environment_instruction},
          {"visual_kind", NameOf(request.visual_kind)},
          {"visual_name", request.visual_name},
          {"sketch_translator", request.sketch_translator},
          {"height_map_scale_m", request.height_map.height_scale_m},
          {"height_map_offset_m", request.height_map.height_offset_m},
          {"elevation", Encode(request.elevation)},
          {"vocabulary", request.vocabulary},
          {"reader", request.reader},
          {"generator", request.generator},
          {"seed", request.seed},
          {"size_m", request.size_m},
          {"resolution_m", request.resolution_m}};
}

// In format 5 one name says who read and who answered.
void AddWhatFormat5Lacks(Json* request) {
  if (!request->is_object() || request->contains("reader")) return;
  const std::string generator = jf::Text(*request, "generator");
  (*request)["reader"] = generator == "interpreted"  ? "remote"
                         : generator == "controlled" ? "controlled"
                         : generator == "reader"     ? "model"
                                                     : "rules";
  if ((*request)["reader"] != "rules") (*request)["generator"] = "grounded";
  if (request->contains("elevation") && (*request)["elevation"].is_object()) {
    (*request)["elevation"]["unit"] = NameOf(ElevationUnit::kJudged);
  }
}

GenerationRequest DecodeRequest(Json json) {
  AddWhatFormat5Lacks(&json);
  jf::ExpectKeys(json,
                 {"layout_instruction", "environment_instruction", "visual_kind", "visual_name",
                  "sketch_translator", "height_map_scale_m", "height_map_offset_m", "elevation",
                  "vocabulary", "reader", "generator", "seed", "size_m", "resolution_m"});
  GenerationRequest request;
  request.layout_instruction = jf::Text(json, "layout_instruction");
  request.environment_instruction = jf::Text(json, "environment_instruction");
  request.visual_kind = jf::Named<VisualKind>(json, "visual_kind");
  request.visual_name = jf::Text(json, "visual_name");
  request.sketch_translator = jf::Text(json, "sketch_translator");
  request.height_map.height_scale_m = jf::Number(json, "height_map_scale_m");
  request.height_map.height_offset_m = jf::Number(json, "height_map_offset_m");
  request.elevation = DecodeElevation(json["elevation"]);
  jf::Named<Vocabulary>(json, "vocabulary");  // resolved when it was saved: never empty
  request.vocabulary = jf::Text(json, "vocabulary");
  request.reader = jf::Text(json, "reader");
  request.generator = jf::Text(json, "generator");
  request.seed = jf::Unsigned(json, "seed");
  request.size_m = jf::Number(json, "size_m");
  request.resolution_m = jf::Number(json, "resolution_m");
  return request;
}

Json Encode(const Eigen::Vector3d& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

// highest: the greatest magnitude of a component.
Eigen::Vector3d DecodeVector(const Json& object, const char* key, double highest) {
  const Json& json = jf::Array(object, key);
  const auto legal = [&](const Json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= highest;
  };
  if (json.size() != 3 || !std::all_of(json.begin(), json.end(), legal)) {
    jf::Fail(key, json, "three numbers of at most " + FormatDouble(highest));
  }
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Json Encode(const Atmosphere& atmosphere) {
  return {{"weather", NameOf(atmosphere.weather)},
          {"intensity", atmosphere.intensity},
          {"visibility_m", atmosphere.visibility_m},
          {"rain_mmph", atmosphere.rain_mmph},
          {"snowfall_mmph", atmosphere.snowfall_mmph},
          {"cloud_cover", atmosphere.cloud_cover},
          {"wind_mps", Encode(atmosphere.wind_mps)},
          {"gust_mps", atmosphere.gust_mps},
          {"hour", atmosphere.hour},
          {"day_of_year", atmosphere.day_of_year},
          {"latitude_deg", atmosphere.latitude_deg},
          {"direct_light", atmosphere.direct_light},
          {"diffuse_light", atmosphere.diffuse_light},
          {"sun_direction", Encode(atmosphere.sun_direction)},
          {"sun_intensity", atmosphere.sun_intensity},
          {"ambient_intensity", atmosphere.ambient_intensity},
          {"ground_wetness", atmosphere.ground_wetness},
          {"snow_depth_m", atmosphere.snow_depth_m},
          {"blown_sand", atmosphere.blown_sand},
          {"water_rise_m", atmosphere.water_rise_m}};
}

Atmosphere DecodeAtmosphere(const Json& json) {
  jf::ExpectKeys(json, {"weather",        "intensity",     "visibility_m",  "rain_mmph",
                        "snowfall_mmph",  "cloud_cover",   "wind_mps",      "gust_mps",
                        "hour",           "day_of_year",   "latitude_deg",  "direct_light",
                        "diffuse_light",  "sun_direction", "sun_intensity", "ambient_intensity",
                        "ground_wetness", "snow_depth_m",  "blown_sand",    "water_rise_m"});
  Atmosphere atmosphere;
  atmosphere.weather = jf::Named<Weather>(json, "weather");
  atmosphere.intensity = jf::Number(json, "intensity", 0.0, 1.0);
  // Air that nothing can be seen through is no air to see by: everything divides by this.
  atmosphere.visibility_m = jf::Number(json, "visibility_m", 1.0);
  atmosphere.rain_mmph = jf::Number(json, "rain_mmph", 0.0, kMostRain_mmph);
  atmosphere.snowfall_mmph = jf::Number(json, "snowfall_mmph", 0.0, kMostRain_mmph);
  atmosphere.cloud_cover = jf::Number(json, "cloud_cover", 0.0, 1.0);
  atmosphere.wind_mps = DecodeVector(json, "wind_mps", kMostWind_mps);
  atmosphere.gust_mps = jf::Number(json, "gust_mps", 0.0, kMostWind_mps);
  atmosphere.hour = jf::Number(json, "hour", 0.0, 24.0);
  atmosphere.day_of_year = jf::Number(json, "day_of_year", 1.0, 366.0);
  atmosphere.latitude_deg = jf::Number(json, "latitude_deg", -90.0, 90.0);
  atmosphere.direct_light = jf::Number(json, "direct_light", 0.0, 1.0);
  atmosphere.diffuse_light = jf::Number(json, "diffuse_light", 0.0, 1.0);
  atmosphere.ground_wetness = jf::Number(json, "ground_wetness", 0.0, 1.0);
  atmosphere.snow_depth_m = jf::Number(json, "snow_depth_m", 0.0, kDeepestSnow_m);
  atmosphere.blown_sand = jf::Number(json, "blown_sand", 0.0, 1.0);
  atmosphere.water_rise_m = jf::Number(json, "water_rise_m", -kMostRise_m, kMostRise_m);
  atmosphere.sun_direction = DecodeVector(json, "sun_direction", 2.0);
  if (!(std::abs(atmosphere.sun_direction.norm() - 1.0) < 1e-6)) {
    jf::Fail("sun_direction", json["sun_direction"], "a unit vector");
  }
  atmosphere.sun_intensity = jf::Number(json, "sun_intensity", 0.0, 1.0);
  atmosphere.ambient_intensity = jf::Number(json, "ambient_intensity", 0.0, 1.0);
  return atmosphere;
}

Json Encode(const BundleFile& file) {
  return {{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}};
}

BundleFile DecodeFile(const Json& json) {
  jf::ExpectKeys(json, {"name", "bytes", "sha256"});
  return {jf::Text(json, "name"), jf::Unsigned(json, "bytes"), jf::Text(json, "sha256")};
}

// Graded values have no key, as in manifests of before there were others.
MapValues TakeMapValues(Json* json) {
  constexpr char kKey[] = "map_values";
  if (!json->contains(kKey)) return MapValues::kGraded;
  const auto values = jf::Named<MapValues>(*json, kKey);
  json->erase(kKey);
  return values;
}

Manifest DecodeFields(Json json) {
  const MapValues map_values = TakeMapValues(&json);
  jf::ExpectKeys(json, {"format_version", "world_id", "geo", "request", "height_png", "water_png",
                        "octree_resolution_m", "atmosphere", "warnings", "stages", "files",
                        "manifest_sha256"});
  Manifest manifest;
  manifest.map_values = map_values;
  manifest.world_id = jf::Text(json, "world_id");
  manifest.geo = DecodeGeo(json["geo"]);
  manifest.request = DecodeRequest(json["request"]);
  jf::ExpectKeys(json["height_png"], {"scale_m", "offset_m"});
  manifest.height_png_scale_m = jf::Number(json["height_png"], "scale_m", 0.0);
  manifest.height_png_offset_m = jf::Number(json["height_png"], "offset_m");
  jf::ExpectKeys(json["water_png"], {"scale_m"});
  manifest.water_png_scale_m = jf::Number(json["water_png"], "scale_m", 0.0);
  manifest.octree_resolution_m = jf::Number(json, "octree_resolution_m", 0.0);
  manifest.atmosphere = DecodeAtmosphere(json["atmosphere"]);
  for (const Json& warning : jf::Array(json, "warnings")) {
    manifest.warnings.push_back(jf::Text(Json{{"warning", warning}}, "warning"));
  }
  for (const Json& stage : jf::Array(json, "stages")) {
    jf::ExpectKeys(stage, {"name", "seconds"});
    manifest.stages.push_back({jf::Text(stage, "name"), jf::Number(stage, "seconds", 0.0)});
  }
  for (const Json& file : jf::Array(json, "files")) manifest.files.push_back(DecodeFile(file));
  return manifest;
}

// The digits of the manifest's own digest within its text; npos when it has none.
std::size_t DigestOffset(std::string_view content) {
  const std::size_t key = content.rfind(kDigestKey);
  if (key == std::string_view::npos) return key;
  const std::size_t offset = key + kDigestKey.size();
  return offset + kDigestDigits <= content.size() ? offset : std::string_view::npos;
}

bool DigestMatches(std::string_view content) {
  const std::size_t offset = DigestOffset(content);
  if (offset == std::string_view::npos) return false;
  std::string zeroed(content);
  zeroed.replace(offset, kDigestDigits, kDigestDigits, '0');
  return Sha256Hex(zeroed) == content.substr(offset, kDigestDigits);
}

Result<Manifest> Decode(std::string_view content) {
  const Json json = jf::Parse(content);
  if (!json.is_object()) return DataLoss("is not an object");
  const bool has_digest = json.contains("manifest_sha256");
  if (has_digest && !DigestMatches(content)) {
    return DataLoss("its SHA-256 is not the one that it carries");
  }
  const Json version = json.value("format_version", Json());
  if (version.is_number_integer() &&
      (version < kOldestBundleFormatVersion || version > kBundleFormatVersion)) {
    return FailedPrecondition(
        "has format version " + jf::Shown(version) + "; this program reads versions " +
        std::to_string(kOldestBundleFormatVersion) + " to " + std::to_string(kBundleFormatVersion));
  }
  return DecodeFields(json);
}

}  // namespace

std::string EncodeManifest(const Manifest& manifest) {
  Json json = {
      {"format_version", kBundleFormatVersion},
      {"world_id", manifest.world_id},
      {"geo", Encode(manifest.geo)},
      {"request", Encode(manifest.request)},
      {"height_png",
       {{"scale_m", manifest.height_png_scale_m}, {"offset_m", manifest.height_png_offset_m}}},
      {"water_png", {{"scale_m", manifest.water_png_scale_m}}},
      {"octree_resolution_m", manifest.octree_resolution_m},
      {"atmosphere", Encode(manifest.atmosphere)},
      {"warnings", manifest.warnings},
      {"stages", Json::array()},
      {"files", Json::array()}};
  for (const StageTime& stage : manifest.stages) {
    json["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  }
  for (const BundleFile& file : manifest.files) json["files"].push_back(Encode(file));
  if (manifest.map_values != MapValues::kGraded) {
    json["map_values"] = std::string(NameOf(manifest.map_values));
  }
  json["manifest_sha256"] = std::string(kDigestDigits, '0');
  std::string content = jf::Dump(json);
  const std::string digest = Sha256Hex(content);
  content.replace(DigestOffset(content), kDigestDigits, digest);
  return content;
}

Result<Manifest> DecodeManifest(std::string_view content) {
  try {
    return Decode(content);
  } catch (const jf::FieldError& error) {
    return DataLoss(error.what());
  } catch (const Json::exception& error) {
    return DataLoss(error.what());
  }
}

}  // namespace latticeworld
