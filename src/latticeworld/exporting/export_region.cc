#include "latticeworld/exporting/export_region.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace latticeworld {
namespace {

std::string Metres(double value_m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value_m);
  return text;
}

}  // namespace

ExportRegion WholeWorld(const GridGeometry& geometry) {
  const double half_m = geometry.half_size_m();
  return {-half_m, -half_m, half_m, half_m};
}

std::vector<Violation> Validate(const std::optional<ExportRegion>& region,
                                const GridGeometry& geometry) {
  if (!region) return {};
  const double half_m = geometry.half_size_m();
  const std::string given = Metres(region->west_m) + "," + Metres(region->south_m) + "," +
                            Metres(region->east_m) + "," + Metres(region->north_m);
  const std::string legal = "legal are west,south,east,north within " + Metres(-half_m) + " to " +
                            Metres(half_m) + " m, at least " + Metres(kMinExport_m) + " m a side";
  // Written so that NaN fails.
  const bool ordered = region->width_m() >= kMinExport_m && region->depth_m() >= kMinExport_m;
  const bool inside = geometry.Contains({region->west_m, region->south_m}) &&
                      geometry.Contains({region->east_m, region->north_m});
  if (ordered && inside) return {};
  return {{"out_of_range", "region",
           given + (inside ? " is too small" : " is not in the world") + "; " + legal, given}};
}

CellRange CellsIn(const ExportRegion& region, const GridGeometry& geometry) {
  const auto first = [&](double cell) {
    return std::clamp(static_cast<int>(std::ceil(cell - 1e-9)), 0, geometry.rows() - 1);
  };
  const auto last = [&](double cell) {
    return std::clamp(static_cast<int>(std::floor(cell + 1e-9)), 0, geometry.rows() - 1);
  };
  return {first(geometry.RowOf(region.north_m)), last(geometry.RowOf(region.south_m)),
          first(geometry.ColOf(region.west_m)), last(geometry.ColOf(region.east_m))};
}

std::vector<Violation> ValidateGround(const std::optional<ExportRegion>& region,
                                      const GridGeometry& geometry, const std::string& what) {
  std::vector<Violation> violations = Validate(region, geometry);
  if (!region || !violations.empty()) return violations;
  const CellRange cells = CellsIn(*region, geometry);
  if (cells.rows() < 2 || cells.cols() < 2) {
    violations.push_back({"too_small", "region",
                          what + " a side: legal is a region that holds the centres of two cells "
                                 "of the world's grid a side",
                          ""});
  }
  return violations;
}

ExportRegion BetweenCenters(const CellRange& cells, const GridGeometry& geometry) {
  const WorldPoint north_west = geometry.CenterOf({cells.first_row, cells.first_col});
  const WorldPoint south_east = geometry.CenterOf({cells.last_row, cells.last_col});
  return {north_west.x_m, south_east.y_m, south_east.x_m, north_west.y_m};
}

}  // namespace latticeworld
