#include "latticeworld/catalogue/asset_kind.h"

namespace latticeworld {

AssetType TypeOf(AssetKind kind) {
  switch (kind) {
    case AssetKind::kTree:
      return AssetType::kForest;
    case AssetKind::kBush:
    case AssetKind::kGrassTuft:
      return AssetType::kGrass;
    case AssetKind::kStone:
      return AssetType::kStone;
    case AssetKind::kBuilding:
      return AssetType::kArchitecture;
    case AssetKind::kDeadBranch:
      return AssetType::kDeadBranch;
    case AssetKind::kFlower:
      return AssetType::kFlower;
    case AssetKind::kCrop:
      return AssetType::kCrops;
  }
  return AssetType::kGrass;
}

bool IsSolid(AssetKind kind) {
  return kind == AssetKind::kTree || kind == AssetKind::kStone || kind == AssetKind::kBuilding;
}

}  // namespace latticeworld
