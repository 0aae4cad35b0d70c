#include "latticeworld/scene/land_finder.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kBucket_m = 16.0;

}  // namespace

LandFinder::LandFinder(const Terrain& terrain) : terrain_(terrain) {
  const double size_m = terrain.geometry().size_m();
  buckets_ =
      GridGeometry::FromCells(std::max(1, static_cast<int>(std::ceil(size_m / kBucket_m))), size_m);
}

bool LandFinder::IsCellOf(char letter, CellIndex cell) const {
  const SurfaceClass surface = terrain_.surface[cell];
  const bool wet = !std::isnan(terrain_.water_level_m[cell]);
  const bool has_roads = terrain_.weights.vocabulary == Vocabulary::kSuburb;
  if (letter == 'W') return wet;
  if (has_roads && letter == 'R') return surface == SurfaceClass::kRoad;
  return !wet && surface != SurfaceClass::kRoad && terrain_.weights.DominantAt(cell) == letter;
}

bool LandFinder::IsOf(char letter, WorldPoint point) const {
  return terrain_.geometry().Contains(point) && IsCellOf(letter, terrain_.geometry().CellAt(point));
}

const LandFinder::Class& LandFinder::Of(char letter) {
  const auto [found, is_new] = classes_.try_emplace(letter);
  Class& listed = found->second;
  if (!is_new) return listed;
  listed.buckets = Grid<std::vector<WorldPoint>>(buckets_.rows(), buckets_.cols());
  const GridGeometry& geometry = terrain_.geometry();
  const int stride = std::max(1, static_cast<int>(1.0 / geometry.resolution_m()));
  for (int row = stride / 2; row < geometry.rows(); row += stride) {
    for (int col = stride / 2; col < geometry.cols(); col += stride) {
      if (!IsCellOf(letter, {row, col})) continue;
      const WorldPoint centre = geometry.CenterOf({row, col});
      listed.cells.push_back(centre);
      listed.buckets[buckets_.CellAt(centre)].push_back(centre);
    }
  }
  return listed;
}

const std::vector<WorldPoint>& LandFinder::CellsOf(char letter) { return Of(letter).cells; }

std::optional<WorldPoint> LandFinder::Nearest(char letter, WorldPoint point) {
  const Class& listed = Of(letter);
  const CellIndex centre = buckets_.CellAt(point);
  const double bucket_m = buckets_.resolution_m();
  const int reach = static_cast<int>(std::ceil(kReach_m / bucket_m));
  double least_m2 = kReach_m * kReach_m;
  std::optional<WorldPoint> nearest;
  for (int ring = 0; ring <= reach; ++ring) {
    // What lies within a ring is complete up to one bucket less.
    if (nearest && least_m2 <= std::pow((ring - 1) * bucket_m, 2) && ring > 0) break;
    for (int row = centre.row - ring; row <= centre.row + ring; ++row) {
      const bool whole_row = row == centre.row - ring || row == centre.row + ring;
      for (int col = centre.col - ring; col <= centre.col + ring;
           col += whole_row ? 1 : std::max(1, 2 * ring)) {
        if (row < 0 || col < 0 || row >= buckets_.rows() || col >= buckets_.cols()) continue;
        for (const WorldPoint& cell : listed.buckets(row, col)) {
          const double dx = cell.x_m - point.x_m, dy = cell.y_m - point.y_m;
          if (dx * dx + dy * dy > least_m2) continue;
          least_m2 = dx * dx + dy * dy;
          nearest = cell;
        }
      }
    }
  }
  return nearest;
}

}  // namespace latticeworld
