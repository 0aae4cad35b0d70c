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

// How much a way may rise from each place before to the place [m]: less in narrow bends, where the
// inner side is shorter than the middle.
std::vector<double> RisesOf(const std::vector<WorldPoint>& places, double slope) {
  constexpr std::size_t kReach = 6;       // places on either side that tell a bend
  constexpr double kNarrow_m = 12.0;      // of a radius
  constexpr double kLeastOfSlope = 0.35;  // in the narrowest
  std::vector<double> rises_m(places.size(), 0.0);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const WorldPoint before = places[i - std::min(i, kReach)], here = places[i];
    const WorldPoint after = places[std::min(i + kReach, places.size() - 1)];
    const double turn_rad =
        std::abs(std::remainder(std::atan2(after.y_m - here.y_m, after.x_m - here.x_m) -
                                    std::atan2(here.y_m - before.y_m, here.x_m - before.x_m),
                                2.0 * M_PI));
    const double length_m = 0.5 * (std::hypot(here.x_m - before.x_m, here.y_m - before.y_m) +
                                   std::hypot(after.x_m - here.x_m, after.y_m - here.y_m));
    const double radius_m = length_m / std::max(turn_rad, 1e-6);
    const bool ends = i < kReach || i + kReach >= places.size();
    const double share = ends ? 1.0 : std::clamp(radius_m / kNarrow_m, kLeastOfSlope, 1.0);
    rises_m[i] = share * slope * Between(places, i);
  }
  return rises_m;
}

// The middle between the lowest and the highest course that rises and falls so much at most and
// bounds the heights from above and below (roads.cc), and which begins where it has to.
std::vector<double> Graded(const std::vector<WorldPoint>& places, std::vector<double> height_m,
                           double slope) {
  const std::size_t n = places.size();
  const std::vector<double> rises_m = RisesOf(places, slope);
  const double begin_m = height_m.front();
  double reach_m = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    reach_m += rises_m[i];
    height_m[i] = std::clamp(height_m[i], begin_m - reach_m, begin_m + reach_m);
  }
  std::vector<double> upper = height_m, lower = height_m;
  for (std::size_t i = 1; i < n; ++i) {
    lower[i] = std::min(lower[i], lower[i - 1] + rises_m[i]);
    upper[i] = std::max(upper[i], upper[i - 1] - rises_m[i]);
  }
  for (std::size_t i = n - 1; i > 0; --i) {
    lower[i - 1] = std::min(lower[i - 1], lower[i] + rises_m[i]);
    upper[i - 1] = std::max(upper[i - 1], upper[i] - rises_m[i]);
  }
  for (std::size_t i = 0; i < n; ++i) height_m[i] = 0.5 * (lower[i] + upper[i]);
  return height_m;
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
    // Where legs lie close beside each other, the land between them is as steep as it has to be.
    if (mask.data()[i] != 0) land_m->data()[i] = built_m.data()[i];
    if (road.data()[i] != 0) land_m->data()[i] = before_m.data()[i];
  }
}

}  // namespace latticeworld::internal
