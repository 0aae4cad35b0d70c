#ifndef LATTICEWORLD_MAPPING_OCTREE_VOXEL_PLAN_H_
#define LATTICEWORLD_MAPPING_OCTREE_VOXEL_PLAN_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "latticeworld/mapping/mapped_assets.h"
#include "latticeworld/mapping/octree/ground_voxels.h"
#include "latticeworld/mapping/octree/voxel_box.h"

namespace latticeworld {

struct OctreeOptions;
struct Scene;
struct SceneChanges;

// Tiles are squares of columns, aligned to the tree's nodes of that level (a node of level l is a
// cube of 2^l voxels a side; the root has level 16).
inline constexpr int kTileLevel = 7;
inline constexpr int kTileSide = 1 << kTileLevel;  // columns

// Everything that the tiles of one map share.
class VoxelPlan {
 public:
  // All of them legal; scene and changes need not outlive the call, but scene.terrain has to.
  VoxelPlan(const Scene& scene, const OctreeOptions& options, const SceneChanges& changes);

  // Tile t covers the columns from tile_x(t) * kTileSide and tile_y(t) * kTileSide.
  int tile_count() const { return tiles_x_ * tiles_y_; }
  int tiles_x() const { return tiles_x_; }
  int tiles_y() const { return tiles_y_; }
  int first_tile_x() const { return first_tile_x_; }
  int first_tile_y() const { return first_tile_y_; }
  int tile_x(int tile) const { return first_tile_x_ + tile % tiles_x_; }
  int tile_y(int tile) const { return first_tile_y_ + tile / tiles_x_; }

  double voxel_m() const { return voxel_m_; }
  int depth_voxels() const { return depth_voxels_; }  // of ground below its surface voxel
  const VoxelBox& world() const { return world_; }
  const VoxelBox& box() const { return box_; }            // what is mapped of it
  const GroundVoxels& ground() const { return ground_; }  // box and one column around, in the world
  const std::vector<MappedAsset>& assets() const { return assets_; }
  // Indices into assets() of those that may reach into the tile, in increasing order.
  const std::uint32_t* assets_begin(int tile) const { return binned_.data() + bin_begin_[tile]; }
  const std::uint32_t* assets_end(int tile) const { return binned_.data() + bin_begin_[tile + 1]; }

  // Calls visit(tile) for the tiles of the map that the asset may reach into.
  template <typename Visit>
  void ForEachTileOf(const MappedAsset& mapped, Visit&& visit) const;

 private:
  void BinAssets();

  double voxel_m_;
  int depth_voxels_;
  VoxelBox world_;
  VoxelBox box_;
  int first_tile_x_ = 0, first_tile_y_ = 0, tiles_x_ = 0, tiles_y_ = 0;
  GroundVoxels ground_;
  std::vector<MappedAsset> assets_;
  std::vector<std::uint32_t> bin_begin_;  // (tile_count + 1) offsets into binned_
  std::vector<std::uint32_t> binned_;
};

template <typename Visit>
void VoxelPlan::ForEachTileOf(const MappedAsset& mapped, Visit&& visit) const {
  const double reach_m = mapped.reach_m();
  // Tiles are found as assets are cut: what stands on the world's edge belongs to its last column.
  const auto tile_of = [this](double coordinate_m, int first, int count) {
    const int index = std::clamp(VoxelIndexOf(coordinate_m, voxel_m_), world_.x_low, world_.x_high);
    return std::clamp((index >> kTileLevel) - first, -1, count);
  };
  const Asset& asset = mapped.asset;
  const int x_low = std::max(tile_of(asset.x_m - reach_m, first_tile_x_, tiles_x_), 0);
  const int x_high = std::min(tile_of(asset.x_m + reach_m, first_tile_x_, tiles_x_), tiles_x_ - 1);
  const int y_low = std::max(tile_of(asset.y_m - reach_m, first_tile_y_, tiles_y_), 0);
  const int y_high = std::min(tile_of(asset.y_m + reach_m, first_tile_y_, tiles_y_), tiles_y_ - 1);
  for (int y = y_low; y <= y_high; ++y) {
    for (int x = x_low; x <= x_high; ++x) visit(y * tiles_x_ + x);
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_VOXEL_PLAN_H_
