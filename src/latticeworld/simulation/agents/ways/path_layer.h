#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_LAYER_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_LAYER_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// How easily one class of bodies crosses each cell of a square map: 0 not at all, 1 as hard as it
// can just manage .. 255 level open ground. Row 0 is north. Made tile by tile, when a tile is first
// asked about, so that a large world costs what is walked of it.
class PathLayer {
 public:
  static constexpr int kTile = 32;  // cells a side
  using Tile = std::array<std::uint8_t, static_cast<std::size_t>(kTile) * kTile>;
  // Fills the tile whose north-west cell is (row, col), row-major; what it says of cells beyond the
  // map is not looked at.
  using Source = std::function<void(int row, int col, Tile* ease)>;

  // cells: a side. north_west: corner of cell (0, 0).
  PathLayer(int cells, double cell_m, WorldPoint north_west, Source source);

  int cells() const { return cells_; }
  double cell_m() const { return cell_m_; }
  CellIndex CellAt(WorldPoint point) const;  // may lie beyond the map
  WorldPoint CenterOf(CellIndex cell) const {
    return {north_west_.x_m + (cell.col + 0.5) * cell_m_,
            north_west_.y_m - (cell.row + 0.5) * cell_m_};
  }

  // Returns how easy the cell is; 0 beyond the map.
  std::uint8_t Ease(CellIndex cell) {
    if (cell.row < 0 || cell.row >= cells_ || cell.col < 0 || cell.col >= cells_) return 0;
    const std::unique_ptr<Tile>& tile =
        tiles_[static_cast<std::size_t>(cell.row / kTile) * tiles_a_side_ + cell.col / kTile];
    const auto in_tile = static_cast<std::size_t>(cell.row % kTile) * kTile + cell.col % kTile;
    return (tile ? *tile : Fill(cell))[in_tile];
  }
  bool IsFree(CellIndex cell) { return Ease(cell) != 0; }

  // Whether every cell that the straight way touches is free, corners included: none is cut. A body
  // that stands where it should not may first leave the cells that are not free by up to leave_m.
  // *left: share of the way [0, 1] at which it has left them.
  bool IsLineFree(WorldPoint from, WorldPoint to, double leave_m, double* left);
  // The free cell whose centre is nearest to the point among those within radius_m that pass the
  // test. False: there is none.
  bool NearestFree(WorldPoint point, double radius_m, const std::function<bool(CellIndex)>& passes,
                   CellIndex* nearest);

  // Asks the source anew for what lies in the square of half side reach_m around the point.
  void Forget(WorldPoint point, double reach_m);
  std::size_t tiles_made() const { return tiles_made_; }

 private:
  const Tile& Fill(CellIndex cell);

  int cells_;
  double cell_m_;
  WorldPoint north_west_;
  Source source_;
  int tiles_a_side_;
  std::vector<std::unique_ptr<Tile>> tiles_;  // null: not asked about
  std::size_t tiles_made_ = 0;                // since the layer was made
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_LAYER_H_
