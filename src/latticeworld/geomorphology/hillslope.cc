#include "latticeworld/geomorphology/hillslope.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/drainage.h"

namespace latticeworld::internal {
namespace {

constexpr int kLanes = 16;  // lines solved side by side, since a line waits for itself

// Solves (1 + a + c) x_i - a x_(i-1) - c x_(i+1) = h_i along kLanes lines at once (Thomas 1949),
// where a and c are `number` towards a neighbour and 0 at the ends and in cells that stay.
class LineSolver {
 public:
  LineSolver(int length, float number)
      : length_(length), number_(number), ratio_(static_cast<std::size_t>(length) * kLanes) {}

  // height: (length x kLanes), in and out. loose: 1 where a cell moves, 0 where it stays.
  void Solve(const float* loose, float* height) {
    // Downward: x_i = h_i + ratio_i * x_(i+1), and rest_i = 1 - ratio_i, kept since a difference of
    // two numbers near 1 would lose the small one.
    float h_before[kLanes] = {};
    float rest[kLanes] = {};
    for (int i = 0; i < length_; ++i) {
      const float before = i > 0 ? number_ : 0.0f;
      const float after = i + 1 < length_ ? number_ : 0.0f;
      const std::size_t line = static_cast<std::size_t>(i) * kLanes;
      for (int k = 0; k < kLanes; ++k) {
        const float a = before * loose[line + k];
        const float c = after * loose[line + k];
        const float kept = 1.0f + a * rest[k];
        const float inverse = 1.0f / (kept + c);
        ratio_[line + k] = c * inverse;
        rest[k] = kept * inverse;
        h_before[k] = (height[line + k] + a * h_before[k]) * inverse;
        height[line + k] = h_before[k];
      }
    }
    float h_after[kLanes] = {};
    for (int i = length_ - 1; i >= 0; --i) {
      const std::size_t line = static_cast<std::size_t>(i) * kLanes;
      for (int k = 0; k < kLanes; ++k) {
        h_after[k] = height[line + k] + ratio_[line + k] * h_after[k];
        height[line + k] = h_after[k];
      }
    }
  }

 private:
  int length_;
  float number_;
  std::vector<float> ratio_;  // (length x kLanes)
};

// Which cells lie along the lines of a group: cell i of line k is first + k * line_step + i *
// cell_step.
struct LineGroup {
  std::size_t first;
  int lines;  // up to kLanes
  std::size_t line_step;
  int length;
  std::size_t cell_step;

  // Calls visit(slot, cell), slot = i * kLanes + k, in an order that is near in memory on both
  // sides.
  template <typename Visit>
  void ForEach(Visit visit) const {
    if (line_step == 1) {
      for (int i = 0; i < length; ++i) {
        for (int k = 0; k < lines; ++k) visit(i * kLanes + k, first + k + i * cell_step);
      }
      return;
    }
    for (int block = 0; block < length; block += kLanes) {
      const int block_end = std::min(block + kLanes, length);
      for (int k = 0; k < lines; ++k) {
        for (int i = block; i < block_end; ++i) {
          visit(i * kLanes + k, first + k * line_step + i * cell_step);
        }
      }
    }
  }
};

// group: of the first lines; the others follow it.
void SolveLines(float number, const LineGroup& group, int lines,
                const std::vector<std::uint8_t>& directions, int threads, Grid<float>* height_m) {
  const int groups = (lines + kLanes - 1) / kLanes;
  ParallelFor(groups, threads, [&](int begin, int end) {
    LineSolver solver(group.length, number);
    // The lanes beyond the last line idle along.
    std::vector<float> height(static_cast<std::size_t>(group.length) * kLanes, 0.0f);
    std::vector<float> loose(height.size(), 0.0f);
    float* land_m = height_m->data();
    for (int g = begin; g < end; ++g) {
      LineGroup here = group;
      here.first = static_cast<std::size_t>(g) * kLanes * group.line_step;
      here.lines = std::min(kLanes, lines - g * kLanes);
      here.ForEach([&](int slot, std::size_t cell) {
        height[slot] = land_m[cell];
        loose[slot] = directions[cell] == kOutlet ? 0.0f : 1.0f;
      });
      solver.Solve(loose.data(), height.data());
      here.ForEach([&](int slot, std::size_t cell) { land_m[cell] = height[slot]; });
    }
  });
}

}  // namespace

void Diffuse(double number, const std::vector<std::uint8_t>& directions, bool rows_first,
             int threads, Grid<float>* height_m) {
  const int rows = height_m->rows();
  const int cols = height_m->cols();
  const auto step = static_cast<float>(number);
  const LineGroup along_rows{0, kLanes, static_cast<std::size_t>(cols), cols, 1};
  const LineGroup along_cols{0, kLanes, 1, rows, static_cast<std::size_t>(cols)};
  if (rows_first) SolveLines(step, along_rows, rows, directions, threads, height_m);
  SolveLines(step, along_cols, cols, directions, threads, height_m);
  if (!rows_first) SolveLines(step, along_rows, rows, directions, threads, height_m);
}

}  // namespace latticeworld::internal
