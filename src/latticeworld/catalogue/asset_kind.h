#ifndef LATTICEWORLD_CATALOGUE_ASSET_KIND_H_
#define LATTICEWORLD_CATALOGUE_ASSET_KIND_H_

#include <array>
#include <cstdint>

#include "latticeworld/catalogue/asset_type.h"
#include "latticeworld/common/enum_names.h"

namespace latticeworld {

// What stands in a world. Roads, lakes, deserts and snow are ground, not assets.
enum class AssetKind : std::uint8_t {
  kTree,
  kBush,
  kStone,
  kBuilding,
  kDeadBranch,
  kGrassTuft,
  kFlower,
  kCrop
};
inline constexpr int kAssetKindCount = 8;

constexpr std::array<EnumName<AssetKind>, kAssetKindCount> EnumNames(AssetKind) {
  return {{{AssetKind::kTree, "tree"},
           {AssetKind::kBush, "bush"},
           {AssetKind::kStone, "stone"},
           {AssetKind::kBuilding, "building"},
           {AssetKind::kDeadBranch, "dead_branch"},
           {AssetKind::kGrassTuft, "grass_tuft"},
           {AssetKind::kFlower, "flower"},
           {AssetKind::kCrop, "crop"}}};
}

AssetType TypeOf(AssetKind kind);
// Solid assets stop bodies and rays and are occupied in maps: trees (trunk), stones, buildings.
bool IsSolid(AssetKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_ASSET_KIND_H_
