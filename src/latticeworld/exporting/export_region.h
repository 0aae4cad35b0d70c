#ifndef LATTICEWORLD_EXPORTING_EXPORT_REGION_H_
#define LATTICEWORLD_EXPORTING_EXPORT_REGION_H_

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// A rectangle of the frame map that an export is cut to [m].
struct ExportRegion {
  double west_m = 0.0, south_m = 0.0, east_m = 0.0, north_m = 0.0;

  double width_m() const { return east_m - west_m; }
  double depth_m() const { return north_m - south_m; }
  WorldPoint center() const { return {0.5 * (west_m + east_m), 0.5 * (south_m + north_m)}; }
  // Things stand where their middle is; who stands on the border belongs to it.
  bool Holds(WorldPoint point) const {
    return point.x_m >= west_m && point.x_m <= east_m && point.y_m >= south_m &&
           point.y_m <= north_m;
  }
};

inline constexpr double kMinExport_m = 2.0;  // a side

ExportRegion WholeWorld(const GridGeometry& geometry);
// A violation of "region" that says what is legal: not finite, smaller than kMinExport_m a side,
// outside of the world. Legal: no region.
std::vector<Violation> Validate(const std::optional<ExportRegion>& region,
                                const GridGeometry& geometry);
// The same, and where a ground of the centres that it holds would have no area; `what` says what
// has two a side at least: "a ground has at least two vertices".
std::vector<Violation> ValidateGround(const std::optional<ExportRegion>& region,
                                      const GridGeometry& geometry, const std::string& what);

// Cells of a grid, both ends included.
struct CellRange {
  int first_row = 0, last_row = -1, first_col = 0, last_col = -1;
  int rows() const { return last_row - first_row + 1; }
  int cols() const { return last_col - first_col + 1; }
};
// Those whose centres a region holds; none where it lies between centres.
CellRange CellsIn(const ExportRegion& region, const GridGeometry& geometry);
// Returns the region between the centres of the outermost cells. cells: at least one.
ExportRegion BetweenCenters(const CellRange& cells, const GridGeometry& geometry);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_EXPORT_REGION_H_
