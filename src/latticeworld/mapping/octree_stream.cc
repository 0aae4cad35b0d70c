#include "latticeworld/mapping/octree_stream.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "latticeworld/mapping/octree_bytes.h"
#include "latticeworld/mapping/tile_work.h"
#include "latticeworld/mapping/voxel_plan.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Asset and heading, in order; infinity: gone.
std::vector<std::pair<std::uint32_t, double>> FatesOf(const SceneChanges& changes) {
  std::vector<std::pair<std::uint32_t, double>> fates;
  for (const FallenTree& tree : changes.fallen) fates.emplace_back(tree.asset, tree.heading_rad);
  for (const std::uint32_t asset : changes.gone)
    fates.emplace_back(asset, std::numeric_limits<double>::infinity());
  std::sort(fates.begin(), fates.end());
  return fates;
}

// Tiles in which the two differ, in order.
std::vector<int> TilesBetween(const SceneChanges& before, const SceneChanges& after,
                              const Scene& scene, const VoxelPlan& plan) {
  const auto old_fates = FatesOf(before), new_fates = FatesOf(after);
  std::vector<std::pair<std::uint32_t, double>> changed;
  std::set_symmetric_difference(old_fates.begin(), old_fates.end(), new_fates.begin(),
                                new_fates.end(), std::back_inserter(changed));
  std::vector<int> tiles;
  for (const auto& fate : changed) {
    MappedAsset widest;  // lying it reaches farther than standing
    widest.asset = scene.assets[fate.first];
    widest.lies = true;
    plan.ForEachTileOf(widest, [&](int tile) { tiles.push_back(tile); });
  }
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

}  // namespace

OctreeStream::OctreeStream() = default;
OctreeStream::OctreeStream(OctreeStream&&) noexcept = default;
OctreeStream& OctreeStream::operator=(OctreeStream&&) noexcept = default;
OctreeStream::~OctreeStream() = default;

Result<OctreeStream> OctreeStream::Create(std::shared_ptr<const Scene> scene, Format format,
                                          const OctreeOptions& options, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, *scene));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  OctreeStream stream;
  stream.scene_ = std::move(scene);
  stream.format_ = format;
  stream.options_ = options;
  return stream;
}

Result<OctreeData> OctreeStream::Update(const SceneChanges& changes, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(changes, *scene_));
  const VoxelPlan plan(*scene_, options_, changes);
  const std::vector<int> tiles =
      bytes_ == nullptr ? AllTiles(plan) : TilesBetween(changes_, changes, *scene_, plan);
  std::unique_ptr<OctreeBytes> bytes = std::move(bytes_);
  if (bytes == nullptr) {
    bytes = std::make_unique<OctreeBytes>(
        format_ == Format::kBinary ? OctreeBytes::Format::kBinary : OctreeBytes::Format::kFull,
        octomap::OcTree(options_.resolution_m).getClampingThresMaxLog());
  }
  LW_RETURN_IF_ERROR(bytes->Write(plan, tiles, options_.threads, progress));
  bytes_ = std::move(bytes);
  changes_ = changes;
  tiles_written_ = static_cast<int>(tiles.size());
  return bytes_->Join(plan);
}

}  // namespace latticeworld
