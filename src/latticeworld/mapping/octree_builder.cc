#include "latticeworld/mapping/octree_builder.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {
namespace {

constexpr int kRootLevel = 16;  // a node of level l is a cube of 2^l voxels a side
constexpr int kBlockLevel = 2;  // cubes of 4 x 4 x 4 voxels are 64-bit masks

// octomap makes a root only together with a leaf of full depth.
class RootedOcTree final : public octomap::OcTree {
 public:
  explicit RootedOcTree(double resolution_m) : octomap::OcTree(resolution_m) {
    root = new octomap::OcTreeNode();
    ++tree_size;
    size_changed = true;
    root->setLogOdds(getClampingThresMaxLog());
  }
};

// Bounds over the columns of one square.
struct Bounds {
  std::uint16_t lowest = 65535;     // of any interval
  std::uint16_t highest = 0;        // of any interval
  std::uint16_t ground_from = 0;    // every column is occupied from here
  std::uint16_t ground_to = 65535;  // to here; from > to: not every column is

  void Add(const Bounds& other) {
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
    ground_from = std::max(ground_from, other.ground_from);
    ground_to = std::min(ground_to, other.ground_to);
  }
};
constexpr Bounds kNoColumn = {65535, 0, 65535, 0};

// Bounds of the squares of one level, aligned to the keys.
struct BoundsLevel {
  int first = 0;  // square index (key >> level) of squares(0, 0)
  Grid<Bounds> squares;

  Bounds At(int x, int y) const {
    const CellIndex cell = {y - first, x - first};
    return squares.Contains(cell) ? squares[cell] : kNoColumn;
  }
};

std::array<BoundsLevel, kRootLevel + 1> MakePyramid(const VoxelColumns& columns) {
  const auto make_level = [&](int level) {
    const int first = columns.first_key >> level;
    const int count = ((columns.first_key + columns.columns - 1) >> level) - first + 1;
    return BoundsLevel{first, Grid<Bounds>(count, count)};
  };
  std::array<BoundsLevel, kRootLevel + 1> pyramid;
  pyramid[0] = make_level(0);
  for (int y = 0; y < columns.columns; ++y) {
    for (int x = 0; x < columns.columns; ++x) {
      const std::size_t column = columns.IndexOf(x, y);
      const VoxelInterval& ground = columns.intervals[columns.begin[column]];
      pyramid[0].squares(y, x) = {ground.low, columns.intervals[columns.begin[column + 1] - 1].high,
                                  ground.low, ground.high};
    }
  }
  for (int level = 1; level <= kRootLevel; ++level) {
    pyramid[level] = make_level(level);
    BoundsLevel& coarse = pyramid[level];
    const BoundsLevel& fine = pyramid[level - 1];
    for (int y = 0; y < coarse.squares.rows(); ++y) {
      for (int x = 0; x < coarse.squares.cols(); ++x) {
        Bounds& bounds = coarse.squares(y, x);
        for (int child = 0; child < 4; ++child)
          bounds.Add(
              fine.At(2 * (coarse.first + x) + (child & 1), 2 * (coarse.first + y) + (child >> 1)));
      }
    }
  }
  return pyramid;
}

// The bits of a block's mask are in Morton order, so that each byte is one of its eight octants.
int MortonBit(int x, int y, int z) {
  const auto octant = [&](int bit) {
    return ((x >> bit) & 1) | ((y >> bit) & 1) << 1 | ((z >> bit) & 1) << 2;
  };
  return octant(1) * 8 + octant(0);
}

// A node that is made only once something below it is occupied.
struct Slot {
  Slot* parent;
  unsigned int child;
  octomap::OcTreeNode* node;
};

class TreeBuilder {
 public:
  TreeBuilder(const VoxelColumns& columns, double voxel_m, const Progress& progress)
      : columns_(columns),
        progress_(progress),
        pyramid_(MakePyramid(columns)),
        tree_(std::make_shared<RootedOcTree>(voxel_m)),
        occupied_(tree_->getClampingThresMaxLog()) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        for (int column_mask = 0; column_mask < 16; ++column_mask) {
          std::uint64_t& bits = bits_[y * 4 + x][column_mask];
          for (int z = 0; z < 4; ++z)
            if (column_mask >> z & 1) bits |= std::uint64_t{1} << MortonBit(x, y, z);
        }
      }
    }
  }

  Result<std::shared_ptr<const octomap::OcTree>> Build() {
    Slot root = {nullptr, 0, tree_->getRoot()};
    Descend(kRootLevel, 0, 0, 0, &root);
    LW_RETURN_IF_ERROR(progress_.CheckCancelled());
    return std::shared_ptr<const octomap::OcTree>(tree_);
  }

 private:
  octomap::OcTreeNode* NodeOf(Slot* slot) {
    if (slot->node == nullptr) slot->node = MakeChild(NodeOf(slot->parent), slot->child);
    return slot->node;
  }
  octomap::OcTreeNode* MakeChild(octomap::OcTreeNode* parent, unsigned int child) {
    octomap::OcTreeNode* node = tree_->createNodeChild(parent, child);
    node->setLogOdds(occupied_);
    return node;
  }

  // The cube of 2^level voxels whose lowest corner is at the keys x, y, z.
  void Descend(int level, int x, int y, int z, Slot* slot) {
    const Bounds bounds = pyramid_[level].At(x >> level, y >> level);
    const int top = z + (1 << level) - 1;
    if (z > bounds.highest || top < bounds.lowest) return;
    if (z >= bounds.ground_from && top <= bounds.ground_to) {
      NodeOf(slot);
      return;
    }
    if (level == kBlockLevel) {
      BuildBlock(MaskOfBlock(x, y, z), slot);
      return;
    }
    if (level == kCancelLevel && progress_.cancelled()) return;
    const int half = 1 << (level - 1);
    for (unsigned int child = 0; child < 8; ++child) {
      Slot child_slot = {slot, child, nullptr};
      Descend(level - 1, x + (child & 1 ? half : 0), y + (child & 2 ? half : 0),
              z + (child & 4 ? half : 0), &child_slot);
    }
    // Ground and assets together may fill a cube that neither fills alone.
    if (slot->node != nullptr) tree_->pruneNode(slot->node);
  }

  std::uint64_t MaskOfBlock(int x, int y, int z) const {
    std::uint64_t mask = 0;
    const int x_low = std::max(x - columns_.first_key, 0);
    const int y_low = std::max(y - columns_.first_key, 0);
    const int x_high = std::min(x + 3 - columns_.first_key, columns_.columns - 1);
    const int y_high = std::min(y + 3 - columns_.first_key, columns_.columns - 1);
    for (int cy = y_low; cy <= y_high; ++cy) {
      for (int cx = x_low; cx <= x_high; ++cx) {
        const std::size_t column = columns_.IndexOf(cx, cy);
        unsigned int column_mask = 0;
        for (std::size_t i = columns_.begin[column]; i < columns_.begin[column + 1]; ++i) {
          const int low = columns_.intervals[i].low - z, high = columns_.intervals[i].high - z;
          if (high < 0) continue;
          if (low > 3) break;
          column_mask |= (0xFu << std::max(low, 0)) & (0xFu >> (3 - std::min(high, 3)));
        }
        mask |= bits_[(cy + columns_.first_key - y) * 4 + cx + columns_.first_key - x][column_mask];
      }
    }
    return mask;
  }

  void BuildBlock(std::uint64_t mask, Slot* slot) {
    if (mask == 0) return;
    octomap::OcTreeNode* block = NodeOf(slot);
    if (mask == ~std::uint64_t{0}) return;
    for (unsigned int child = 0; child < 8; ++child) {
      const unsigned int octant = mask >> (8 * child) & 0xFF;
      if (octant == 0) continue;
      octomap::OcTreeNode* node = MakeChild(block, child);
      if (octant == 0xFF) continue;
      for (unsigned int voxel = 0; voxel < 8; ++voxel)
        if (octant >> voxel & 1) MakeChild(node, voxel);
    }
  }

  static constexpr int kCancelLevel = 7;  // cubes of 128 voxels: asked some hundred times a world

  const VoxelColumns& columns_;
  const Progress& progress_;
  const std::array<BoundsLevel, kRootLevel + 1> pyramid_;
  std::shared_ptr<RootedOcTree> tree_;
  const float occupied_;
  // Of column y * 4 + x of a block and its four voxels from the lowest bit up: bits in the mask.
  std::array<std::array<std::uint64_t, 16>, 16> bits_ = {};
};

}  // namespace

Result<std::shared_ptr<const octomap::OcTree>> BuildTree(const VoxelColumns& columns,
                                                         double voxel_m, const Progress& progress) {
  return TreeBuilder(columns, voxel_m, progress).Build();
}

}  // namespace latticeworld
