#include "relief/sketch_round_trip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/noise.h"

namespace latticeworld {
namespace {

// Height at the nearest stroke of a kind; false when there is none.
bool NearestHeight(Stroke stroke, const Sketch& sketch, const Grid<float>& height, CellIndex cell,
                   float* nearest) {
  int best = std::numeric_limits<int>::max();
  for (int reach = 1; reach < sketch.rows() && (reach - 1) * (reach - 1) <= best; ++reach) {
    for (int r = cell.row - reach; r <= cell.row + reach; ++r) {
      const bool whole_row = r == cell.row - reach || r == cell.row + reach;
      for (int c = cell.col - reach; c <= cell.col + reach; c += whole_row ? 1 : 2 * reach) {
        if (!sketch.Contains({r, c}) || sketch(r, c) != stroke) continue;
        const int distance = (r - cell.row) * (r - cell.row) + (c - cell.col) * (c - cell.col);
        if (distance >= best) continue;
        best = distance;
        *nearest = height(r, c);
      }
    }
  }
  return best < std::numeric_limits<int>::max();
}

double Mean(const Grid<float>& grid) {
  double sum = 0.0;
  for (const float value : grid) sum += value;
  return sum / static_cast<double>(grid.size());
}

}  // namespace

Grid<float> ErodedLand(int cells, std::uint64_t seed) {
  const int margin = cells / 4;
  const int all = cells + 2 * margin;
  const GridGeometry geometry = GridGeometry::FromCells(all, 16.0 * all);
  NoiseOptions rolling;
  rolling.wavelength_m = 6.0 * cells;
  rolling.octaves = 7;
  Grid<float> height = FractalNoise(geometry, rolling, StreamSeed(seed, "rolling"));
  rolling.octaves = 2;
  Grid<float> uplift = FractalNoise(geometry, rolling, StreamSeed(seed, "uplift"));
  for (float& h : height) h = 300.0f * h;
  for (float& u : uplift) u = 5e-4f * std::max(0.1f, 1.0f + 1.5f * u);
  FluvialOptions options;
  options.steps = 20;
  options.time_step_yr = 3e4;
  options.erodibility = 2e-5;
  options.area_exponent = 0.45;
  ErodeFluvially(geometry.resolution_m(), options, nullptr, &uplift, nullptr, 0, &height);
  Grid<float> middle(cells, cells);
  for (int r = 0; r < cells; ++r) {
    std::copy(height.row(r + margin) + margin, height.row(r + margin) + margin + cells,
              middle.row(r));
  }
  return middle;
}

RightSides MeasureStrokes(const Sketch& sketch, const Grid<float>& height) {
  Grid<float> mean = height;
  GaussianBlur(height.cols() / 32.0, &mean);
  double pixels = 0.0;
  RightSides right;
  for (int r = 0; r < sketch.rows(); ++r) {
    for (int c = 0; c < sketch.cols(); ++c) {
      const Stroke stroke = sketch(r, c);
      if (stroke == Stroke::kNone) continue;
      const bool valley = stroke == Stroke::kValley;
      float other = std::numeric_limits<float>::quiet_NaN();
      NearestHeight(valley ? Stroke::kRidge : Stroke::kValley, sketch, height, {r, c}, &other);
      pixels += 1.0;
      right.of_other += valley ? height(r, c) < other : height(r, c) > other;
      right.of_mean += valley ? height(r, c) < mean(r, c) : height(r, c) > mean(r, c);
    }
  }
  right.of_other /= pixels;
  right.of_mean /= pixels;
  return right;
}

double Correlation(const Grid<float>& a, const Grid<float>& b) {
  const double mean_a = Mean(a), mean_b = Mean(b);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double da = a.data()[i] - mean_a, db = b.data()[i] - mean_b;
    ab += da * db;
    aa += da * da;
    bb += db * db;
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace latticeworld
