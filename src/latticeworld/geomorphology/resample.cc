#include "latticeworld/geomorphology/resample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {
namespace {

// Which source samples make a new one: `taps` in a row from `first`, clamped to the source.
struct Taps {
  int count = 0;
  std::vector<int> first;     // by new cell
  std::vector<float> weight;  // (new cells x count), each row sums to 1
};

double CatmullRom(double t) {
  t = std::abs(t);
  if (t < 1.0) return (1.5 * t - 2.5) * t * t + 1.0;
  if (t < 2.0) return ((-0.5 * t + 2.5) * t - 4.0) * t + 2.0;
  return 0.0;
}

Taps MakeTaps(int source, int target) {
  const double ratio = static_cast<double>(source) / target;  // source cells a new cell
  const bool coarser = ratio > 1.0;
  const double support = coarser ? ratio : 2.0;
  Taps taps;
  taps.count = static_cast<int>(std::ceil(2.0 * support)) + 1;
  taps.first.resize(target);
  taps.weight.resize(static_cast<std::size_t>(target) * taps.count);
  for (int i = 0; i < target; ++i) {
    const double center = (i + 0.5) * ratio - 0.5;
    taps.first[i] = static_cast<int>(std::ceil(center - support));
    float* weight = taps.weight.data() + static_cast<std::size_t>(i) * taps.count;
    double total = 0.0;
    for (int k = 0; k < taps.count; ++k) {
      const double t = taps.first[i] + k - center;
      const double w = coarser ? std::max(0.0, 1.0 - std::abs(t) / support) : CatmullRom(t);
      weight[k] = static_cast<float>(w);
      total += w;
    }
    for (int k = 0; k < taps.count; ++k) weight[k] = static_cast<float>(weight[k] / total);
  }
  return taps;
}

}  // namespace

Grid<float> Resample(const Grid<float>& values, int rows, int cols, int threads) {
  if (values.rows() == rows && values.cols() == cols) return values;
  const Taps vertical = MakeTaps(values.rows(), rows);
  const Taps horizontal = MakeTaps(values.cols(), cols);
  // A row padded on both sides spares the clamping of every tap.
  const int margin = horizontal.count + 1;
  Grid<float> result(rows, cols);
  threads = internal::GridThreads(result.size(), threads);
  ParallelFor(rows, threads, [&](int begin, int end) {
    std::vector<float> line(static_cast<std::size_t>(values.cols()) + 2 * margin);
    for (int r = begin; r < end; ++r) {
      float* middle = line.data() + margin;
      std::fill(line.begin(), line.end(), 0.0f);
      for (int k = 0; k < vertical.count; ++k) {
        const float weight = vertical.weight[static_cast<std::size_t>(r) * vertical.count + k];
        if (weight == 0.0f) continue;
        const float* source = values.row(std::clamp(vertical.first[r] + k, 0, values.rows() - 1));
        for (int c = 0; c < values.cols(); ++c) middle[c] += weight * source[c];
      }
      std::fill(line.begin(), line.begin() + margin, middle[0]);
      std::fill(line.end() - margin, line.end(), middle[values.cols() - 1]);
      float* target = result.row(r);
      for (int c = 0; c < cols; ++c) {
        const float* weight =
            horizontal.weight.data() + static_cast<std::size_t>(c) * horizontal.count;
        const float* source = middle + horizontal.first[c];
        float sum = 0.0f;
        for (int k = 0; k < horizontal.count; ++k) sum += weight[k] * source[k];
        target[c] = sum;
      }
    }
  });
  return result;
}

}  // namespace latticeworld
