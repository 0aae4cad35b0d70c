#include "latticeworld/mapping/octree/voxel_tile.h"

#include <algorithm>

namespace latticeworld {
namespace {

using Bottoms = std::array<std::array<std::uint64_t, 5>, kBlockColumns>;
constexpr Bottoms MakeBottoms() {
  Bottoms bottoms = {};
  for (int column = 0; column < kBlockColumns; ++column) {
    for (int layers = 0; layers <= 4; ++layers)
      bottoms[column][layers] = BottomOfColumn(column, layers);
  }
  return bottoms;
}
constexpr Bottoms kBottoms = MakeBottoms();

}  // namespace

void ColumnBounds::Add(const ColumnBounds& other) {
  lowest = std::min(lowest, other.lowest);
  end = std::max(end, other.end);
  full_from = std::max(full_from, other.full_from);
  full_to = std::min(full_to, other.full_to);
}

VoxelTile::VoxelTile() {
  for (int level = kBlockLevel; level <= kTileLevel; ++level)
    bounds_[level].resize(std::size_t{1} << (2 * (kTileLevel - level)));
}

void VoxelTile::Fill(const VoxelPlan& plan, int tile) {
  x_first_ = plan.tile_x(tile) * kTileSide;
  y_first_ = plan.tile_y(tile) * kTileSide;
  box_ = plan.box();
  box_.x_low = std::max(box_.x_low, x_first_);
  box_.x_high = std::min(box_.x_high, x_first_ + kTileSide - 1);
  box_.y_low = std::max(box_.y_low, y_first_);
  box_.y_high = std::min(box_.y_high, y_first_ + kTileSide - 1);
  SampleGround(plan);
  CutGround(plan);
  PlaceAssets(plan, tile);
  BuildPyramid();
}

void VoxelTile::SampleGround(const VoxelPlan& plan) {
  const VoxelBox& world = plan.world();
  const int x_low = std::max(box_.x_low - 1, world.x_low);
  const int x_high = std::min(box_.x_high + 1, world.x_high);
  const int y_low = std::max(box_.y_low - 1, world.y_low);
  const int y_high = std::min(box_.y_high + 1, world.y_high);
  const auto at = [this](std::array<std::int16_t, kWindow * kWindow>& window, int x, int y) {
    return window.data() + (y - y_first_ + 1) * kWindow + x - x_first_ + 1;
  };
  for (int y = y_low; y <= y_high; ++y)
    plan.ground().SampleRow(y, x_low, x_high, at(surface_, x_low, y));

  // The lowest of each column and its eight neighbours: along y, then in place along x.
  const int count = x_high - x_low + 1;
  for (int y = box_.y_low; y <= box_.y_high; ++y) {
    const std::int16_t* here = at(surface_, x_low, y);
    const std::int16_t* south = y > y_low ? here - kWindow : here;
    const std::int16_t* north = y < y_high ? here + kWindow : here;
    std::int16_t column[kWindow + 2];  // with the ends twice
    for (int x = 0; x < count; ++x) column[x + 1] = std::min(std::min(south[x], here[x]), north[x]);
    column[0] = column[1];
    column[count + 1] = column[count];
    std::int16_t* lowest = at(lowest_, x_low, y);
    for (int x = 0; x < count; ++x)
      lowest[x] = std::min(std::min(column[x], column[x + 1]), column[x + 2]);
  }
}

void VoxelTile::CutGround(const VoxelPlan& plan) {
  const bool whole =
      box_.x_high - box_.x_low == kTileSide - 1 && box_.y_high - box_.y_low == kTileSide - 1;
  if (!whole) {
    low_.fill(0);
    end_.fill(0);  // columns outside the box are empty
  }
  const int depth = plan.depth_voxels(), z_low = box_.z_low, z_end = box_.z_high + 1;
  const int x_low = box_.x_low - x_first_, x_high = box_.x_high - x_first_;
  for (int y = box_.y_low - y_first_; y <= box_.y_high - y_first_; ++y) {
    const std::int16_t* surface = surface_.data() + (y + 1) * kWindow + 1;
    const std::int16_t* lowest = lowest_.data() + (y + 1) * kWindow + 1;
    std::int16_t low[kTileSide], end[kTileSide];
    for (int x = x_low; x <= x_high; ++x) {
      const int bottom = std::max(std::min<int>(surface[x] - depth, lowest[x]), z_low);
      const int top = std::min<int>(surface[x] + 1, z_end);
      low[x] = static_cast<std::int16_t>(std::min(bottom, top));
      end[x] = static_cast<std::int16_t>(top);
    }
    const int row = (y >> kBlockLevel) * kBlocks * kBlockColumns + MortonColumn(0, y);
    for (int x = x_low; x <= x_high; ++x) {
      const int at = row + (x >> kBlockLevel) * kBlockColumns + MortonColumn(x, 0);
      low_[at] = low[x];
      end_[at] = end[x];
    }
  }
}

void VoxelTile::PlaceAssets(const VoxelPlan& plan, int tile) {
  const SurfaceWindow window = {box_, surface_.data(), kWindow, x_first_ - 1, y_first_ - 1};
  const AssetCutter cutter(plan.voxel_m(), plan.world());
  runs_.clear();
  for (const std::uint32_t* i = plan.assets_begin(tile); i != plan.assets_end(tile); ++i)
    cutter.Cut(plan.assets()[*i], window, &runs_);

  // How high the blocks above each block's columns reach, and then the blocks.
  stacks_.fill(Stack());
  const auto block_of = [this](const VoxelRun& run) {
    return ((run.y - y_first_) >> kBlockLevel) * kBlocks + ((run.x - x_first_) >> kBlockLevel);
  };
  for (const VoxelRun& run : runs_) {
    Stack& stack = stacks_[block_of(run)];
    const int first = run.low >> kBlockLevel, last = run.high >> kBlockLevel;
    if (stack.count == 0) {
      stack.first = first;
      stack.count = last - first + 1;
    } else {
      const int low = std::min(stack.first, first);
      stack.count = std::max(stack.first + stack.count - 1, last) - low + 1;
      stack.first = low;
    }
  }
  std::uint32_t count = 0;
  for (Stack& stack : stacks_) {
    stack.begin = count;
    count += static_cast<std::uint32_t>(stack.count);
  }
  stacked_.assign(count, 0);
  for (const VoxelRun& run : runs_) {
    const Stack& stack = stacks_[block_of(run)];
    const auto& bottoms = kBottoms[MortonColumn(run.x, run.y)];
    for (int z = run.low >> kBlockLevel; z <= run.high >> kBlockLevel; ++z) {
      const int from = std::max(run.low - z * kBlockSide, 0);
      const int to = std::min(run.high + 1 - z * kBlockSide, 4);
      stacked_[stack.begin + (z - stack.first)] |= bottoms[to] & ~bottoms[from];
    }
  }
}

void VoxelTile::BuildPyramid() {
  // A block's bounds are those of its columns.
  for (int block = 0; block < kBlocks * kBlocks; ++block) {
    const std::int16_t* low = low_.data() + block * kBlockColumns;
    const std::int16_t* end = end_.data() + block * kBlockColumns;
    std::int16_t lowest = low[0], full_from = low[0], highest = end[0], full_to = end[0];
    bool any_empty = false;
    for (int c = 0; c < kBlockColumns; ++c) {
      lowest = std::min(lowest, low[c]);
      full_from = std::max(full_from, low[c]);
      highest = std::max(highest, end[c]);
      full_to = std::min(full_to, end[c]);
      any_empty |= low[c] == end[c];
    }
    ColumnBounds& bounds = bounds_[kBlockLevel][block];
    bounds = {lowest, highest, full_from, full_to};
    if (any_empty) {
      // Empty columns are no bound from below or above, and fill nothing.
      bounds = {kMaxVoxel + 1, kMinVoxel, kMaxVoxel + 1, kMinVoxel};
      for (int c = 0; c < kBlockColumns; ++c) {
        if (low[c] == end[c]) continue;
        bounds.lowest = std::min<int>(bounds.lowest, low[c]);
        bounds.end = std::max<int>(bounds.end, end[c]);
      }
    }
    // Assets above the columns widen the bounds.
    const Stack& stack = stacks_[block];
    if (stack.count > 0) {
      bounds.lowest = std::min(bounds.lowest, stack.first * kBlockSide);
      bounds.end = std::max(bounds.end, (stack.first + stack.count) * kBlockSide);
    }
  }
  // Each level joins four squares of the one below.
  for (int level = kBlockLevel + 1; level <= kTileLevel; ++level) {
    const int side = 1 << (kTileLevel - level);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        ColumnBounds bounds = BoundsAt(level - 1, 2 * x, 2 * y);
        bounds.Add(BoundsAt(level - 1, 2 * x + 1, 2 * y));
        bounds.Add(BoundsAt(level - 1, 2 * x, 2 * y + 1));
        bounds.Add(BoundsAt(level - 1, 2 * x + 1, 2 * y + 1));
        bounds_[level][y * side + x] = bounds;
      }
    }
  }
}

std::uint64_t VoxelTile::BlockAt(int x, int y, int z) const {
  const int block = y * kBlocks + x;
  std::uint64_t mask =
      BlockOfColumns(low_.data() + block * kBlockColumns, end_.data() + block * kBlockColumns, z);
  const Stack& stack = stacks_[block];
  const int at = (z >> kBlockLevel) - stack.first;
  if (at >= 0 && at < stack.count) mask |= stacked_[stack.begin + at];
  return mask;
}

}  // namespace latticeworld
