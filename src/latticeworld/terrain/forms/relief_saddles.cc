#include "latticeworld/terrain/forms/relief_saddles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/forms/relief_measures.h"

namespace latticeworld::internal {
namespace {

// Cells that are joined by land at least as high as what was joined so far.
class Joined {
 public:
  explicit Joined(std::size_t cells) : to_(cells) { std::iota(to_.begin(), to_.end(), 0); }
  int Root(int cell) {
    while (to_[static_cast<std::size_t>(cell)] != cell) {
      int& next = to_[static_cast<std::size_t>(cell)];
      next = to_[static_cast<std::size_t>(next)];
      cell = next;
    }
    return cell;
  }
  void Join(int a, int b) { to_[static_cast<std::size_t>(Root(a))] = Root(b); }

 private:
  std::vector<int> to_;
};

// The cell at which land from the one cell first meets land from the other, from the top down.
CellIndex KeyCol(const Grid<float>& height_m, CellIndex one, CellIndex other) {
  const int cols = height_m.cols();
  std::vector<int> order(height_m.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return height_m.data()[a] > height_m.data()[b]; });
  const int from = one.row * cols + one.col, to = other.row * cols + other.col;
  Joined joined(height_m.size());
  std::vector<unsigned char> seen(height_m.size(), 0);
  for (const int cell : order) {
    seen[static_cast<std::size_t>(cell)] = 1;
    ForEachNeighbour(height_m, cell / cols, cell % cols, [&](int r, int c) {
      const int next = r * cols + c;
      if (seen[static_cast<std::size_t>(next)] != 0) joined.Join(cell, next);
    });
    if (seen[static_cast<std::size_t>(from)] != 0 && seen[static_cast<std::size_t>(to)] != 0 &&
        joined.Root(from) == joined.Root(to)) {
      return {cell / cols, cell % cols};
    }
  }
  return one;
}

double MedianAround(const GridGeometry& geometry, const Grid<float>& height_m, WorldPoint at,
                    double radius_m) {
  std::vector<float> ground;
  for (int r = 0; r < geometry.rows(); ++r) {
    for (int c = 0; c < geometry.cols(); ++c) {
      const WorldPoint point = geometry.CenterOf({r, c});
      if (std::hypot(point.x_m - at.x_m, point.y_m - at.y_m) <= radius_m) {
        ground.push_back(height_m(r, c));
      }
    }
  }
  return ground.empty() ? -std::numeric_limits<double>::infinity() : Quantile(0.5, &ground);
}

}  // namespace

SaddleRelief MeasureSaddle(const ReliefPiece& one, const ReliefPiece& other,
                           const GridGeometry& geometry, const Grid<float>& height_m) {
  constexpr int kCells = 256;  // passes are wide: fewer cells tell as much
  if (geometry.rows() > kCells) {
    const GridGeometry coarse = GridGeometry::FromCells(kCells, geometry.size_m());
    return MeasureSaddle(one, other, coarse, Resample(height_m, kCells, kCells));
  }
  const WorldPoint a = MiddleOf(one, geometry, height_m), b = MiddleOf(other, geometry, height_m);
  const CellIndex top = geometry.CellAt(a), other_top = geometry.CellAt(b);
  const CellIndex col = KeyCol(height_m, top, other_top);
  SaddleRelief saddle;
  saddle.pass = geometry.CenterOf(col);
  saddle.pass_m = height_m[col];
  saddle.top_m = std::min(height_m[top], height_m[other_top]);
  const double half_m = std::min(one.half_width_m, other.half_width_m);
  const double length_m = std::max(std::hypot(b.x_m - a.x_m, b.y_m - a.y_m), 1e-9);
  const double across_x = half_m * (a.y_m - b.y_m) / length_m;
  const double across_y = half_m * (b.x_m - a.x_m) / length_m;
  saddle.side_m = -std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const WorldPoint at = {saddle.pass.x_m + side * across_x, saddle.pass.y_m + side * across_y};
    saddle.side_m = std::max(saddle.side_m, MedianAround(geometry, height_m, at, 0.25 * half_m));
  }
  return saddle;
}

}  // namespace latticeworld::internal
