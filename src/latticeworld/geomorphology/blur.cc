#include "latticeworld/geomorphology/blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/vector_clones.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {
namespace {

constexpr int kPasses = 3;
constexpr int kRowGroup = 8;
constexpr int kColumnBlock = 64;  // columns whose running sums stay in the first cache

// Mean over [i - radius, i + radius], radius > 0, of each row. Rows go in groups, interleaved,
// since the running sum of one row alone waits for itself. Blurs the groups [first, end).
LATTICEWORLD_VECTOR_CLONES void BoxBlurRows(int radius, int first, int end, Grid<float>* values) {
  const int cols = values->cols();
  const double scale = 1.0 / (2 * radius + 1);
  std::vector<float> lines(static_cast<std::size_t>(cols) * kRowGroup);
  const auto at = [&lines, cols](int col) {
    return lines.data() + static_cast<std::size_t>(std::clamp(col, 0, cols - 1)) * kRowGroup;
  };
  for (int group = first; group < end; ++group) {
    const int begin = group * kRowGroup;
    // The last group may hold fewer rows; the rest repeat the last one and are not written.
    const int count = std::min(kRowGroup, values->rows() - begin);
    float* row[kRowGroup];
    for (int k = 0; k < kRowGroup; ++k) row[k] = values->row(begin + std::min(k, count - 1));
    for (int c = 0; c < cols; ++c) {
      for (int k = 0; k < kRowGroup; ++k) at(c)[k] = row[k][c];
    }
    double sum[kRowGroup];
    for (int k = 0; k < kRowGroup; ++k) sum[k] = (radius + 1.0) * at(0)[k];
    for (int i = 1; i <= radius; ++i) {
      for (int k = 0; k < kRowGroup; ++k) sum[k] += at(i)[k];
    }
    for (int c = 0; c < cols; ++c) {
      for (int k = 0; k < count; ++k) row[k][c] = static_cast<float>(sum[k] * scale);
      const float* entering = at(c + radius + 1);
      const float* leaving = at(c - radius);
      for (int k = 0; k < kRowGroup; ++k) {
        sum[k] += static_cast<double>(entering[k]) - static_cast<double>(leaving[k]);
      }
    }
  }
}

// The same along columns, a block of columns at a time, so that memory is read in rows. Blurs the
// blocks [first_block, end_block).
LATTICEWORLD_VECTOR_CLONES void BoxBlurColumns(int radius, int first_block, int end_block,
                                               Grid<float>* values) {
  const int rows = values->rows();
  const double scale = 1.0 / (2 * radius + 1);
  // The last radius + 1 source rows, which the output has overwritten already.
  const int kept = radius + 1;
  std::vector<float> ring(static_cast<std::size_t>(kept) * kColumnBlock);
  double sum[kColumnBlock];
  for (int block = first_block; block < end_block; ++block) {
    const int begin = block * kColumnBlock;
    const int width = std::min(kColumnBlock, values->cols() - begin);
    const std::vector<float> first(values->row(0) + begin, values->row(0) + begin + width);
    for (int c = 0; c < width; ++c) sum[c] = (radius + 1.0) * first[c];
    for (int i = 1; i <= radius; ++i) {
      const float* source = values->row(std::min(i, rows - 1)) + begin;
      for (int c = 0; c < width; ++c) sum[c] += source[c];
    }
    // Beyond the lower edge the last source row continues; keep it before it is overwritten.
    const std::vector<float> last(values->row(rows - 1) + begin,
                                  values->row(rows - 1) + begin + width);
    for (int r = 0; r < rows; ++r) {
      float* row = values->row(r) + begin;
      float* slot = ring.data() + static_cast<std::size_t>(r % kept) * kColumnBlock;
      std::copy(row, row + width, slot);
      const float* entering =
          r + radius + 1 < rows ? values->row(r + radius + 1) + begin : last.data();
      const float* leaving =
          r - radius >= 0
              ? ring.data() + static_cast<std::size_t>((r - radius) % kept) * kColumnBlock
              : first.data();
      for (int c = 0; c < width; ++c) {
        row[c] = static_cast<float>(sum[c] * scale);
        sum[c] += static_cast<double>(entering[c]) - static_cast<double>(leaving[c]);
      }
    }
  }
}

}  // namespace

void GaussianBlur(double sigma_cells, Grid<float>* values, int threads) {
  if (values->empty()) return;
  threads = internal::GridThreads(values->size(), threads);
  const int groups = (values->rows() + kRowGroup - 1) / kRowGroup;
  const int blocks = (values->cols() + kColumnBlock - 1) / kColumnBlock;
  // Three boxes of width w have the variance (w^2 - 1) / 4; narrower ones first.
  const double ideal_width = std::sqrt(4.0 * sigma_cells * sigma_cells + 1.0);
  const int lower_radius = static_cast<int>((ideal_width - 1.0) / 2.0);
  const double lower_width = 2.0 * lower_radius + 1.0;
  const double narrow_count =
      (12.0 * sigma_cells * sigma_cells - kPasses * lower_width * lower_width -
       4.0 * kPasses * lower_width - 3.0 * kPasses) /
      (-4.0 * lower_width - 4.0);
  const int narrow = static_cast<int>(std::lround(narrow_count));
  for (int pass = 0; pass < kPasses; ++pass) {
    const int radius = pass < narrow ? lower_radius : lower_radius + 1;
    if (radius == 0) continue;
    ParallelFor(groups, threads,
                [&](int begin, int end) { BoxBlurRows(radius, begin, end, values); });
    ParallelFor(blocks, threads,
                [&](int begin, int end) { BoxBlurColumns(radius, begin, end, values); });
  }
}

}  // namespace latticeworld
