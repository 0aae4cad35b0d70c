#include "latticeworld/terrain/ways/graded_ways.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "latticeworld/terrain/ways/embankment.h"

namespace latticeworld::internal {
namespace {

// Of a said slope: what sampling and smoothing add is left.
constexpr double kOfSaid = 0.92;
constexpr double kStep_cells = 0.5;      // between places of a way, of the lattice
constexpr double kSmoothing_m = 6.0;     // of its course up and down, on either side
constexpr double kShoulder_cells = 0.8;  // of the lattice, beside its half width

// The places of a line, so far apart, its ends among them.
std::vector<WorldPoint> PlacesAlong(const std::vector<WorldPoint>& line, double apart_m) {
  std::vector<WorldPoint> places;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const WorldPoint a = line[i], b = line[i + 1];
    const int steps = std::max(
        1, static_cast<int>(std::ceil(std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) / apart_m)));
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      places.push_back({a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m)});
    }
  }
  places.push_back(line.back());
  return places;
}

double Between(const std::vector<WorldPoint>& places, std::size_t i) {
  return std::hypot(places[i].x_m - places[i - 1].x_m, places[i].y_m - places[i - 1].y_m);
}

// The middle between the lowest and the highest course that rises and falls with the slope at most
// and bounds the heights from above and below (roads.cc), and which begins where it has to.
std::vector<double> Graded(const std::vector<WorldPoint>& places, std::vector<double> height_m,
                           double slope) {
  const std::size_t n = places.size();
  const double begin_m = height_m.front();
  std::vector<double> along_m(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) along_m[i] = along_m[i - 1] + Between(places, i);
  for (std::size_t i = 0; i < n; ++i) {
    height_m[i] =
        std::clamp(height_m[i], begin_m - slope * along_m[i], begin_m + slope * along_m[i]);
  }
  std::vector<double> upper = height_m, lower = height_m;
  for (std::size_t i = 1; i < n; ++i) {
    lower[i] = std::min(lower[i], lower[i - 1] + slope * Between(places, i));
    upper[i] = std::max(upper[i], upper[i - 1] - slope * Between(places, i));
  }
  for (std::size_t i = n - 1; i > 0; --i) {
    lower[i - 1] = std::min(lower[i - 1], lower[i] + slope * Between(places, i));
    upper[i - 1] = std::max(upper[i - 1], upper[i] - slope * Between(places, i));
  }
  for (std::size_t i = 0; i < n; ++i) height_m[i] = 0.5 * (lower[i] + upper[i]);
  // A mean of its surroundings keeps the slope.
  std::vector<double> smooth_m(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double reach_m = std::min({kSmoothing_m, along_m[i], along_m[n - 1] - along_m[i]});
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = i; along_m[i] - along_m[k] <= reach_m; --k) {
      sum += height_m[k];
      ++count;
      if (k == 0) break;
    }
    for (std::size_t k = i + 1; k < n && along_m[k] - along_m[i] <= reach_m; ++k) {
      sum += height_m[k];
      ++count;
    }
    smooth_m[i] = sum / count;
  }
  return smooth_m;
}

// Lays the heights of a way onto the cells that it covers, each that of the nearest place.
void Paint(const GridGeometry& lattice, const std::vector<WorldPoint>& places,
           const std::vector<double>& height_m, double half_width_m, Grid<float>* nearest_m,
           Grid<unsigned char>* mask, Grid<float>* built_m) {
  const double cell_m = lattice.resolution_m();
  const int reach = static_cast<int>(std::ceil(half_width_m / cell_m)) + 1;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const CellIndex at = lattice.CellAt(places[i]);
    for (int r = at.row - reach; r <= at.row + reach; ++r) {
      for (int c = at.col - reach; c <= at.col + reach; ++c) {
        if (!mask->Contains({r, c})) continue;
        const WorldPoint cell = lattice.CenterOf({r, c});
        const auto off_m =
            static_cast<float>(std::hypot(cell.x_m - places[i].x_m, cell.y_m - places[i].y_m));
        if (off_m > half_width_m || off_m >= (*nearest_m)(r, c)) continue;
        (*nearest_m)(r, c) = off_m;
        (*mask)(r, c) = 1;
        (*built_m)(r, c) = static_cast<float>(height_m[i]);
      }
    }
  }
}

}  // namespace

void GradeWays(const GridGeometry& lattice, const std::vector<ClimbingWay>& ways,
               const Grid<unsigned char>& road, double embankment_slope, Grid<float>* land_m,
               Grid<float>* share) {
  const double cell_m = lattice.resolution_m();
  const int n = lattice.rows();
  Grid<unsigned char> mask(n, n, 0);
  Grid<float> built_m = *land_m;
  Grid<float> nearest_m(n, n, std::numeric_limits<float>::infinity());
  bool any = false;
  for (const ClimbingWay& way : ways) {
    if (!way.slope) continue;
    const std::vector<WorldPoint> places = PlacesAlong(way.street.line, kStep_cells * cell_m);
    std::vector<double> height_m;
    for (const WorldPoint at : places) height_m.push_back((*land_m)[lattice.CellAt(at)]);
    height_m = Graded(places, std::move(height_m), kOfSaid * *way.slope);
    Paint(lattice, places, height_m, 0.5 * way.street.width_m + kShoulder_cells * cell_m,
          &nearest_m, &mask, &built_m);
    any = true;
  }
  if (!any) return;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (road.data()[i] != 0) mask.data()[i] = 0;
  }
  const Grid<float> before_m = *land_m;
  LayInto(mask, built_m, static_cast<float>(embankment_slope * cell_m), land_m, share);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (road.data()[i] != 0) land_m->data()[i] = before_m.data()[i];
  }
}

}  // namespace latticeworld::internal
