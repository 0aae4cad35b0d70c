#ifndef LATTICEWORLD_ENVIRONMENT_FINE_ATTRIBUTES_H_
#define LATTICEWORLD_ENVIRONMENT_FINE_ATTRIBUTES_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

// The values that one asset type can take: 49 seasonal and 37 material ones over the whole table.
struct AssetTypeValues {
  AssetType type;
  std::vector<std::string_view> season_variants;
  std::vector<std::string_view> materials;
  bool has_rotation;  // rotation_deg
  bool has_scale;     // scale
  bool has_height;    // height_m
  bool has_wind;      // wind_mps
  bool has_slope;     // slope_deg
};
const AssetTypeValues& ValuesOf(AssetType type);

// Continuous parameters that a type lacks (ValuesOf) keep their defaults and are not in the JSON.
struct FineAttribute {
  std::string season_variant;
  std::string material;
  double density = 0.5;                            // [0, 1]
  std::array<double, 3> rotation_deg = {0, 0, 0};  // Euler angles roll, pitch, yaw, [0, 360)
  double scale = 1.0;                              // [0.25, 4]
  double height_m = 0.0;                           // lake: level above its shore's low, [-5, 5]
  double wind_mps = 0.0;                           // desert: [0, 40]
  double slope_deg = 0.0;  // snow mountain: steepest snow-covered slope, [0, 90]
};

using FineAttributes = std::array<FineAttribute, kAssetTypeCount>;  // by AssetType

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_FINE_ATTRIBUTES_H_
