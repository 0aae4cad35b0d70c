#include "latticeworld/language/reading/things/sentence_assets.h"

#include <utility>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

constexpr std::pair<std::string_view, AssetType> kAssets[] = {
    {"grass", AssetType::kGrass},
    {"flowers", AssetType::kFlower},
    {"branches", AssetType::kDeadBranch},
    {"stones", AssetType::kStone},
    {"buildings", AssetType::kArchitecture},
    {"roads", AssetType::kRoad},
    {"lake", AssetType::kLake},
    {"desert", AssetType::kDesert},
    {"forest", AssetType::kForest},
    {"crops", AssetType::kCrops},
    {"snow", AssetType::kSnowMountain},
};

}  // namespace

AssetType AssetOf(std::string_view word) {
  for (const auto& [name, asset] : kAssets)
    if (name == word) return asset;
  LW_CHECK(false, "every asset of the small language has its type");
  return AssetType::kGrass;
}

std::string_view AssetWord(AssetType asset) {
  for (const auto& [name, type] : kAssets)
    if (type == asset) return name;
  LW_CHECK(false, "every asset type has its word in the small language");
  return "";
}

}  // namespace latticeworld
