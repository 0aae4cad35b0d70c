#include "latticeworld/generation/bundle/world_id.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "latticeworld/common/digest.h"

namespace latticeworld {
namespace {

constexpr std::size_t kIdDigits = 12;

// Fields go into one buffer first: a digest call for each of a million fields would cost more than
// the hash itself, and hashing whole structs would hash their padding.
class FieldBuffer {
 public:
  template <typename T>
  void Add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "padding would go into the hash");
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  void Add(const Eigen::Vector3d& vector) {
    for (int i = 0; i < 3; ++i) Add(vector[i]);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

template <typename T>
void AddGrid(const Grid<T>& grid, Digest* digest) {
  digest->Add(grid.rows());
  digest->Add(grid.cols());
  digest->AddBytes(grid.data(), grid.size() * sizeof(T));
}

void AddBridge(const Bridge& bridge, Digest* digest) {
  digest->Add(bridge.kind);
  for (const WorldPoint point : bridge.line) {
    digest->Add(point.x_m);
    digest->Add(point.y_m);
  }
  for (const double number : {bridge.width_m, bridge.deck_z_m, bridge.thickness_m,
                              bridge.water_level_m, bridge.railing_m, bridge.load_kg}) {
    digest->Add(number);
  }
  for (const double along_m : bridge.supports_m) digest->Add(along_m);
}

void AddTerrain(const Terrain& terrain, Digest* digest) {
  digest->Add(terrain.geometry().resolution_m());
  AddGrid(terrain.ground.height_m(), digest);
  AddGrid(terrain.water_level_m, digest);
  AddGrid(terrain.surface, digest);
  for (const ClassWeight& entry : terrain.weights.classes) {
    digest->Add(entry.letter);
    AddGrid(entry.weight.levels(), digest);
  }
  for (const Bridge& bridge : terrain.bridges) AddBridge(bridge, digest);
}

// A model's index as it was before there were models of single things (Shape::kParts), which count
// from the end: worlds that hold none, with models of a user's too, keep their identities.
std::uint8_t ModelNumber(std::uint8_t model) {
  static const std::pair<int, int> things = [] {
    const std::vector<AssetModel>& models = Catalogue::BuiltIn()->models();
    const auto found = std::find_if(models.begin(), models.end(), [](const AssetModel& each) {
      return each.shape == Shape::kParts;
    });
    return std::pair(static_cast<int>(found - models.begin()), static_cast<int>(models.size()));
  }();
  const auto [first, end] = things;
  if (model < first) return model;
  return static_cast<std::uint8_t>(model < end ? 255 - (model - first) : model - (end - first));
}

std::string FieldsOf(const std::vector<Asset>& assets) {
  FieldBuffer fields;
  for (const Asset& asset : assets) {
    fields.Add(asset.kind);
    fields.Add(asset.season_variant);
    fields.Add(asset.material);
    fields.Add(ModelNumber(asset.model));
    fields.Add(asset.x_m);
    fields.Add(asset.y_m);
    fields.Add(asset.z_m);
    fields.Add(asset.yaw_rad);
    fields.Add(asset.scale);
    fields.Add(asset.height_m);
    fields.Add(asset.half_length_m);
    fields.Add(asset.half_width_m);
    fields.Add(asset.trunk_radius_m);
  }
  return fields.bytes();
}

std::string FieldsOf(const Atmosphere& atmosphere) {
  FieldBuffer fields;
  fields.Add(atmosphere.weather);
  fields.Add(atmosphere.intensity);
  fields.Add(atmosphere.visibility_m);
  fields.Add(atmosphere.rain_mmph);
  fields.Add(atmosphere.snowfall_mmph);
  fields.Add(atmosphere.cloud_cover);
  fields.Add(atmosphere.wind_mps);
  fields.Add(atmosphere.gust_mps);
  fields.Add(atmosphere.hour);
  fields.Add(atmosphere.day_of_year);
  fields.Add(atmosphere.latitude_deg);
  fields.Add(atmosphere.direct_light);
  fields.Add(atmosphere.diffuse_light);
  fields.Add(atmosphere.sun_direction);
  fields.Add(atmosphere.sun_intensity);
  fields.Add(atmosphere.ambient_intensity);
  fields.Add(atmosphere.ground_wetness);
  fields.Add(atmosphere.snow_depth_m);
  fields.Add(atmosphere.blown_sand);
  fields.Add(atmosphere.water_rise_m);
  return fields.bytes();
}

void AddAgent(const AgentStart& agent, Digest* digest) {
  digest->AddText(agent.name);
  digest->Add(agent.category);
  digest->Add(agent.state);
  digest->Add(agent.team);
  digest->Add(agent.controllable);
  digest->Add(agent.position.x_m);
  digest->Add(agent.position.y_m);
  digest->Add(agent.height_above_ground_m);
  digest->Add(agent.heading_rad);
}

void AddProp(const Prop& prop, Digest* digest) {
  digest->AddText(prop.name);
  digest->Add(prop.kind);
  digest->Add(prop.position.x_m);
  digest->Add(prop.position.y_m);
  digest->Add(prop.z_m);
  digest->Add(prop.yaw_rad);
  for (int i = 0; i < 3; ++i) digest->Add(prop.size_m[i]);
  digest->Add(prop.mass_kg);
  digest->Add(prop.strength);
}

}  // namespace

std::string ContentId(const SymbolicLayout& layout, const Scene& scene,
                      const std::optional<GeoOrigin>& geo) {
  Digest digest;
  digest.Add(layout.vocabulary);
  digest.AddText(ToText(layout));
  digest.AddText(ToJson(scene.environment));
  AddTerrain(*scene.terrain, &digest);
  for (const CatalogueFile& file : scene.catalogue->added_files()) digest.AddText(file.text);
  digest.AddText(FieldsOf(scene.assets));
  digest.AddText(FieldsOf(scene.atmosphere));
  for (const AgentStart& agent : scene.agents) AddAgent(agent, &digest);
  for (const Prop& prop : scene.props) AddProp(prop, &digest);
  for (const SceneThing& thing : scene.things) {
    digest.AddText(thing.name);
    digest.AddText(thing.kind);
    digest.Add(thing.asset);
  }
  if (geo) {
    digest.Add(geo->latitude_deg);
    digest.Add(geo->longitude_deg);
    digest.Add(geo->altitude_m);
  }
  return "world-" + digest.Hex().substr(0, kIdDigits);
}

}  // namespace latticeworld
