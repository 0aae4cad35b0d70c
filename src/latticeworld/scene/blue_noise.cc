#include "latticeworld/scene/blue_noise.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/geometry/grid.h"

namespace latticeworld {
namespace {

constexpr int kRounds = 6;
// Points per square of the spacing after that many rounds, measured (blue_noise_test holds it).
constexpr double kPointsPerSpacing2 = 0.617;

}  // namespace

double BlueNoiseSpacing(double per_m2) { return std::sqrt(kPointsPerSpacing2 / per_m2); }

std::vector<WorldPoint> BlueNoise(double size_m, double per_m2, RandomStream* random) {
  LW_CHECK(size_m > 0.0 && per_m2 > 0.0, "blue noise needs an area and a density");
  const double spacing_m = BlueNoiseSpacing(per_m2);
  // The diagonal of a cell is the spacing, so that a cell holds at most one point.
  const int cells = std::max(1, static_cast<int>(std::ceil(size_m / (spacing_m * M_SQRT1_2))));
  const double cell_m = size_m / cells;

  // A border of two empty cells saves the bounds checks. Empty: a point far outside.
  constexpr int kBorder = 2;
  constexpr float kFar_m = 1e9f;
  struct Point {
    float x_m = kFar_m, y_m = kFar_m;
  };
  Grid<Point> points(cells + 2 * kBorder, cells + 2 * kBorder);
  const float spacing2 = static_cast<float>(spacing_m * spacing_m);
  const auto is_free = [&points, spacing2](int row, int col, Point dart) {
    for (int r = row - kBorder; r <= row + kBorder; ++r) {
      const Point* neighbours = points.row(r);
      for (int c = col - kBorder; c <= col + kBorder; ++c) {
        const float dx = neighbours[c].x_m - dart.x_m, dy = neighbours[c].y_m - dart.y_m;
        if (dx * dx + dy * dy < spacing2) return false;
      }
    }
    return true;
  };

  for (int round = 0; round < kRounds; ++round) {
    for (int row = 0; row < cells; ++row) {
      for (int col = 0; col < cells; ++col) {
        Point& here = points(row + kBorder, col + kBorder);
        if (here.x_m != kFar_m) continue;
        const Point dart = {static_cast<float>((col + random->Uniform()) * cell_m - 0.5 * size_m),
                            static_cast<float>((row + random->Uniform()) * cell_m - 0.5 * size_m)};
        if (is_free(row + kBorder, col + kBorder, dart)) here = dart;
      }
    }
  }

  std::vector<WorldPoint> result;
  result.reserve(static_cast<std::size_t>(size_m * size_m * per_m2 * 1.1) + 1);
  for (const Point& point : points) {
    if (point.x_m != kFar_m) result.push_back({point.x_m, point.y_m});
  }
  return result;
}

}  // namespace latticeworld
