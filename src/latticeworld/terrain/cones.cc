#include "latticeworld/terrain/cones.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "latticeworld/terrain/components.h"

namespace latticeworld::internal {
namespace {

constexpr float kRoot2 = 1.41421356f, kRoot5 = 2.23606798f;
constexpr int kMargin = 2;

// Values of a grid with a margin, and what stands beside each.
class Padded {
 public:
  Padded(const Grid<float>& values, float beyond)
      : rows_(values.rows()), cols_(values.cols()), width_(cols_ + 2 * kMargin) {
    cells_.assign(static_cast<std::size_t>(rows_ + 2 * kMargin) * width_, beyond);
    for (int r = 0; r < rows_; ++r) std::copy(values.row(r), values.row(r) + cols_, row(r));
  }
  int rows() const { return rows_; }
  int cols() const { return cols_; }
  float* row(int r) { return cells_.data() + (r + kMargin) * std::ptrdiff_t{width_} + kMargin; }
  void CopyTo(Grid<float>* values) {
    for (int r = 0; r < rows_; ++r) std::copy(row(r), row(r) + cols_, values->row(r));
  }

 private:
  int rows_;
  int cols_;
  int width_;
  std::vector<float> cells_;
};

// What a cell hears from the two rows beside it, the nearer one first.
template <typename Rise>  // float of a column
void RelaxAcross(int cols, Rise rise_of, const float* near, const float* far, float* values) {
  for (int c = 0; c < cols; ++c) {
    const float rise = rise_of(c);
    const float straight = near[c] + rise;
    const float diagonal = std::min(near[c - 1], near[c + 1]) + rise * kRoot2;
    const float knight =
        std::min(std::min(near[c - 2], near[c + 2]), std::min(far[c - 1], far[c + 1])) +
        rise * kRoot5;
    values[c] = std::min(std::min(values[c], straight), std::min(diagonal, knight));
  }
}

template <typename RiseOfRow>  // gives a function of the column for a row
void SweepCones(RiseOfRow rise_of_row, Grid<float>* values) {
  Padded padded(*values, std::numeric_limits<float>::infinity());
  const int rows = padded.rows(), cols = padded.cols();
  for (int r = 0; r < rows; ++r) {
    float* row = padded.row(r);
    const auto rise_of = rise_of_row(r);
    RelaxAcross(cols, rise_of, padded.row(r - 1), padded.row(r - 2), row);
    for (int c = 0; c < cols; ++c) row[c] = std::min(row[c], row[c - 1] + rise_of(c));
  }
  for (int r = rows - 1; r >= 0; --r) {
    float* row = padded.row(r);
    const auto rise_of = rise_of_row(r);
    RelaxAcross(cols, rise_of, padded.row(r + 1), padded.row(r + 2), row);
    for (int c = cols - 1; c >= 0; --c) row[c] = std::min(row[c], row[c + 1] + rise_of(c));
  }
  padded.CopyTo(values);
}

void Negate(Grid<float>* values) {
  for (float& value : *values) value = -value;
}

}  // namespace

void LowerCones(float rise_per_cell, Grid<float>* values) {
  SweepCones([rise_per_cell](int) { return [rise_per_cell](int) { return rise_per_cell; }; },
             values);
}

void LimitSlope(const Grid<float>& rise_per_cell, Grid<float>* values) {
  SweepCones(
      [&rise_per_cell](int r) {
        const float* rise = rise_per_cell.row(r);
        return [rise](int c) { return rise[c]; };
      },
      values);
}

void UpperCones(float fall_per_cell, Grid<float>* values) {
  Negate(values);
  LowerCones(fall_per_cell, values);
  Negate(values);
}

Grid<std::int32_t> NearestOf(const Grid<unsigned char>& mask) {
  // Whoever allows the least distance passes on whom it is nearest to.
  Grid<float> distance(mask.rows(), mask.cols(), std::numeric_limits<float>::infinity());
  Grid<std::int32_t> nearest(mask.rows(), mask.cols(), -1);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask.data()[i] == 0) continue;
    nearest.data()[i] = static_cast<std::int32_t>(i);
    distance.data()[i] = 0.0f;
  }
  LowerCones(1.0f, &distance);
  struct Step {
    int row;
    int col;
    float length;
  };
  constexpr Step kBefore[8] = {{0, -1, 1.0f},    {-1, 0, 1.0f},    {-1, -1, kRoot2},
                               {-1, 1, kRoot2},  {-1, -2, kRoot5}, {-1, 2, kRoot5},
                               {-2, -1, kRoot5}, {-2, 1, kRoot5}};
  const int rows = mask.rows(), cols = mask.cols();
  const auto follow = [&](int r, int c, int sign) {
    if (nearest(r, c) >= 0) return;
    const float here = distance(r, c);
    for (const Step& step : kBefore) {
      const int row = r + sign * step.row, col = c + sign * step.col;
      if (row < 0 || row >= rows || col < 0 || col >= cols || nearest(row, col) < 0) continue;
      // Sums of the same lengths in another order differ in their last bits.
      if (distance(row, col) + step.length > here * 1.00001f) continue;
      nearest(r, c) = nearest(row, col);
      return;
    }
  };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) follow(r, c, 1);
  }
  for (int r = rows - 1; r >= 0; --r) {
    for (int c = cols - 1; c >= 0; --c) follow(r, c, -1);
  }
  return nearest;
}

void LowerConesWithin(const Grid<unsigned char>& mask, float rise_per_cell, Grid<float>* values) {
  using Entry = std::pair<float, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const int cols = mask.cols();
  float* v = values->data();
  const auto relax_neighbours = [&](std::int32_t cell, auto improved) {
    const int row = cell / cols, col = cell % cols;
    ForEachNeighbour(mask, row, col, [&](int r, int c) {
      if (mask(r, c) == 0) return;
      const float length = r != row && c != col ? kRoot2 : 1.0f;
      const float there = v[cell] + rise_per_cell * length;
      if (there >= v[r * cols + c]) return;
      improved(r * cols + c, there);
    });
  };
  // Only cells that lie below what a neighbour allows pass anything on.
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(mask.size()); ++cell) {
    if (mask.data()[cell] == 0 || std::isinf(v[cell])) continue;
    bool passes = false;
    relax_neighbours(cell, [&passes](std::int32_t, float) { passes = true; });
    if (passes) queue.push({v[cell], cell});
  }
  while (!queue.empty()) {
    const auto [value, cell] = queue.top();
    queue.pop();
    if (value > v[cell]) continue;
    relax_neighbours(cell, [&](std::int32_t near, float there) {
      v[near] = there;
      queue.push({there, near});
    });
  }
}

void UpperConesWithin(const Grid<unsigned char>& mask, float fall_per_cell, Grid<float>* values) {
  Negate(values);
  LowerConesWithin(mask, fall_per_cell, values);
  Negate(values);
}

}  // namespace latticeworld::internal
