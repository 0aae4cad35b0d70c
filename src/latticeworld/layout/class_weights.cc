#include "latticeworld/layout/class_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

// Smooth noise in [-1, 1] with features of the size of a layout cell and of half of it.
class BorderNoise {
 public:
  explicit BorderNoise(std::uint64_t seed) : seed_(seed) {}

  // u, v in layout cells.
  double At(double u, double v) const {
    return (2.0 * Octave(u, v, 0) + Octave(2.0 * u, 2.0 * v, 1)) / 3.0;
  }

 private:
  double Octave(double u, double v, std::uint64_t octave) const {
    const double u_floor = std::floor(u), v_floor = std::floor(v);
    const auto lattice = [&](int du, int dv) {
      return HashToUnit(seed_ + octave, static_cast<std::int64_t>(u_floor) + du,
                        static_cast<std::int64_t>(v_floor) + dv);
    };
    const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double s = smooth(u - u_floor), t = smooth(v - v_floor);
    const double upper = lattice(0, 0) + s * (lattice(1, 0) - lattice(0, 0));
    const double lower = lattice(0, 1) + s * (lattice(1, 1) - lattice(0, 1));
    return 2.0 * (upper + t * (lower - upper)) - 1.0;
  }

  std::uint64_t seed_;
};

// The letter of each world cell: nearest neighbour in the layout, at a place displaced by noise.
Grid<char> StretchLabels(const SymbolicLayout& layout, const GridGeometry& geometry,
                         double displacement_cells, std::uint64_t seed) {
  const BorderNoise east(StreamSeed(seed, "layout/border/east"));
  const BorderNoise south(StreamSeed(seed, "layout/border/south"));
  Grid<char> labels(geometry.rows(), geometry.cols());
  const double scale = static_cast<double>(kLayoutSize) / geometry.cols();
  for (int row = 0; row < geometry.rows(); ++row) {
    const double v = (row + 0.5) * scale;
    for (int col = 0; col < geometry.cols(); ++col) {
      const double u = (col + 0.5) * scale;
      const double du = displacement_cells * east.At(u, v);
      const double dv = displacement_cells * south.At(u, v);
      labels(row, col) = layout.cells.Clamped(static_cast<int>(std::floor(v + dv)),
                                              static_cast<int>(std::floor(u + du)));
    }
  }
  return labels;
}

// Running mean over 2 * radius + 1 samples of one line, edges continued.
void BoxBlurLine(const float* in, float* out, int count, int stride, int radius) {
  const auto at = [&](int i) { return in[std::clamp(i, 0, count - 1) * stride]; };
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) sum += at(i);
  const double scale = 1.0 / (2 * radius + 1);
  for (int i = 0; i < count; ++i) {
    out[i * stride] = static_cast<float>(sum * scale);
    sum += at(i + radius + 1) - at(i - radius);
  }
}

// A Gaussian as three box passes each way (central limit theorem).
void BlurInPlace(Grid<float>* grid, int radius) {
  if (radius < 1) return;
  Grid<float> other(grid->rows(), grid->cols());
  for (int pass = 0; pass < 3; ++pass) {
    for (int row = 0; row < grid->rows(); ++row) {
      BoxBlurLine(grid->row(row), other.row(row), grid->cols(), 1, radius);
    }
    for (int col = 0; col < grid->cols(); ++col) {
      BoxBlurLine(other.data() + col, grid->data() + col, grid->rows(), grid->cols(), radius);
    }
  }
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
  const double layout_cell_m = geometry.size_m() / kLayoutSize;
  const double blend_width_m =
      options.blend_width_m > 0.0 ? options.blend_width_m : 0.5 * layout_cell_m;
  const Grid<char> labels = StretchLabels(
      layout, geometry, options.noise_amplitude * blend_width_m / layout_cell_m, seed);
  // Three boxes of this radius span about the blend width from 5 % to 95 % of a straight border.
  const int radius = static_cast<int>(std::lround(0.2 * blend_width_m / geometry.resolution_m()));

  ClassWeights weights{layout.vocabulary, {}};
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
    if (std::find(layout.cells.begin(), layout.cells.end(), entry.letter) == layout.cells.end()) {
      continue;
    }
    Grid<float> mask(geometry.rows(), geometry.cols());
    std::transform(labels.begin(), labels.end(), mask.begin(),
                   [&](char letter) { return letter == entry.letter ? 1.0f : 0.0f; });
    BlurInPlace(&mask, radius);
    weights.classes.push_back({entry.letter, std::move(mask)});
  }
  return weights;
}

}  // namespace latticeworld
