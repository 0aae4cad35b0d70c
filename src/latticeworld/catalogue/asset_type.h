#ifndef LATTICEWORLD_CATALOGUE_ASSET_TYPE_H_
#define LATTICEWORLD_CATALOGUE_ASSET_TYPE_H_

#include <array>
#include <cstdint>

#include "latticeworld/common/enum_names.h"

namespace latticeworld {

// The eleven asset types of the method's table (the twelfth row, the height map, is the relief).
enum class AssetType : std::uint8_t {
  kGrass,
  kFlower,
  kDeadBranch,
  kStone,
  kArchitecture,
  kRoad,
  kLake,
  kDesert,
  kForest,
  kCrops,
  kSnowMountain
};
inline constexpr int kAssetTypeCount = 11;

constexpr std::array<EnumName<AssetType>, kAssetTypeCount> EnumNames(AssetType) {
  return {{{AssetType::kGrass, "grass"},
           {AssetType::kFlower, "flower"},
           {AssetType::kDeadBranch, "dead_branch"},
           {AssetType::kStone, "stone"},
           {AssetType::kArchitecture, "architecture"},
           {AssetType::kRoad, "road"},
           {AssetType::kLake, "lake"},
           {AssetType::kDesert, "desert"},
           {AssetType::kForest, "forest"},
           {AssetType::kCrops, "crops"},
           {AssetType::kSnowMountain, "snow_mountain"}}};
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_ASSET_TYPE_H_
