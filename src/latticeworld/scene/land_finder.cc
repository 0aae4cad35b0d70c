#include "latticeworld/scene/land_finder.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/layout/class_letters.h"
#include "latticeworld/layout/thing_kinds.h"

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
  if (letter == class_letter::kWater) return wet;
  if (letter == kHighGround || letter == kLowGround) return !wet && IsGroundOf(letter, cell);
  if (IsRoad(terrain_.weights.vocabulary, letter)) return surface == SurfaceClass::kRoad;
  return !wet && surface != SurfaceClass::kRoad && terrain_.weights.DominantAt(cell) == letter;
}

bool LandFinder::IsGroundOf(char letter, CellIndex cell) const {
  constexpr double kShare = 0.25;
  const double low_m = terrain_.ground.min_m(), high_m = terrain_.ground.max_m();
  if (high_m - low_m < kLeastRelief_m) return false;
  const double height_m = terrain_.ground.HeightAt(terrain_.geometry().CenterOf(cell));
  const double share = (height_m - low_m) / (high_m - low_m);
  return letter == kHighGround ? share >= 1.0 - kShare : share <= kShare;
}

bool LandFinder::IsOf(char letter, WorldPoint point) const {
  return terrain_.geometry().Contains(point) && IsCellOf(letter, terrain_.geometry().CellAt(point));
}

LandFinder::Class& LandFinder::Of(char letter) {
  const auto [found, is_new] = classes_.try_emplace(letter);
  if (is_new) found->second.buckets = Grid<Bucket>(buckets_.rows(), buckets_.cols());
  return found->second;
}

int LandFinder::Stride() const {
  return std::max(1, static_cast<int>(1.0 / terrain_.geometry().resolution_m()));
}

bool LandFinder::Has(char letter) {
  Class& of = Of(letter);
  if (of.exists) return *of.exists;
  const GridGeometry& geometry = terrain_.geometry();
  const int stride = Stride();
  of.exists = false;
  for (int row = stride / 2; row < geometry.rows() && !*of.exists; row += stride) {
    for (int col = stride / 2; col < geometry.cols() && !*of.exists; col += stride) {
      of.exists = IsCellOf(letter, {row, col});
    }
  }
  return *of.exists;
}

const std::vector<WorldPoint>& LandFinder::CellsOf(char letter) {
  Class& of = Of(letter);
  if (of.is_listed) return of.cells;
  of.is_listed = true;
  const GridGeometry& geometry = terrain_.geometry();
  const int stride = Stride();
  for (int row = stride / 2; row < geometry.rows(); row += stride) {
    for (int col = stride / 2; col < geometry.cols(); col += stride) {
      if (IsCellOf(letter, {row, col})) of.cells.push_back(geometry.CenterOf({row, col}));
    }
  }
  return of.cells;
}

const std::vector<WorldPoint>& LandFinder::CellsIn(char letter, Class* of, CellIndex index) {
  Bucket& bucket = of->buckets[index];
  if (bucket.is_filled) return bucket.cells;
  bucket.is_filled = true;
  const GridGeometry& geometry = terrain_.geometry();
  const int stride = Stride();
  const double half_m = 0.5 * buckets_.resolution_m();
  const WorldPoint middle = buckets_.CenterOf(index);
  // The cells that looking at every stride-th one meets, which lie in the bucket.
  const auto first = [&](double least) {
    const int cell = std::max(0, static_cast<int>(std::floor(least)));
    return stride / 2 + std::max(0, cell - stride / 2) / stride * stride;
  };
  for (int row = first(geometry.RowOf(middle.y_m + half_m)); row < geometry.rows(); row += stride) {
    if (geometry.CenterOf({row, 0}).y_m < middle.y_m - half_m) break;
    for (int col = first(geometry.ColOf(middle.x_m - half_m)); col < geometry.cols();
         col += stride) {
      const WorldPoint centre = geometry.CenterOf({row, col});
      if (centre.x_m > middle.x_m + half_m) break;
      if (!(buckets_.CellAt(centre) == index)) continue;
      if (IsCellOf(letter, {row, col})) bucket.cells.push_back(centre);
    }
  }
  return bucket.cells;
}

std::optional<WorldPoint> LandFinder::Nearest(char letter, WorldPoint point) {
  Class& of = Of(letter);
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
        for (const WorldPoint& cell : CellsIn(letter, &of, {row, col})) {
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

std::optional<WorldPoint> LandFinder::NearestAnywhere(char letter, WorldPoint point) {
  if (const auto nearest = Nearest(letter, point)) return nearest;
  const std::vector<WorldPoint>& cells = CellsOf(letter);
  const auto away_m = [point](WorldPoint cell) {
    return std::hypot(cell.x_m - point.x_m, cell.y_m - point.y_m);
  };
  const auto nearest =
      std::min_element(cells.begin(), cells.end(),
                       [&](WorldPoint a, WorldPoint b) { return away_m(a) < away_m(b); });
  return nearest == cells.end() ? std::optional<WorldPoint>() : *nearest;
}

}  // namespace latticeworld
