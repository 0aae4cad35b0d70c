#include "latticeworld/geomorphology/distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {
namespace {

constexpr int kColumnBlock = 16;  // columns read together: one cache line of floats

// The lower envelope of the parabolas of one line, reused from line to line.
class LineEnvelope {
 public:
  LineEnvelope(int length, double curvature)
      : curvature_(curvature), root_(length), lifted_(length), from_(length + 1) {}

  void Apply(int length, float* line) {
    int count = 0;
    const double half_inverse = 0.5 / curvature_;
    for (int q = 0; q < length; ++q) {
      if (line[q] == kNoFeature) continue;
      const double lifted = line[q] + curvature_ * q * q;
      double start = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        start = (lifted - lifted_[count - 1]) * half_inverse / (q - root_[count - 1]);
        if (start > from_[count - 1]) break;
        --count;
      }
      if (count == 0) start = -std::numeric_limits<double>::infinity();
      root_[count] = q;
      lifted_[count] = lifted;
      from_[count] = start;
      ++count;
    }
    if (count == 0) return;
    from_[count] = std::numeric_limits<double>::infinity();
    int k = 0;
    for (int x = 0; x < length;) {
      while (from_[k + 1] < x) ++k;
      const int end = static_cast<int>(std::min<double>(length, std::floor(from_[k + 1]) + 1.0));
      const double root = root_[k];
      const double height = lifted_[k] - curvature_ * root * root;
      for (; x < end; ++x) {
        line[x] = static_cast<float>(height + curvature_ * (x - root) * (x - root));
      }
    }
  }

 private:
  double curvature_;
  std::vector<int> root_;       // apex of the k-th parabola of the envelope
  std::vector<double> lifted_;  // its value there + curvature * root^2
  std::vector<double> from_;    // it is lowest from here
};

}  // namespace

void LowerEnvelope(double curvature, Grid<float>* values, int threads) {
  const int rows = values->rows();
  const int cols = values->cols();
  threads = internal::GridThreads(values->size(), threads);
  const int blocks = (cols + kColumnBlock - 1) / kColumnBlock;
  ParallelFor(blocks, threads, [&](int first, int end) {
    LineEnvelope envelope(rows, curvature);
    std::vector<float> block(static_cast<std::size_t>(kColumnBlock) * rows);
    for (int begin = first * kColumnBlock; begin < end * kColumnBlock; begin += kColumnBlock) {
      const int width = std::min(kColumnBlock, cols - begin);
      for (int r = 0; r < rows; ++r) {
        const float* source = values->row(r) + begin;
        for (int c = 0; c < width; ++c) block[static_cast<std::size_t>(c) * rows + r] = source[c];
      }
      for (int c = 0; c < width; ++c) {
        envelope.Apply(rows, block.data() + static_cast<std::size_t>(c) * rows);
      }
      for (int r = 0; r < rows; ++r) {
        float* target = values->row(r) + begin;
        for (int c = 0; c < width; ++c) target[c] = block[static_cast<std::size_t>(c) * rows + r];
      }
    }
  });
  ParallelFor(rows, threads, [&](int first, int end) {
    LineEnvelope envelope(cols, curvature);
    for (int r = first; r < end; ++r) envelope.Apply(cols, values->row(r));
  });
}

Grid<float> DistanceTo(bool feature, const Grid<unsigned char>& mask, int threads) {
  Grid<float> distance(mask.rows(), mask.cols());
  std::transform(mask.begin(), mask.end(), distance.begin(), [feature](unsigned char value) {
    return (value != 0) == feature ? 0.0f : kNoFeature;
  });
  LowerEnvelope(1.0, &distance, threads);
  for (float& value : distance) value = std::sqrt(value);
  return distance;
}

}  // namespace latticeworld
