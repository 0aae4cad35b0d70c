#include "latticeworld/layout/class_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/noise.h"

namespace latticeworld {
namespace {

// The letter of each world cell: nearest neighbour in the layout, at a place displaced by noise
// with features of the size of a layout cell and of half of it.
Grid<char> StretchLabels(const SymbolicLayout& layout, const GridGeometry& geometry,
                         double displacement_m, std::uint64_t seed) {
  const double layout_cell_m = geometry.size_m() / kLayoutSize;
  const NoiseOptions border{layout_cell_m, 2, 0.5};
  const Grid<float> east = FractalNoise(geometry, border, StreamSeed(seed, "layout/border/east"));
  const Grid<float> south = FractalNoise(geometry, border, StreamSeed(seed, "layout/border/south"));
  Grid<char> labels(geometry.rows(), geometry.cols());
  const double scale = static_cast<double>(kLayoutSize) / geometry.cols();
  const double displacement_cells = displacement_m / layout_cell_m;
  for (int row = 0; row < geometry.rows(); ++row) {
    const double v = (row + 0.5) * scale;
    for (int col = 0; col < geometry.cols(); ++col) {
      const double u = (col + 0.5) * scale;
      const double du = displacement_cells * east(row, col);
      const double dv = displacement_cells * south(row, col);
      labels(row, col) = layout.cells.Clamped(static_cast<int>(std::floor(v + dv)),
                                              static_cast<int>(std::floor(u + du)));
    }
  }
  return labels;
}

}  // namespace

const Grid<float>* ClassWeights::Find(char letter) const {
  for (const ClassWeight& entry : classes) {
    if (entry.letter == letter) return &entry.weight;
  }
  return nullptr;
}

char ClassWeights::DominantAt(CellIndex cell) const {
  char best = '\0';
  float best_weight = -1.0f;
  for (const ClassWeight& entry : classes) {
    if (entry.weight[cell] > best_weight) {
      best = entry.letter;
      best_weight = entry.weight[cell];
    }
  }
  return best;
}

ClassWeights DecodeLayout(const SymbolicLayout& layout, const GridGeometry& geometry,
                          const DecodeOptions& options, std::uint64_t seed) {
  const double blend_width_m =
      options.blend_width_m > 0.0 ? options.blend_width_m : 0.5 * geometry.size_m() / kLayoutSize;
  const Grid<char> labels =
      StretchLabels(layout, geometry, options.noise_amplitude * blend_width_m, seed);
  // A straight border blurred by this does 99 % of its change within the blend width.
  const double sigma_cells = 0.2 * blend_width_m / geometry.resolution_m();

  ClassWeights weights{layout.vocabulary, {}};
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
    if (std::find(layout.cells.begin(), layout.cells.end(), entry.letter) == layout.cells.end()) {
      continue;
    }
    Grid<float> mask(geometry.rows(), geometry.cols());
    std::transform(labels.begin(), labels.end(), mask.begin(),
                   [&](char letter) { return letter == entry.letter ? 1.0f : 0.0f; });
    GaussianBlur(sigma_cells, &mask);
    // Running sums leave rounding errors of about 1e-7 outside of [0, 1].
    for (float& weight : mask) weight = std::clamp(weight, 0.0f, 1.0f);
    weights.classes.push_back({entry.letter, std::move(mask)});
  }
  return weights;
}

}  // namespace latticeworld
