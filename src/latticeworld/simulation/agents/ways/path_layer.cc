#include "latticeworld/simulation/agents/ways/path_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "latticeworld/common/check.h"

namespace latticeworld {

PathLayer::PathLayer(int cells, double cell_m, WorldPoint north_west, Source source)
    : cells_(cells),
      cell_m_(cell_m),
      north_west_(north_west),
      source_(std::move(source)),
      tiles_a_side_((cells + kTile - 1) / kTile),
      tiles_(static_cast<std::size_t>(tiles_a_side_) * tiles_a_side_) {
  LW_CHECK(cells > 0 && cell_m > 0.0 && source_ != nullptr, "a layer has cells and knows them");
}

CellIndex PathLayer::CellAt(WorldPoint point) const {
  // The index is clamped so that it is far beyond any map and still fits an int.
  const auto index = [this](double offset_m) {
    const double cell = std::floor(offset_m / cell_m_);
    if (!(cell > -1e6)) return -1000000;  // NaN too
    return static_cast<int>(std::min(cell, 1e6));
  };
  return {index(north_west_.y_m - point.y_m), index(point.x_m - north_west_.x_m)};
}

const PathLayer::Tile& PathLayer::Fill(CellIndex cell) {
  const int row = cell.row / kTile, col = cell.col / kTile;
  std::unique_ptr<Tile>& tile = tiles_[static_cast<std::size_t>(row) * tiles_a_side_ + col];
  tile = std::make_unique<Tile>();
  source_(row * kTile, col * kTile, tile.get());
  ++tiles_made_;
  return *tile;
}

bool PathLayer::IsLineFree(WorldPoint from, WorldPoint to, double leave_m, double* left) {
  *left = 0.0;
  // Places are in cells, south and east, so that cell (row, col) is [row, row + 1) x [col, col +
  // 1).
  const double row = (north_west_.y_m - from.y_m) / cell_m_;
  const double col = (from.x_m - north_west_.x_m) / cell_m_;
  const double rows = (from.y_m - to.y_m) / cell_m_, cols = (to.x_m - from.x_m) / cell_m_;
  const double leave_share = leave_m / std::max(1e-9, cell_m_ * std::hypot(rows, cols));
  const CellIndex last = CellAt(to);
  CellIndex cell = CellAt(from);
  bool leaving = leave_m > 0.0;

  // The line is walked from border to border (Amanatides and Woo 1987, A fast voxel traversal
  // algorithm). next_row and next_col are the shares of the way at which the next border of rows
  // and of columns is crossed.
  const int row_step = rows > 0.0 ? 1 : -1, col_step = cols > 0.0 ? 1 : -1;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double per_row = rows != 0.0 ? 1.0 / std::abs(rows) : kNever;
  const double per_col = cols != 0.0 ? 1.0 / std::abs(cols) : kNever;
  double next_row = kNever, next_col = kNever;
  if (rows != 0.0) next_row = (cell.row + (row_step > 0 ? 1 : 0) - row) / rows;
  if (cols != 0.0) next_col = (cell.col + (col_step > 0 ? 1 : 0) - col) / cols;
  int steps = std::abs(last.row - cell.row) + std::abs(last.col - cell.col);
  double share = 0.0;
  while (true) {
    if (IsFree(cell)) {
      leaving = false;
    } else if (!leaving || share > leave_share) {
      return false;
    }
    if (steps <= 0) break;
    share = std::min(next_row, next_col);
    if (leaving) *left = std::min(share, 1.0);
    constexpr double kSame = 1e-9;
    if (std::abs(next_row - next_col) < kSame && steps >= 2) {
      // Through a corner: what lies beside it is touched as well.
      if (!leaving &&
          (!IsFree({cell.row + row_step, cell.col}) || !IsFree({cell.row, cell.col + col_step})))
        return false;
      cell.row += row_step;
      cell.col += col_step;
      next_row += per_row;
      next_col += per_col;
      steps -= 2;
    } else if (next_row < next_col) {
      cell.row += row_step;
      next_row += per_row;
      --steps;
    } else {
      cell.col += col_step;
      next_col += per_col;
      --steps;
    }
  }
  return !leaving;
}

bool PathLayer::NearestFree(WorldPoint point, double radius_m,
                            const std::function<bool(CellIndex)>& passes, CellIndex* nearest) {
  const CellIndex middle = CellAt(point);
  const int rings = static_cast<int>(std::ceil(radius_m / cell_m_)) + 1;
  double nearest_m = radius_m;
  bool found = false;
  const auto consider = [&](CellIndex cell) {
    const WorldPoint center = CenterOf(cell);
    const double distance_m = std::hypot(center.x_m - point.x_m, center.y_m - point.y_m);
    if (distance_m > nearest_m || (found && distance_m == nearest_m)) return;
    if (!IsFree(cell) || !passes(cell)) return;
    found = true;
    nearest_m = distance_m;
    *nearest = cell;
  };
  // The search goes in square rings, until the next ring is farther than what was found.
  for (int ring = 0; ring <= rings; ++ring) {
    if (found && (ring - 0.5) * cell_m_ > nearest_m) break;
    for (int row = middle.row - ring; row <= middle.row + ring; ++row) {
      const bool edge = row == middle.row - ring || row == middle.row + ring;
      for (int col = middle.col - ring; col <= middle.col + ring;
           col += edge || ring == 0 ? 1 : 2 * ring)
        consider({row, col});
    }
  }
  return found;
}

void PathLayer::Forget(WorldPoint point, double reach_m) {
  const CellIndex low = CellAt({point.x_m - reach_m, point.y_m + reach_m});
  const CellIndex high = CellAt({point.x_m + reach_m, point.y_m - reach_m});
  const int last = cells_ - 1;
  if (high.row < 0 || high.col < 0 || low.row > last || low.col > last) return;
  for (int row = std::max(low.row, 0) / kTile; row <= std::min(high.row, last) / kTile; ++row) {
    for (int col = std::max(low.col, 0) / kTile; col <= std::min(high.col, last) / kTile; ++col)
      tiles_[static_cast<std::size_t>(row) * tiles_a_side_ + col].reset();
  }
}

}  // namespace latticeworld
