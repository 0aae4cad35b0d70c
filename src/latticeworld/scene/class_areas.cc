#include "latticeworld/scene/class_areas.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr int kCoarseCells = 64;
constexpr int kNone = -1;
constexpr int kUnlabelled = -2;

double PrincipalDirection(const GridGeometry& geometry, const std::vector<CellIndex>& cells,
                          WorldPoint mean) {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const CellIndex cell : cells) {
    const WorldPoint point = geometry.CenterOf(cell);
    const double dx = point.x_m - mean.x_m, dy = point.y_m - mean.y_m;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  // A compact area has no direction worth following: its axis would be an accident of its border.
  const double spread = std::hypot(xx - yy, 2.0 * xy);
  if (spread <= 0.05 * (xx + yy)) return 0.0;
  return 0.5 * std::atan2(2.0 * xy, xx - yy);
}

}  // namespace

ClassAreas::ClassAreas(const GridGeometry& geometry, const WeightGrid& weight)
    : coarse_(GridGeometry::FromCells(std::min(kCoarseCells, geometry.rows()), geometry.size_m())),
      label_(coarse_.rows(), coarse_.cols(), kNone) {
  for (int row = 0; row < coarse_.rows(); ++row) {
    for (int col = 0; col < coarse_.cols(); ++col) {
      const WorldPoint centre = coarse_.CenterOf({row, col});
      if (weight[geometry.CellAt(centre)] >= 0.5f) label_(row, col) = kUnlabelled;
    }
  }

  for (int row = 0; row < coarse_.rows(); ++row) {
    for (int col = 0; col < coarse_.cols(); ++col) {
      if (label_(row, col) != kUnlabelled) continue;
      // Flood from the first cell; `cells` is queue and result at once.
      const int label = static_cast<int>(areas_.size());
      std::vector<CellIndex> cells = {{row, col}};
      label_(row, col) = label;
      WorldPoint sum;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const CellIndex cell = cells[i];
        const WorldPoint point = coarse_.CenterOf(cell);
        sum.x_m += point.x_m;
        sum.y_m += point.y_m;
        for (const CellIndex next :
             {CellIndex{cell.row - 1, cell.col}, CellIndex{cell.row + 1, cell.col},
              CellIndex{cell.row, cell.col - 1}, CellIndex{cell.row, cell.col + 1}}) {
          if (!label_.Contains(next) || label_[next] != kUnlabelled) continue;
          label_[next] = label;
          cells.push_back(next);
        }
      }
      Area area;
      const double count = static_cast<double>(cells.size());
      area.centre = {sum.x_m / count, sum.y_m / count};
      area.direction_rad = PrincipalDirection(coarse_, cells, area.centre);
      for (const CellIndex cell : cells) {
        const WorldPoint point = coarse_.CenterOf(cell);
        area.reach_m = std::max(
            area.reach_m, std::hypot(point.x_m - area.centre.x_m, point.y_m - area.centre.y_m));
      }
      area.reach_m += 1.5 * M_SQRT2 * coarse_.resolution_m();  // the neighbouring cells
      areas_.push_back(area);
    }
  }
}

int ClassAreas::AreaAt(WorldPoint point) const {
  const CellIndex cell = coarse_.CellAt(point);
  if (label_[cell] >= 0) return label_[cell];
  for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
    for (int col = cell.col - 1; col <= cell.col + 1; ++col) {
      if (label_.Contains({row, col}) && label_(row, col) >= 0) return label_(row, col);
    }
  }
  return kNone;
}

}  // namespace latticeworld
