#include "latticeworld/viewer/payloads/world_assets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/exporting/gltf/model_library.h"
#include "latticeworld/exporting/gltf/model_mesh.h"
#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/viewer/payloads/little_endian.h"

namespace latticeworld {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;
constexpr double kCentimetresPerMetre = 100.0;

std::uint16_t YawSteps(float yaw_rad) {
  const double turns = yaw_rad / kTwoPi;
  return static_cast<std::uint16_t>(std::lround((turns - std::floor(turns)) * 65536.0) & 0xffff);
}

std::uint16_t Centimetres(float length_m) {
  return static_cast<std::uint16_t>(
      std::clamp(std::lround(length_m * kCentimetresPerMetre), 1L, 65535L));
}

void AppendAsset(const Scene& scene, std::uint32_t number, std::string* bytes) {
  const Asset& asset = scene.assets[number];
  AppendLittleEndian(asset.x_m, bytes);
  AppendLittleEndian(asset.y_m, bytes);
  AppendLittleEndian(asset.z_m, bytes);
  AppendLittleEndian(number, bytes);
  AppendLittleEndian(YawSteps(asset.yaw_rad), bytes);
  AppendLittleEndian(Centimetres(asset.half_length_m), bytes);
  AppendLittleEndian(Centimetres(asset.half_width_m), bytes);
  AppendLittleEndian(Centimetres(asset.height_m), bytes);
  const Rgb color = PartColors(scene, asset)[static_cast<std::size_t>(MainPartOf(asset.kind))];
  AppendLittleEndian(color.r, bytes);
  AppendLittleEndian(color.g, bytes);
  AppendLittleEndian(color.b, bytes);
  bytes->push_back('\0');
}

}  // namespace

AssetTable MakeAssetTable(const Scene& scene) {
  using Key = std::tuple<std::string, std::uint8_t, std::uint8_t>;
  std::map<Key, std::vector<std::uint32_t>> members;
  for (std::uint32_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    members[{ModelNameOf(scene, asset), asset.season_variant, asset.material}].push_back(i);
  }
  AssetTable table;
  table.bytes.reserve(scene.assets.size() * kAssetBytes);
  for (const auto& [key, numbers] : members) {
    const Asset& example = scene.assets[numbers.front()];
    const AssetType type = TypeOf(example.kind);
    AssetGroup group;
    group.node = std::get<0>(key);
    group.kind = example.kind;
    group.model = scene.catalogue->models()[example.model].name;
    group.season_variant = scene.catalogue->season_variants(type)[example.season_variant].name;
    group.material = scene.catalogue->materials(type)[example.material].name;
    group.first = table.bytes.size() / kAssetBytes;
    group.count = numbers.size();
    const Proportions stretch = ProportionsOf(scene.environment.coarse.artistic_style,
                                              scene.catalogue->models()[example.model]);
    group.wider = stretch.width;
    group.higher = stretch.height;
    for (const std::uint32_t number : numbers) AppendAsset(scene, number, &table.bytes);
    table.groups.push_back(std::move(group));
  }
  return table;
}

}  // namespace latticeworld
