#include "latticeworld/layout/claims/mask_measures.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

int GapBetween(const LayoutMask& a, const LayoutMask& b) {
  if (a.empty() || b.empty()) return kNoGap;
  LayoutMask grown = a;
  for (int gap = 0; gap < kNoGap; ++gap) {
    if (!(grown & b).empty()) return gap;
    grown = grown.Grown8();
  }
  return kNoGap;
}

LayoutMask WithoutStrays(const LayoutMask& cells) {
  LayoutMask strays;
  const auto row = [&](int index) {
    return index < 0 || index >= kLayoutSize ? 0u : cells.row(index);
  };
  for (int r = 0; r < kLayoutSize; ++r) {
    const std::uint32_t above = row(r - 1) | row(r + 1);
    const std::uint32_t near = above | above << 1 | above >> 1 | row(r) << 1 | row(r) >> 1;
    strays.set_row(r, row(r) & ~near);
  }
  return 10 * strays.count() < cells.count() ? cells - strays : cells;
}

LayoutMask WithHolesFilled(const LayoutMask& cells) {
  const LayoutMask outside = ~cells;
  LayoutMask rim;
  for (int row = 0; row < kLayoutSize; ++row) rim.set_row(row, 0x80000001u);
  rim.set_row(0, ~0u);
  rim.set_row(kLayoutSize - 1, ~0u);
  return ~outside.Flooded4(rim);
}

std::vector<LayoutMask> Pieces4(const LayoutMask& cells) {
  std::vector<LayoutMask> pieces;
  for (LayoutMask left = cells; !left.empty();) {
    LayoutMask start;
    start.Add(left.FirstCell());
    pieces.push_back(left.Flooded4(start));
    left = left - pieces.back();
  }
  return pieces;
}

PrincipalAxes PrincipalAxesOf(const LayoutMask& cells) {
  double count = 0.0, rows = 0.0, cols = 0.0, row_row = 0.0, row_col = 0.0, col_col = 0.0;
  ForEachCell(cells, [&](CellIndex cell) {
    count += 1.0;
    rows += cell.row;
    cols += cell.col;
    row_row += cell.row * cell.row;
    row_col += cell.row * cell.col;
    col_col += cell.col * cell.col;
  });
  PrincipalAxes axes;
  axes.center = {rows / count, cols / count};
  // A unit square alone has a variance of a twelfth.
  const double vrr = row_row / count - axes.center.row * axes.center.row + 1.0 / 12.0;
  const double vcc = col_col / count - axes.center.col * axes.center.col + 1.0 / 12.0;
  const double vrc = row_col / count - axes.center.row * axes.center.col;
  const double mean = 0.5 * (vrr + vcc);
  const double spread = std::hypot(0.5 * (vrr - vcc), vrc);
  const double angle = 0.5 * std::atan2(2.0 * vrc, vcc - vrr);  // from the column axis
  axes.axis = {std::sin(angle), std::cos(angle)};
  // A full axis of an ellipse is four standard deviations.
  axes.length = 4.0 * std::sqrt(mean + spread);
  axes.width = 4.0 * std::sqrt(std::max(mean - spread, 0.0));
  return axes;
}

}  // namespace latticeworld
