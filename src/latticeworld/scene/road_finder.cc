#include "latticeworld/scene/road_finder.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kBucket_m = 16.0;
constexpr double kNearlyAsNear_m = 2.0;

}  // namespace

RoadFinder::RoadFinder(const Terrain& terrain) {
  const GridGeometry& geometry = terrain.geometry();
  buckets_ = GridGeometry::FromCells(
      std::max(1, static_cast<int>(std::ceil(geometry.size_m() / kBucket_m))), geometry.size_m());
  cells_ = Grid<std::vector<WorldPoint>>(buckets_.rows(), buckets_.cols());
  const int stride = std::max(1, static_cast<int>(1.0 / geometry.resolution_m()));
  for (int row = stride / 2; row < geometry.rows(); row += stride) {
    for (int col = stride / 2; col < geometry.cols(); col += stride) {
      if (terrain.surface(row, col) != SurfaceClass::kRoad) continue;
      const WorldPoint centre = geometry.CenterOf({row, col});
      cells_[buckets_.CellAt(centre)].push_back(centre);
      any_ = true;
    }
  }
}

std::optional<RoadFinder::Road> RoadFinder::Nearest(WorldPoint point) const {
  if (!any_) return std::nullopt;
  const CellIndex centre = buckets_.CellAt(point);
  const int reach = static_cast<int>(std::ceil(kReach_m / buckets_.resolution_m()));
  const auto visit_rings = [&](int rings, const auto& visit) {
    for (int row = std::max(0, centre.row - rings);
         row <= std::min(buckets_.rows() - 1, centre.row + rings); ++row) {
      for (int col = std::max(0, centre.col - rings);
           col <= std::min(buckets_.cols() - 1, centre.col + rings); ++col) {
        for (const WorldPoint& cell : cells_(row, col)) {
          visit(cell.x_m - point.x_m, cell.y_m - point.y_m);
        }
      }
    }
  };

  // What lies within the rings is complete up to `rings` bucket widths.
  double nearest_m = INFINITY;
  int rings = 1;
  for (;; rings = std::min(2 * rings, reach)) {
    double nearest_m2 = INFINITY;
    visit_rings(rings, [&nearest_m2](double dx, double dy) {
      nearest_m2 = std::min(nearest_m2, dx * dx + dy * dy);
    });
    nearest_m = std::sqrt(nearest_m2);
    if (rings == reach || nearest_m + kNearlyAsNear_m <= rings * buckets_.resolution_m()) break;
  }
  if (nearest_m > kReach_m || nearest_m < 0.5 * kNearlyAsNear_m) return std::nullopt;

  const double nearly_m2 = (nearest_m + kNearlyAsNear_m) * (nearest_m + kNearlyAsNear_m);
  double x = 0.0, y = 0.0;
  visit_rings(rings, [&](double dx, double dy) {
    if (dx * dx + dy * dy > nearly_m2) return;
    const double distance_m = std::sqrt(dx * dx + dy * dy);
    x += dx / distance_m;
    y += dy / distance_m;
  });
  return Road{nearest_m, std::atan2(y, x)};
}

}  // namespace latticeworld
