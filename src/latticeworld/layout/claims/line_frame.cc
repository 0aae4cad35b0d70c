#include "latticeworld/layout/claims/line_frame.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace latticeworld {
namespace {

std::vector<LayoutMask> LevelsFrom(const LayoutMask& piece, CellIndex start) {
  LayoutMask front, reached;
  front.Add(start);
  std::vector<LayoutMask> levels;
  while (!front.empty()) {
    levels.push_back(front);
    reached = reached | front;
    front = (front.Grown8() & piece) - reached;
  }
  return levels;
}

}  // namespace

std::vector<LayoutMask::Point> LineFrame::CenterLine() const {
  std::vector<LayoutMask::Point> points;
  points.reserve(levels.size());
  for (const LayoutMask& level : levels) points.push_back(level.Centroid());
  return points;
}

LineFrame LineFrameOf(const LayoutMask& piece) {
  // The farthest cell from anywhere is an end; the farthest from it is the other end.
  const CellIndex end = LevelsFrom(piece, piece.FirstCell()).back().FirstCell();
  LineFrame frame;
  frame.levels = LevelsFrom(piece, end);
  frame.length = static_cast<int>(frame.levels.size()) - 1;
  return frame;
}

double SlimnessOf(const PrincipalAxes& axes, const LineFrame& frame) {
  double area = 0.0;
  for (const LayoutMask& level : frame.levels) area += level.count();
  const double length = frame.length + 1;
  // The square of a disc's diameter is 1.27 times its area: with this factor it is 1 both ways.
  constexpr double kAlong = 0.8;
  return std::max(axes.length / axes.width, kAlong * length * length / area);
}

LineSides SidesOf(const LayoutMask& piece, const LineFrame& frame, int steps) {
  // A cell's level is how far along the line it lies.
  std::array<std::array<std::int16_t, kLayoutSize>, kLayoutSize> level{};
  for (std::size_t i = 0; i < frame.levels.size(); ++i) {
    ForEachCell(frame.levels[i], [&](CellIndex cell) {
      level[static_cast<std::size_t>(cell.row)][static_cast<std::size_t>(cell.col)] =
          static_cast<std::int16_t>(i);
    });
  }
  // Each cell beside the line has a turn: the sum over the line's cells next to it of the cross
  // product of the way on and the way to it. Positive: to the right, as rows grow to the south.
  std::array<std::array<int, kLayoutSize>, kLayoutSize> turn{};
  const auto inside = [](int row, int col) {
    return row >= 0 && row < kLayoutSize && col >= 0 && col < kLayoutSize;
  };
  ForEachCell(piece & (~piece).Grown8(), [&](CellIndex cell) {
    // The way on: the gradient of the level over the neighbourhood.
    const int own = level[static_cast<std::size_t>(cell.row)][static_cast<std::size_t>(cell.col)];
    int on_row = 0, on_col = 0;
    constexpr int kReach = 2;
    for (int dr = -kReach; dr <= kReach; ++dr) {
      for (int dc = -kReach; dc <= kReach; ++dc) {
        const int row = cell.row + dr, col = cell.col + dc;
        if (!inside(row, col) || !piece.Contains({row, col})) continue;
        const int rise = level[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)] - own;
        on_row += rise * dr;
        on_col += rise * dc;
      }
    }
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        const int row = cell.row + dr, col = cell.col + dc;
        if (!inside(row, col)) continue;
        turn[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)] +=
            on_col * dr - on_row * dc;
      }
    }
  });
  // The sign of its turn says on which side a cell lies; further cells follow their neighbours.
  LineSides sides;
  ForEachCell(piece.Grown8() - piece, [&](CellIndex cell) {
    const int side = turn[static_cast<std::size_t>(cell.row)][static_cast<std::size_t>(cell.col)];
    if (side > 0) sides.right.Add(cell);
    if (side < 0) sides.left.Add(cell);
  });
  for (int step = 1; step < steps; ++step) {
    const LayoutMask taken = piece | sides.left | sides.right;
    const LayoutMask left = sides.left.Grown8() - taken, right = sides.right.Grown8() - taken;
    sides.left = sides.left | left;
    sides.right = sides.right | right;
  }
  return sides;
}

}  // namespace latticeworld
