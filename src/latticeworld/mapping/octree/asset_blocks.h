#ifndef LATTICEWORLD_MAPPING_OCTREE_ASSET_BLOCKS_H_
#define LATTICEWORLD_MAPPING_OCTREE_ASSET_BLOCKS_H_

#include <algorithm>

#include "latticeworld/geometry/height_field.h"
#include "latticeworld/mapping/mapped_assets.h"
#include "latticeworld/mapping/traversability.h"

namespace latticeworld {

// Says where assets stop a robot: where it would touch their solid part, seen from above, or a
// crown that hangs lower than the robot is high.
class AssetBlocks {
 public:
  // ground: kept by reference.
  AssetBlocks(const HeightField& ground, const RobotLimits& limits)
      : ground_(ground), limits_(limits) {}

  // Calls block(row, col) for the cells of [row_begin, row_end) at whose centres the asset stops
  // the robot, and for the one that holds its own centre, so that thin trunks show on coarse grids.
  template <typename Block>
  void ForEachBlocked(const MappedAsset& mapped, int row_begin, int row_end, Block&& block) const {
    const Asset& asset = mapped.asset;
    if (!IsSolid(asset.kind)) return;
    // Calls block for the cells within reach_m and the robot's radius that pass the test.
    const auto block_where = [&](double reach_m, const auto& test) {
      const GridGeometry& geometry = ground_.geometry();
      reach_m += limits_.radius_m;
      const CellIndex low = geometry.CellAt({asset.x_m - reach_m, asset.y_m + reach_m});
      const CellIndex high = geometry.CellAt({asset.x_m + reach_m, asset.y_m - reach_m});
      for (int row = std::max(low.row, row_begin); row <= std::min(high.row, row_end - 1); ++row) {
        for (int col = low.col; col <= high.col; ++col)
          if (test(CellIndex{row, col})) block(row, col);
      }
    };
    if (mapped.lies) {
      block_where(mapped.reach_m(), [&](CellIndex cell) { return FallenTreeBlocks(mapped, cell); });
    } else {
      block_where(SolidRadius(asset), [&](CellIndex cell) { return SolidBlocks(asset, cell); });
      if (asset.kind == AssetKind::kTree && limits_.clearance_m > 0.0) {
        // Most crowns hang high above everything.
        const float lowest_m =
            static_cast<float>(asset.z_m + kCrownBase * asset.height_m - limits_.clearance_m);
        block_where(asset.half_length_m, [&](CellIndex cell) {
          return ground_.height_m()[cell] > lowest_m && CrownBlocks(asset, cell);
        });
      }
    }
    if (!ground_.geometry().Contains(asset.position())) return;
    const CellIndex center = ground_.geometry().CellAt(asset.position());
    if (row_begin <= center.row && center.row < row_end) block(center.row, center.col);
  }

 private:
  bool SolidBlocks(const Asset& asset, CellIndex cell) const {
    const double margin_m = std::max(limits_.radius_m, MarginOfThin_m(asset));
    return SolidContains(asset, ground_.geometry().CenterOf(cell), margin_m);
  }
  // Returns by how much a fence, which is thinner than a cell is wide, has to grow so that every
  // cell that it goes through has it.
  double MarginOfThin_m(const Asset& asset) const;
  bool CrownBlocks(const Asset& tree, CellIndex cell) const;
  bool FallenTreeBlocks(const MappedAsset& tree, CellIndex cell) const;

  const HeightField& ground_;
  RobotLimits limits_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_ASSET_BLOCKS_H_
