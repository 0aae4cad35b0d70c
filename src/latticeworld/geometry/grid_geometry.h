#ifndef LATTICEWORLD_GEOMETRY_GRID_GEOMETRY_H_
#define LATTICEWORLD_GEOMETRY_GRID_GEOMETRY_H_

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// A place in the map frame [m]: x east, y north, origin at the centre of the world.
struct WorldPoint {
  double x_m = 0.0;
  double y_m = 0.0;
};

// Limits of a world. kMaxCells bounds memory: a world keeps about 16 bytes a cell.
inline constexpr double kMinSize_m = 16.0;
inline constexpr double kMaxSize_m = 8192.0;
inline constexpr double kMinResolution_m = 0.05;
inline constexpr double kMaxResolution_m = 16.0;
inline constexpr int kMinCells = 32;    // a side
inline constexpr int kMaxCells = 8192;  // a side

// Says where a square grid lies in the world. Row 0, column 0 is the north-west corner cell, whose
// centre is at (-size/2 + resolution/2, +size/2 - resolution/2): x grows with the column, y falls
// with the row. Every layer of a world shares one GridGeometry, and values stand at cell centres.
class GridGeometry {
 public:
  GridGeometry() = default;

  // Errors: INVALID_ARGUMENT with every violation (size or resolution not finite, out of range, too
  // few or too many cells). size is rounded to a whole number of cells.
  static Result<GridGeometry> Create(double size_m, double resolution_m);
  // cells x cells over size_m, for callers that know both are legal (layout grids, tests).
  static GridGeometry FromCells(int cells, double size_m);

  int rows() const { return cells_; }
  int cols() const { return cells_; }
  double resolution_m() const { return resolution_m_; }
  double size_m() const { return resolution_m_ * cells_; }
  double half_size_m() const { return 0.5 * size_m(); }

  WorldPoint CenterOf(CellIndex cell) const {
    return {-half_size_m() + (cell.col + 0.5) * resolution_m_,
            half_size_m() - (cell.row + 0.5) * resolution_m_};
  }
  // |x| and |y| at most half the size. False for NaN.
  bool Contains(WorldPoint point) const {
    return point.x_m >= -half_size_m() && point.x_m <= half_size_m() &&
           point.y_m >= -half_size_m() && point.y_m <= half_size_m();
  }
  // The cell that holds the point; points outside give the nearest cell. NaN is a bug of the
  // caller.
  CellIndex CellAt(WorldPoint point) const;
  // Continuous cell coordinates: the centre of cell (r, c) is at exactly row = r, col = c.
  double RowOf(double y_m) const { return (half_size_m() - y_m) / resolution_m_ - 0.5; }
  double ColOf(double x_m) const { return (x_m + half_size_m()) / resolution_m_ - 0.5; }

 private:
  int cells_ = 0;
  double resolution_m_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMETRY_GRID_GEOMETRY_H_
