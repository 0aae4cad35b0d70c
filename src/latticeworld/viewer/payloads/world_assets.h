#ifndef LATTICEWORLD_VIEWER_PAYLOADS_WORLD_ASSETS_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_WORLD_ASSETS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/catalogue/asset_kind.h"

namespace latticeworld {

struct Scene;

inline constexpr std::size_t kAssetBytes = 28;  // of one thing in AssetTable::bytes

// Things of one mesh.
struct AssetGroup {
  std::string node;  // of the model library
  AssetKind kind = AssetKind::kTree;
  std::string model, season_variant, material;  // names of the catalogue
  std::size_t first = 0, count = 0;             // in AssetTable
  float wider = 1.0f, higher = 1.0f;            // than they are, in the world's style
};

// What stands in a world, group after group: docs/viewer.md has the bytes.
struct AssetTable {
  std::vector<AssetGroup> groups;  // sorted by node, seasonal variant, material
  std::string bytes;               // kAssetBytes a thing; within a group by the asset's number
};
AssetTable MakeAssetTable(const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_WORLD_ASSETS_H_
