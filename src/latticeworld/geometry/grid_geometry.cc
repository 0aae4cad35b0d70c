#include "latticeworld/geometry/grid_geometry.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
Result<GridGeometry> GridGeometry::Create(double size_m, double resolution_m) {
  std::vector<Violation> violations;
  CheckRange("size", size_m, {kMinSize_m, kMaxSize_m}, " m", &violations);
  CheckRange("resolution", resolution_m, {kMinResolution_m, kMaxResolution_m}, " m", &violations);
  if (violations.empty()) {
    const double cells = std::round(size_m / resolution_m);
    if (cells < kMinCells || cells > kMaxCells) {
      violations.push_back({"cell_count", "size / resolution",
                            FormatDouble(size_m) + " m at " + FormatDouble(resolution_m) +
                                " m makes " + FormatDouble(cells) + " cells a side; legal are " +
                                std::to_string(kMinCells) + " to " + std::to_string(kMaxCells),
                            FormatDouble(cells)});
    }
  }
  if (!violations.empty())
    return Status::FromViolations("illegal world grid", std::move(violations));
  GridGeometry geometry;
  geometry.cells_ = static_cast<int>(std::round(size_m / resolution_m));
  geometry.resolution_m_ = resolution_m;
  return geometry;
}

GridGeometry GridGeometry::FromCells(int cells, double size_m) {
  LW_CHECK(cells > 0 && size_m > 0.0, "a grid has cells and a size");
  GridGeometry geometry;
  geometry.cells_ = cells;
  geometry.resolution_m_ = size_m / cells;
  return geometry;
}

CellIndex GridGeometry::CellAt(WorldPoint point) const {
  const auto index = [this](double continuous) {
    return static_cast<int>(std::clamp(std::floor(continuous + 0.5), 0.0, cells_ - 1.0));
  };
  return {index(RowOf(point.y_m)), index(ColOf(point.x_m))};
}

}  // namespace latticeworld
