#include "latticeworld/navigation/surface_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "latticeworld/navigation/distance_field.h"
#include "latticeworld/navigation/navigable_map.h"

namespace latticeworld {
namespace {

// This near to the goal, a straight line to it is looked for.
constexpr int kStraightCells = 8;

struct Step {
  int row, col;
};
// Straight ones even, diagonal ones odd.
constexpr std::array<Step, 8> kAround = {
    {{0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}}};

// Cells from the start down the field, each the neighbour towards which it falls most, to where the
// goal is straight ahead; none: there it does not come.
std::vector<CellIndex> Descend(const NavigableMap& map, const DistanceField& field, CellIndex at) {
  const auto is_open = [&](int row, int col) {
    return map.free.Contains({row, col}) && map.free(row, col) != 0;
  };
  const Grid<float>& height_m = map.ground.height_m();
  const float run_m = static_cast<float>(map.geometry().resolution_m());
  const float near_m = kStraightCells * run_m;
  std::vector<CellIndex> cells = {at};
  while (field.distance_m[at] > near_m ||
         !MeasureLine(map, map.geometry().CenterOf(at), field.goal).is_free) {
    CellIndex best = at;
    float best_slope = 0.0f;
    for (int i = 0; i < 8; ++i) {
      const CellIndex next{at.row + kAround[i].row, at.col + kAround[i].col};
      if (!is_open(next.row, next.col)) continue;
      if (i % 2 == 1 && (!is_open(next.row, at.col) || !is_open(at.row, next.col))) continue;
      const float fall_m = field.distance_m[at] - field.distance_m[next];
      const float rise_m = height_m[next] - height_m[at];
      const float slope =
          fall_m / std::sqrt((i % 2 == 0 ? 1.0f : 2.0f) * run_m * run_m + rise_m * rise_m);
      if (slope > best_slope) {
        best_slope = slope;
        best = next;
      }
    }
    if (best == at) return {};
    at = best;
    cells.push_back(at);
  }
  return cells;
}

// Corners that a straight line replaces the way between wherever it is free and no longer.
std::vector<WorldPoint> Straighten(const NavigableMap& map, const std::vector<WorldPoint>& points) {
  std::vector<double> along_m(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i)
    along_m[i] = along_m[i - 1] + MeasureLine(map, points[i - 1], points[i]).length_m;
  std::vector<WorldPoint> corners = {points.front()};
  std::size_t at = 0;
  while (at + 1 < points.size()) {
    // The line is lengthened by doubling as long as that pays, then by halves.
    std::size_t good = at + 1, step = 1;
    const auto pays = [&](std::size_t to) {
      const SurfaceLine line = MeasureLine(map, points[at], points[to]);
      return line.is_free && line.length_m <= along_m[to] - along_m[at] + 1e-9;
    };
    while (good + step < points.size() && pays(good + step)) {
      good += step;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (good + step < points.size() && pays(good + step)) good += step;
    }
    at = good;
    corners.push_back(points[at]);
  }
  return corners;
}

}  // namespace

Result<SurfacePath> PathDown(const NavigableMap& map, const DistanceField& field,
                             WorldPoint start) {
  LW_RETURN_IF_ERROR(CheckInside(map.geometry(), start, "the start"));
  const CellIndex from = map.geometry().CellAt(start);
  if (!map.IsFree(start) || std::isinf(field.distance_m[from]))
    return NotFound("there is no way from the start to the goal");
  std::vector<WorldPoint> points = {start};
  const std::vector<CellIndex> cells = Descend(map, field, from);
  if (cells.empty()) return NotFound("there is no way from the start to the goal");
  for (std::size_t i = 1; i < cells.size(); ++i)
    points.push_back(map.geometry().CenterOf(cells[i]));
  points.push_back(field.goal);
  // The path is straightened from the other side as well: corners that doubling left on the way are
  // pulled straight.
  points = Straighten(map, points);
  std::reverse(points.begin(), points.end());
  points = Straighten(map, points);
  std::reverse(points.begin(), points.end());

  SurfacePath path;
  for (std::size_t i = 0; i < points.size(); ++i) {
    path.points_m.emplace_back(points[i].x_m, points[i].y_m, map.ground.HeightAt(points[i]));
    if (i == 0) continue;
    const SurfaceLine line = MeasureLine(map, points[i - 1], points[i]);
    path.length_m += line.length_m;
    path.climb_m += line.climb_m;
  }
  return path;
}

}  // namespace latticeworld
