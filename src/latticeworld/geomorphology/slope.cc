#include "latticeworld/geomorphology/slope.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {
namespace {

// Calls visit(row, col, dz_dx, dz_dy) with the gradient [m/m], x east and y north, of every cell.
template <typename Visit>
void ForEachGradient(const Grid<float>& height_m, double resolution_m, int threads, Visit visit) {
  const int rows = height_m.rows();
  const int cols = height_m.cols();
  threads = internal::GridThreads(height_m.size(), threads);
  ParallelFor(rows, threads, [&](int begin, int end) {
    for (int r = begin; r < end; ++r) {
      const int north = std::max(r - 1, 0);
      const int south = std::min(r + 1, rows - 1);
      const auto inverse_y = static_cast<float>(1.0 / (std::max(south - north, 1) * resolution_m));
      for (int c = 0; c < cols; ++c) {
        const int west = std::max(c - 1, 0);
        const int east = std::min(c + 1, cols - 1);
        const auto inverse_x = static_cast<float>(1.0 / (std::max(east - west, 1) * resolution_m));
        visit(r, c, (height_m(r, east) - height_m(r, west)) * inverse_x,
              (height_m(north, c) - height_m(south, c)) * inverse_y);
      }
    }
  });
}

}  // namespace

Grid<float> GradientMagnitude(const Grid<float>& height_m, double resolution_m, int threads) {
  Grid<float> magnitude(height_m.rows(), height_m.cols());
  ForEachGradient(height_m, resolution_m, threads,
                  [&magnitude](int r, int c, float dz_dx, float dz_dy) {
                    magnitude(r, c) = std::sqrt(dz_dx * dz_dx + dz_dy * dz_dy);
                  });
  return magnitude;
}

Grid<float> Hillshade(const Grid<float>& height_m, double resolution_m, double azimuth_rad,
                      double altitude_rad, int threads) {
  Grid<float> shade(height_m.rows(), height_m.cols());
  const auto light_x = static_cast<float>(std::sin(azimuth_rad) * std::cos(altitude_rad));
  const auto light_y = static_cast<float>(std::cos(azimuth_rad) * std::cos(altitude_rad));
  const auto light_z = static_cast<float>(std::sin(altitude_rad));
  ForEachGradient(height_m, resolution_m, threads, [&](int r, int c, float dz_dx, float dz_dy) {
    const float cosine = (light_z - dz_dx * light_x - dz_dy * light_y) /
                         std::sqrt(1.0f + dz_dx * dz_dx + dz_dy * dz_dy);
    shade(r, c) = std::clamp(cosine, 0.0f, 1.0f);
  });
  return shade;
}

}  // namespace latticeworld
