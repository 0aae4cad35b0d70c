#include "latticeworld/mapping/octree/voxel_plan.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/prop_boxes.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// The ground of a column depends on its neighbours.
VoxelBox WithNeighbours(const VoxelBox& box, const VoxelBox& world) {
  VoxelBox wider = box;
  wider.x_low = std::max(box.x_low - 1, world.x_low);
  wider.x_high = std::min(box.x_high + 1, world.x_high);
  wider.y_low = std::max(box.y_low - 1, world.y_low);
  wider.y_high = std::min(box.y_high + 1, world.y_high);
  return wider;
}

}  // namespace

VoxelPlan::VoxelPlan(const Scene& scene, const OctreeOptions& options, const SceneChanges& changes)
    : voxel_m_(options.resolution_m),
      depth_voxels_(static_cast<int>(std::ceil(options.thickness_m / options.resolution_m))),
      world_(VoxelsOfWorld(scene, options.resolution_m)),
      box_(VoxelsToMap(scene, options)),
      ground_(scene.terrain->ground, options.resolution_m, WithNeighbours(box_, world_)),
      assets_(AssetsToMap(scene, changes)) {
  const std::shared_ptr<const StandingProps> props = PropsIn(scene, changes);
  for (const PropBlock& block : props->blocks) {
    assets_.push_back(BoxOf(block, 0.5 * voxel_m_));
  }
  for (const PropBlock& block : props->below) {
    assets_.push_back(BoxOf(block, 0.5 * voxel_m_));
  }
  for (const PropDeck& deck : props->decks) assets_.push_back(BoxOf(deck, 0.5 * voxel_m_));
  if (!box_.empty()) {
    first_tile_x_ = box_.x_low >> kTileLevel;
    first_tile_y_ = box_.y_low >> kTileLevel;
    tiles_x_ = (box_.x_high >> kTileLevel) - first_tile_x_ + 1;
    tiles_y_ = (box_.y_high >> kTileLevel) - first_tile_y_ + 1;
  }
  BinAssets();
}

void VoxelPlan::BinAssets() {
  bin_begin_.assign(tile_count() + 1, 0);
  for (const MappedAsset& asset : assets_)
    ForEachTileOf(asset, [&](int tile) { ++bin_begin_[tile + 1]; });
  for (int tile = 0; tile < tile_count(); ++tile) bin_begin_[tile + 1] += bin_begin_[tile];
  binned_.resize(bin_begin_.back());
  std::vector<std::uint32_t> next(bin_begin_.begin(), bin_begin_.end() - 1);
  for (std::size_t i = 0; i < assets_.size(); ++i)
    ForEachTileOf(assets_[i],
                  [&](int tile) { binned_[next[tile]++] = static_cast<std::uint32_t>(i); });
}

}  // namespace latticeworld
