#include "latticeworld/scene/surface_table.h"

#include <algorithm>
#include <optional>
#include <string>

namespace latticeworld {
namespace {

// The asset type whose values make a surface; none: the surface is as it is.
std::optional<AssetType> MakerOf(SurfaceClass surface) {
  switch (surface) {
    case SurfaceClass::kGrass:
      return AssetType::kGrass;
    case SurfaceClass::kForestFloor:
      return AssetType::kForest;
    case SurfaceClass::kFarmland:
      return AssetType::kCrops;
    case SurfaceClass::kBarren:
      return AssetType::kDesert;
    case SurfaceClass::kRoad:
      return AssetType::kRoad;
    case SurfaceClass::kBuilding:
      return std::nullopt;  // walls and roofs make no floor
    case SurfaceClass::kRock:
      return AssetType::kStone;
    case SurfaceClass::kSnow:
      return AssetType::kSnowMountain;
    case SurfaceClass::kWaterBed:
      return AssetType::kLake;
  }
  return std::nullopt;
}

void Apply(const GroundEffect& effect, SurfaceProperties* properties) {
  properties->friction *= effect.friction;
  properties->rolling_resistance *= effect.rolling_resistance;
  // Paving stays paving unless the effect is what makes it loose.
  properties->cone_index_kpa =
      std::min(kHardConeIndex_kPa, properties->cone_index_kpa * effect.cone_index);
}

// The entry of that name, nullptr: none.
template <typename Value>
const Value* Find(const std::vector<Value>& values, const std::string& name) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&name](const Value& value) { return value.name == name; });
  return found == values.end() ? nullptr : &*found;
}

}  // namespace

SurfaceTable::SurfaceTable(const Scene& scene, const GroundState& ground) {
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    SurfaceProperties dry = DryPropertiesOf(entry.value);
    if (const std::optional<AssetType> maker = MakerOf(entry.value)) {
      const FineAttribute& fine = scene.environment.fine_of(*maker);
      const SeasonVariant* season =
          Find(scene.catalogue->season_variants(*maker), fine.season_variant);
      // Ice floats on a frozen lake; its bed is as in summer.
      const bool is_bed = entry.value == SurfaceClass::kWaterBed;
      if (season != nullptr && !is_bed) Apply(season->ground, &dry);
      const Material* material = Find(scene.catalogue->materials(*maker), fine.material);
      if (material != nullptr) Apply(material->ground, &dry);
    }
    properties_[static_cast<std::size_t>(entry.value)] = Weathered(entry.value, dry, ground);
  }
}

}  // namespace latticeworld
