#include "latticeworld/generation/bundle/bridges_json.h"

#include <cmath>

#include "latticeworld/generation/bundle/json_array.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;

constexpr double kHighest_m = 1e5;
constexpr double kHeaviest_kg = 1e6;
constexpr double kLeastPiece_m = 1e-3;     // of a line
constexpr std::size_t kMaxBridges = 1024;  // as many as a layout has cells
constexpr std::size_t kMaxPlaces = 4096;   // of a line
constexpr std::size_t kMaxBytes = 8 << 20;

jf::Json Encode(const Bridge& bridge) {
  jf::Json line = jf::Json::array(), supports = jf::Json::array();
  for (const WorldPoint point : bridge.line)
    line.push_back({{"x_m", point.x_m}, {"y_m", point.y_m}});
  for (const double along_m : bridge.supports_m) supports.push_back(along_m);
  return {{"kind", NameOf(bridge.kind)},       {"line", std::move(line)},
          {"width_m", bridge.width_m},         {"deck_z_m", bridge.deck_z_m},
          {"thickness_m", bridge.thickness_m}, {"water_level_m", bridge.water_level_m},
          {"railing_m", bridge.railing_m},     {"load_kg", bridge.load_kg},
          {"supports_m", std::move(supports)}, {"clearance_m", bridge.clearance_m()}};
}

void DecodeLine(const jf::Json& json, const GridGeometry& geometry, Bridge* bridge) {
  const jf::Json& line = jf::Array(json, "line");
  if (line.size() < 2 || line.size() > kMaxPlaces) {
    jf::Fail("line", line, "2 to " + std::to_string(kMaxPlaces) + " places");
  }
  const double half_m = geometry.half_size_m();
  for (const jf::Json& place : line) {
    jf::ExpectKeys(place, {"x_m", "y_m"});
    const WorldPoint point{jf::Number(place, "x_m", -half_m, half_m),
                           jf::Number(place, "y_m", -half_m, half_m)};
    if (!bridge->line.empty() && std::hypot(point.x_m - bridge->line.back().x_m,
                                            point.y_m - bridge->line.back().y_m) < kLeastPiece_m) {
      jf::Fail("line", line, "places that are apart from each other");
    }
    bridge->line.push_back(point);
  }
}

void DecodeSupports(const jf::Json& json, Bridge* bridge) {
  const jf::Json& supports = jf::Array(json, "supports_m");
  double least_m = 0.0;
  for (const jf::Json& entry : supports) {
    if (!entry.is_number() || !(entry.get<double>() >= least_m) ||
        entry.get<double>() > bridge->length_m() + kLeastPiece_m) {
      jf::Fail("supports_m", entry, "a number along the line, not below the one before");
    }
    least_m = entry.get<double>();
    bridge->supports_m.push_back(least_m);
  }
  if (supports.size() < 2 || supports.size() > kMaxPlaces) {
    jf::Fail("supports_m", supports, "2 to " + std::to_string(kMaxPlaces) + " numbers");
  }
}

// clearance_m follows from the rest: it is written for who reads the file, and looked at only for
// whether it agrees. Files of before do not have it.
void CheckClearance(const jf::Json& json, const Bridge& bridge) {
  constexpr double kAgreement_m = 1e-6;
  if (!json.contains("clearance_m")) return;
  if (std::abs(jf::Number(json, "clearance_m") - bridge.clearance_m()) > kAgreement_m) {
    jf::Fail("clearance_m", json.at("clearance_m"),
             FormatDouble(bridge.clearance_m()) + ", deck_z_m - thickness_m - water_level_m");
  }
}

Bridge Decode(const jf::Json& json, const GridGeometry& geometry) {
  jf::Json fields = json;
  fields.erase("clearance_m");
  jf::ExpectKeys(fields, {"kind", "line", "width_m", "deck_z_m", "thickness_m", "water_level_m",
                          "railing_m", "load_kg", "supports_m"});
  Bridge bridge;
  bridge.kind = jf::Named<BridgeKind>(json, "kind");
  bridge.width_m = jf::Number(json, "width_m", 0.1, 100.0);
  bridge.deck_z_m = jf::Number(json, "deck_z_m", -kHighest_m, kHighest_m);
  bridge.thickness_m = jf::Number(json, "thickness_m", 0.01, 10.0);
  bridge.water_level_m = jf::Number(json, "water_level_m", -kHighest_m, kHighest_m);
  bridge.railing_m = jf::Number(json, "railing_m", 0.0, 10.0);
  bridge.load_kg = jf::Number(json, "load_kg", 0.0, kHeaviest_kg);
  DecodeLine(json, geometry, &bridge);
  DecodeSupports(json, &bridge);
  CheckClearance(json, bridge);
  return bridge;
}

}  // namespace

std::string EncodeBridges(const std::vector<Bridge>& bridges) {
  return jf::EncodeArray(bridges, Encode);
}

Result<std::vector<Bridge>> DecodeBridges(std::string_view content, const GridGeometry& geometry) {
  return jf::DecodeArray<Bridge>(content, {"bridge", kMaxBytes, kMaxBridges},
                                 [&](const jf::Json& entry) { return Decode(entry, geometry); });
}

}  // namespace latticeworld
