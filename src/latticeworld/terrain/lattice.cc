#include "latticeworld/terrain/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld::internal {
namespace {

constexpr int kLatticeCells = 512;
// Small worlds hold less, and are asked for often.
constexpr int kSmallLatticeCells = 256;
constexpr double kSmallWorld_m = 200.0;

// Solves (x_(i-1) + 4 x_i + x_(i+1)) / 6 = v_i in place: a sweep there and one back, each with the
// root of z^2 + 4 z + 1 that decays.
void FilterLine(int cells, std::ptrdiff_t step, float* values) {
  constexpr float kRoot = -0.26794919f;  // sqrt(3) - 2
  constexpr int kReach = 16;             // its powers vanish beyond
  float start = 0.0f, power = 1.0f;
  for (int i = 0; i < std::min(cells, kReach); ++i, power *= kRoot) {
    start += power * values[i * step];
  }
  values[0] = start;
  for (int i = 1; i < cells; ++i) values[i * step] += kRoot * values[(i - 1) * step];
  float* last = values + (cells - 1) * step;
  *last = kRoot / (kRoot * kRoot - 1.0f) * (*last + kRoot * *(last - step));
  for (int i = cells - 2; i >= 0; --i) {
    values[i * step] = kRoot * (values[(i + 1) * step] - values[i * step]);
  }
  for (int i = 0; i < cells; ++i) values[i * step] *= 6.0f;
}

}  // namespace

GridGeometry LatticeOf(const GridGeometry& world) {
  const int cells = world.size_m() < kSmallWorld_m ? kSmallLatticeCells : kLatticeCells;
  return GridGeometry::FromCells(cells, world.size_m());
}

double LatticeCellsPerLayoutCell(const GridGeometry& lattice) {
  return static_cast<double>(lattice.rows()) / kLayoutSize;
}

std::vector<RowSampler::Taps> RowSampler::MakeTaps(int source_cells, int cells, Kernel kernel) {
  std::vector<Taps> result(cells);
  const double scale = static_cast<double>(source_cells) / cells;
  for (int i = 0; i < cells; ++i) {
    const double place = (i + 0.5) * scale - 0.5;
    const double cell = std::floor(place);
    const double t = place - cell, s = 1.0 - t;
    Taps& taps = result[i];
    taps.first = static_cast<int>(cell) - 1;
    const auto set = [&taps](double a, double b, double c, double d) {
      const double weights[4] = {a, b, c, d};
      for (int k = 0; k < 4; ++k) taps.weight[k] = static_cast<float>(weights[k]);
    };
    if (kernel == Kernel::kSmooth) {
      set(s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
          (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, t * t * t / 6.0);
    } else {
      set(-0.5 * t * s * s, (1.5 * t - 2.5) * t * t + 1.0, (1.5 * s - 2.5) * s * s + 1.0,
          -0.5 * s * t * t);
    }
  }
  return result;
}

RowSampler::RowSampler(const Grid<float>& source, int cells, Kernel kernel)
    : source_(source),
      copies_(kernel == Kernel::kThrough && source.rows() == cells && source.cols() == cells),
      rows_(MakeTaps(source.rows(), cells, kernel)),
      cols_(MakeTaps(source.cols(), cells, kernel)) {}

void RowSampler::Row(int row, std::vector<float>* scratch, float* values) const {
  const int rows = source_.rows(), cols = source_.cols();
  if (copies_) {
    std::copy(source_.row(row), source_.row(row) + cols, values);
    return;
  }
  constexpr int kMargin = 3;
  scratch->resize(static_cast<std::size_t>(cols) + 2 * kMargin);
  float* line = scratch->data() + kMargin;
  const Taps& vertical = rows_[row];
  const float* near[4];
  for (int k = 0; k < 4; ++k) near[k] = source_.row(std::clamp(vertical.first + k, 0, rows - 1));
  const float w0 = vertical.weight[0], w1 = vertical.weight[1];
  const float w2 = vertical.weight[2], w3 = vertical.weight[3];
  for (int c = 0; c < cols; ++c) {
    line[c] = (w0 * near[0][c] + w1 * near[1][c]) + (w2 * near[2][c] + w3 * near[3][c]);
  }
  std::fill(line - kMargin, line, line[0]);
  std::fill(line + cols, line + cols + kMargin, line[cols - 1]);
  const int cells = static_cast<int>(cols_.size());
  for (int c = 0; c < cells; ++c) {
    const Taps& taps = cols_[c];
    const float* first = line + taps.first;
    values[c] = (taps.weight[0] * first[0] + taps.weight[1] * first[1]) +
                (taps.weight[2] * first[2] + taps.weight[3] * first[3]);
  }
}

Grid<float> SplineCoefficients(Grid<float> values) {
  const int rows = values.rows(), cols = values.cols();
  for (int r = 0; r < rows; ++r) FilterLine(cols, 1, values.row(r));
  for (int c = 0; c < cols; ++c) FilterLine(rows, cols, values.data() + c);
  return values;
}

}  // namespace latticeworld::internal
