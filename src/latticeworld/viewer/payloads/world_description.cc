#include "latticeworld/viewer/payloads/world_description.h"

#include <cstdio>
#include <utility>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/rendering/looks/bridge_looks.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld/terrain/surface.h"
#include "latticeworld/viewer/payloads/json_parts.h"
#include "latticeworld/viewer/payloads/world_assets.h"
#include "latticeworld/viewer/payloads/world_grids.h"

namespace latticeworld {
namespace {

std::string HexColor(Rgb color) {
  char text[8];
  (void)std::snprintf(text, sizeof(text), "#%02x%02x%02x", color.r, color.g, color.b);
  return text;
}

template <typename Enum>
Json NamesJson() {
  Json names = Json::array();
  for (const auto& entry : EnumNames(Enum{})) names.push_back(entry.name);
  return names;
}

Json RequestJson(const GenerationRequest& request) {
  Json json;
  json["layout"] = request.layout_instruction;
  json["environment"] = request.environment_instruction;
  json["seed"] = std::to_string(request.seed);
  json["reader"] = request.reader;
  json["generator"] = request.generator;
  json["vocabulary"] = request.vocabulary;
  return json;
}

Json ClassesJson(Vocabulary vocabulary, const std::string& weighted) {
  Json classes = Json::array();
  for (const LayoutClass& entry : ClassesOf(vocabulary)) {
    Json json;
    json["letter"] = std::string(1, entry.letter);
    json["name"] = entry.name;
    json["color"] = HexColor(entry.color);
    json["weighted"] = weighted.find(entry.letter) != std::string::npos;
    classes.push_back(std::move(json));
  }
  return classes;
}

Json LayoutJson(const SymbolicLayout& layout) {
  Json rows = Json::array();
  for (int row = 0; row < layout.cells.rows(); ++row) {
    rows.push_back(std::string(layout.cells.row(row), layout.cells.cols()));
  }
  return rows;
}

Json SpeciesJson(const SpeciesCatalogue& species) {
  Json list = Json::array();
  for (const Species& entry : species.all()) {
    Json json;
    json["name"] = entry.name;
    json["category"] = NameOf(entry.category);
    json["plan"] = NameOf(entry.plan);
    json["node"] = "agent/" + entry.name;
    json["height_m"] = entry.height_m;
    json["radius_m"] = entry.radius_m;
    json["top_speed_mps"] = entry.top_speed_mps;
    json["turn_rate_radps"] = entry.turn_rate_radps;
    json["flies"] = entry.plan == BodyPlan::kFlyer;
    json["strikes"] = entry.attack_reach_m > 0.0;
    list.push_back(std::move(json));
  }
  return list;
}

Json PropKindsJson() {
  Json list = Json::array();
  for (const auto& entry : EnumNames(PropKind{})) {
    list.push_back({{"kind", entry.name}, {"node", "element/" + std::string(entry.name)}});
  }
  return list;
}

// The bridges of roads, as boxes: [x, y, z of the middle, yaw, length, width, height, red, green,
// blue].
Json BridgesJson(const Scene& scene) {
  Json list = Json::array();
  const ArtisticStyle style = scene.environment.coarse.artistic_style;
  for (const Bridge& bridge : scene.terrain->bridges) {
    Json boxes = Json::array();
    for (const BridgePart& part : PartsOf(bridge, scene.terrain->ground)) {
      const bool deck = part.kind == BridgePartKind::kDeck;
      const Color bgr = InStyle(style, ColorOfBridge(bridge.kind, part.kind, deck));
      const Eigen::Vector3d size_m = part.size_m();
      boxes.push_back({part.middle.x_m, part.middle.y_m, part.middle_z_m(), part.yaw_rad,
                       size_m.x(), size_m.y(), size_m.z(), bgr[2], bgr[1], bgr[0]});
    }
    list.push_back({{"kind", NameOf(bridge.kind)},
                    {"length_m", bridge.length_m()},
                    {"width_m", bridge.width_m},
                    {"deck_z_m", bridge.deck_z_m},
                    {"clearance_m", bridge.clearance_m()},
                    {"load_kg", bridge.load_kg},
                    {"boxes", std::move(boxes)}});
  }
  return list;
}

Json AssetsJson(const AssetTable& assets) {
  Json groups = Json::array();
  for (const AssetGroup& group : assets.groups) {
    Json json;
    json["node"] = group.node;
    json["kind"] = NameOf(group.kind);
    json["model"] = group.model;
    json["season_variant"] = group.season_variant;
    json["material"] = group.material;
    json["first"] = group.first;
    json["count"] = group.count;
    json["stretch"] = Json::array({group.wider, group.higher});
    groups.push_back(std::move(json));
  }
  Json json;
  json["count"] = assets.bytes.size() / kAssetBytes;
  json["bytes_each"] = kAssetBytes;
  json["groups"] = std::move(groups);
  return json;
}

Json HeightJson(const HeightGrid& height) {
  Json json;
  json["rows"] = height.rows;
  json["cols"] = height.cols;
  json["spacing_m"] = height.spacing_m;
  json["west_m"] = height.west_m;
  json["north_m"] = height.north_m;
  json["low_m"] = height.low_m;
  json["step_m"] = height.step_m;
  return json;
}

}  // namespace

std::string DescribeWorld(const World& world, const SpeciesCatalogue& species, bool moves,
                          const std::string& key, const HeightGrid& height,
                          const TextureGrid& texture, const AssetTable& assets,
                          const std::vector<PayloadEntry>& payloads) {
  const Terrain& terrain = *world.scene->terrain;
  Json json;
  json["protocol"] = kViewerProtocol;
  json["key"] = key;
  json["id"] = world.id;
  json["moves"] = moves;
  json["request"] = RequestJson(world.request);
  json["size_m"] = terrain.geometry().size_m();
  json["resolution_m"] = terrain.geometry().resolution_m();
  json["min_height_m"] = terrain.ground.min_m();
  json["max_height_m"] = terrain.ground.max_m();
  json["environment"] =
      Json::parse(ToJson(world.environment, *world.scene->catalogue), nullptr, false);
  json["layout"] = LayoutJson(world.layout);
  json["classes"] = ClassesJson(world.layout.vocabulary, texture.letters);
  json["surfaces"] = NamesJson<SurfaceClass>();
  json["behaviours"] = NamesJson<Behaviour>();
  json["atmosphere"] = AtmosphereJson(world.scene->atmosphere);
  json["species"] = SpeciesJson(species);
  json["elements"] = PropKindsJson();
  json["bridges"] = BridgesJson(*world.scene);
  json["assets"] = AssetsJson(assets);
  json["height"] = HeightJson(height);
  json["texture"] = {{"rows", texture.rows}, {"cols", texture.cols}};
  Json list;
  for (const PayloadEntry& entry : payloads) {
    list[entry.name] = {{"url", entry.url}, {"bytes", entry.bytes}};
  }
  json["payloads"] = std::move(list);
  return Dump(json);
}

}  // namespace latticeworld
