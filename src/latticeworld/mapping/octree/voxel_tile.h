#ifndef LATTICEWORLD_MAPPING_OCTREE_VOXEL_TILE_H_
#define LATTICEWORLD_MAPPING_OCTREE_VOXEL_TILE_H_

#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/mapping/octree/asset_runs.h"
#include "latticeworld/mapping/octree/block_mask.h"
#include "latticeworld/mapping/octree/voxel_plan.h"

namespace latticeworld {

inline constexpr int kBlockLevel = 2;  // cubes of 4 x 4 x 4 voxels are 64-bit masks
inline constexpr int kBlockSide = 1 << kBlockLevel;

// Bounds over the columns of a square, in voxels along z.
struct ColumnBounds {
  int lowest = kMaxVoxel + 1;   // nothing is occupied below,
  int end = kMinVoxel;          // nor from here up
  int full_from = kMinVoxel;    // every column is ground from here
  int full_to = kMaxVoxel + 1;  // up to, not including, here; from > to: not every column is

  void Add(const ColumnBounds& other);
};

// One tile of a map: the ground of its columns as a single run each, what stands on them as sparse
// blocks, and a min-max pyramid over both. Large and reused from tile to tile.
class VoxelTile {
 public:
  VoxelTile();

  // Ground: the voxel of HeightAt(column centre), down to the plan's depth below it and to the
  // lowest neighbouring column, so that steep ground has no holes.
  void Fill(const VoxelPlan& plan, int tile);

  // Returns the bounds of a square of 2^level columns, level kBlockLevel to kTileLevel. x, y: the
  // square's place in the tile.
  const ColumnBounds& BoundsAt(int level, int x, int y) const {
    return bounds_[level][(y << (kTileLevel - level)) + x];
  }
  // The block at the place (x, y), from z up.
  std::uint64_t BlockAt(int x, int y, int z) const;

 private:
  static constexpr int kBlocks = kTileSide >> kBlockLevel;  // a side
  static constexpr int kWindow = kTileSide + 2;             // a side, with neighbours

  void SampleGround(const VoxelPlan& plan);
  void CutGround(const VoxelPlan& plan);
  void PlaceAssets(const VoxelPlan& plan, int tile);
  void BuildPyramid();

  // Assets above one block's columns: blocks at z = first * kBlockSide and up.
  struct Stack {
    int first = 0;
    int count = 0;
    std::uint32_t begin = 0;  // in stacked_
  };

  // Ground of column c of block b, at b * kBlockColumns + c: from low up to, not including, end.
  alignas(64) std::array<std::int16_t, kTileSide * kTileSide> low_;
  alignas(64) std::array<std::int16_t, kTileSide * kTileSide> end_;
  std::array<std::int16_t, kWindow * kWindow> surface_;
  std::array<std::int16_t, kWindow * kWindow> lowest_;
  std::array<std::vector<ColumnBounds>, kTileLevel + 1> bounds_;
  std::array<Stack, kBlocks * kBlocks> stacks_;
  std::vector<std::uint64_t> stacked_;
  std::vector<VoxelRun> runs_;
  int x_first_ = 0, y_first_ = 0;  // south-west column
  VoxelBox box_;                   // what is mapped of the tile
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_VOXEL_TILE_H_
