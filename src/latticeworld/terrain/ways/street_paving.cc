// Streets on grids: those of the lattice for their grading, those of the world for their surface.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/terrain/ways/streets.h"

namespace latticeworld::internal {
namespace {

// Half the diagonal of a cell and a little: every cell that a line passes through has its centre so
// near, so that thin streets hang together on coarse grids.
constexpr double kLeastHalfWidth_cells = 0.72;

// Calls visit(cell, offset) for every cell whose centre lies within the street's half width of its
// centre line; offset_m: from the cell to the line. A cell may come more than once.
template <typename Visit>
void ForEachCellOf(const Street& street, const GridGeometry& geometry, Visit&& visit) {
  const double half_m =
      std::max(0.5 * street.width_m, kLeastHalfWidth_cells * geometry.resolution_m());
  for (std::size_t i = 0; i + 1 < street.line.size(); ++i) {
    const WorldPoint a = street.line[i], b = street.line[i + 1];
    const auto low = [&](double at) { return std::max(0, static_cast<int>(std::ceil(at))); };
    const auto high = [&](double at) {
      return std::min(geometry.rows() - 1, static_cast<int>(std::floor(at)));
    };
    const int row_end = high(geometry.RowOf(std::min(a.y_m, b.y_m) - half_m));
    const int col_end = high(geometry.ColOf(std::max(a.x_m, b.x_m) + half_m));
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    const double length2 = std::max(dx * dx + dy * dy, 1e-12);
    for (int row = low(geometry.RowOf(std::max(a.y_m, b.y_m) + half_m)); row <= row_end; ++row) {
      for (int col = low(geometry.ColOf(std::min(a.x_m, b.x_m) - half_m)); col <= col_end; ++col) {
        const WorldPoint at = geometry.CenterOf({row, col});
        const double t =
            std::clamp(((at.x_m - a.x_m) * dx + (at.y_m - a.y_m) * dy) / length2, 0.0, 1.0);
        const WorldPoint offset_m = {a.x_m + t * dx - at.x_m, a.y_m + t * dy - at.y_m};
        if (std::hypot(offset_m.x_m, offset_m.y_m) <= half_m) visit(CellIndex{row, col}, offset_m);
      }
    }
  }
}

}  // namespace

void MarkStreets(const GridGeometry& lattice, const std::vector<Street>& streets,
                 const Grid<unsigned char>& wet, Grid<unsigned char>* road, DecodedLayout* lines) {
  const auto cell_m = static_cast<float>(lattice.resolution_m());
  Grid<float> nearest_m(road->rows(), road->cols(), kNoFeature);
  for (const Street& street : streets) {
    ForEachCellOf(street, lattice, [&](CellIndex cell, WorldPoint offset_m) {
      const bool of_layout = (*road)[cell] != 0 && nearest_m[cell] == kNoFeature;
      if (of_layout || wet[cell] != 0) return;
      const auto distance_m = static_cast<float>(std::hypot(offset_m.x_m, offset_m.y_m));
      if (distance_m >= nearest_m[cell]) return;
      nearest_m[cell] = distance_m;
      (*road)[cell] = 1;
      lines->to_road_center_cols[cell] = static_cast<float>(offset_m.x_m) / cell_m;
      lines->to_road_center_rows[cell] = static_cast<float>(-offset_m.y_m) / cell_m;
    });
  }
}

void PaveStreets(const std::vector<Street>& streets, Terrain* terrain) {
  if (terrain->geometry().resolution_m() > kCoarsestPaved_m) return;
  for (const Street& street : streets) {
    ForEachCellOf(street, terrain->geometry(), [&](CellIndex cell, WorldPoint) {
      if (std::isnan(terrain->water_level_m[cell])) terrain->surface[cell] = SurfaceClass::kRoad;
    });
  }
}

}  // namespace latticeworld::internal
