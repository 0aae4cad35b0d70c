#ifndef LATTICEWORLD_MAPPING_OCTREE_OCTREE_WALK_H_
#define LATTICEWORLD_MAPPING_OCTREE_OCTREE_WALK_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/mapping/octree/voxel_plan.h"
#include "latticeworld/mapping/octree/voxel_tile.h"

namespace latticeworld {

inline constexpr int kRootLevel = 16;
inline constexpr int kSideOfRoot = 1 << kRootLevel;  // voxels

// What a cube of voxels is. A full cube is one leaf, whatever its size.
enum class CubeKind : std::uint8_t { kNothing, kFull, kInner };

// A sink takes a pruned octree in the order in which its last child comes first and a node after
// its children: the reverse of octomap's streams. It has a type Node, what it knows of a cube that
// its parent needs, with a member `kind`, and
//   Node Nothing();                                  nothing is occupied
//   Node Full();                                     a leaf
//   Node Inner(const std::array<Node, 8>& children)  some of them not kNothing, not all kFull
//   Node Block(std::uint64_t mask)                   4 x 4 x 4 voxels (block_mask.h), neither
//                                                    none nor all of them
//   Node Merge()                                     the last 8 were kFull: makes one leaf of them
template <typename Sink>
typename Sink::Node MakeParent(const std::array<typename Sink::Node, 8>& children, Sink* sink) {
  int nothing = 0, full = 0;
  for (const auto& child : children) {
    nothing += child.kind == CubeKind::kNothing;
    full += child.kind == CubeKind::kFull;
  }
  if (nothing == 8) return sink->Nothing();
  if (full == 8) return sink->Merge();
  return sink->Inner(children);
}

// The cube of 2^level voxels a side at the place (x, y) of its level in the tile, from z up. From
// the top down through the tile's pyramid, so that uniform cubes are done with at once.
template <typename Sink>
typename Sink::Node WalkTile(const VoxelTile& tile, int level, int x, int y, int z, Sink* sink) {
  const ColumnBounds& bounds = tile.BoundsAt(level, x, y);
  const int end = z + (1 << level);
  if (z >= bounds.end || end <= bounds.lowest) return sink->Nothing();
  if (z >= bounds.full_from && end <= bounds.full_to) return sink->Full();
  if (level == kBlockLevel) {
    const std::uint64_t mask = tile.BlockAt(x, y, z);
    if (mask == 0) return sink->Nothing();
    if (mask == ~std::uint64_t{0}) return sink->Full();
    return sink->Block(mask);
  }
  std::array<typename Sink::Node, 8> children;
  const int half = 1 << (level - 1);
  for (int child = 7; child >= 0; --child) {
    children[child] = WalkTile(tile, level - 1, 2 * x + (child & 1), 2 * y + (child >> 1 & 1),
                               z + (child & 4 ? half : 0), sink);
  }
  return MakeParent(children, sink);
}

// A finished cube of kTileLevel, and where it is: z in units of its side.
template <typename Part>
struct TileCube {
  int z;
  Part part;
};

// The tree above the tiles: joins their cubes into the root. Sink also has
//   Node Join(const Part& part)   a cube that was made before
template <typename Part, typename Sink>
class TopWalk {
 public:
  // cubes: by tile, upward.
  TopWalk(const VoxelPlan& plan, const std::vector<std::vector<TileCube<Part>>>& cubes, Sink* sink)
      : plan_(plan), cubes_(cubes), sink_(sink) {
    for (const auto& column : cubes) {
      if (column.empty()) continue;
      z_first_ = std::min(z_first_, column.front().z);
      z_last_ = std::max(z_last_, column.back().z);
    }
  }

  typename Sink::Node Root() {
    constexpr int kFirst = -(kSideOfRoot / 2) >> kTileLevel;
    return Cube(kRootLevel, kFirst, kFirst, kFirst);
  }

 private:
  // x, y, z: lowest corner in units of tiles.
  typename Sink::Node Cube(int level, int x, int y, int z) {
    const int side = 1 << (level - kTileLevel);
    const int tile_x = x - plan_.first_tile_x(), tile_y = y - plan_.first_tile_y();
    if (z > z_last_ || z + side <= z_first_ || tile_x >= plan_.tiles_x() || tile_x + side <= 0 ||
        tile_y >= plan_.tiles_y() || tile_y + side <= 0)
      return sink_->Nothing();
    if (level == kTileLevel) {
      for (const auto& cube : cubes_[tile_y * plan_.tiles_x() + tile_x])
        if (cube.z == z) return sink_->Join(cube.part);
      return sink_->Nothing();
    }
    std::array<typename Sink::Node, 8> children;
    const int half = side / 2;
    for (int child = 7; child >= 0; --child) {
      children[child] = Cube(level - 1, x + (child & 1 ? half : 0), y + (child & 2 ? half : 0),
                             z + (child & 4 ? half : 0));
    }
    return MakeParent(children, sink_);
  }

  const VoxelPlan& plan_;
  const std::vector<std::vector<TileCube<Part>>>& cubes_;
  Sink* sink_;
  int z_first_ = kSideOfRoot, z_last_ = -kSideOfRoot;
};

// Calls visit(z) for every cube of kTileLevel of the tile that may hold something, upward.
template <typename Visit>
void ForEachTileCube(const VoxelTile& tile, Visit&& visit) {
  const ColumnBounds& bounds = tile.BoundsAt(kTileLevel, 0, 0);
  if (bounds.lowest >= bounds.end) return;
  for (int z = bounds.lowest >> kTileLevel; z <= (bounds.end - 1) >> kTileLevel; ++z) visit(z);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_OCTREE_WALK_H_
