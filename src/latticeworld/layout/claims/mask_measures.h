#ifndef LATTICEWORLD_LAYOUT_CLAIMS_MASK_MEASURES_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_MASK_MEASURES_H_

#include <vector>

#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {

// No two cells are so many king's moves apart: the gap to a set that is empty.
inline constexpr int kNoGap = kLayoutSize;

// The least number of king's moves from a cell of one set to a cell of the other: 0 where they
// overlap, 1 where they touch, kNoGap when a set is empty.
int GapBetween(const LayoutMask& a, const LayoutMask& b);

// Returns the set without stray cells: those with no neighbour of the set among their eight, if
// they are together less than a tenth of the set.
LayoutMask WithoutStrays(const LayoutMask& cells);

// The set with what it encloses: the cells that no way of 4-neighbours outside of it leads from to
// the rim of the layout.
LayoutMask WithHolesFilled(const LayoutMask& cells);

// The 4-connected pieces of a set, in row-major order of their first cells.
std::vector<LayoutMask> Pieces4(const LayoutMask& cells);

// Mean and axes of the ellipse that has a set's second moments (a cell is a unit square).
struct PrincipalAxes {
  LayoutMask::Point center;
  LayoutMask::Point axis;  // of the greater variance: a unit vector
  double length = 0.0;     // full axes [cells]
  double width = 0.0;
};
// The set must not be empty.
PrincipalAxes PrincipalAxesOf(const LayoutMask& cells);

// Calls visit(CellIndex) for every cell in row-major order.
template <typename Visit>
void ForEachCell(const LayoutMask& cells, Visit&& visit) {
  for (int row = 0; row < kLayoutSize; ++row) {
    for (std::uint32_t bits = cells.row(row); bits != 0; bits &= bits - 1) {
      visit(CellIndex{row, __builtin_ctz(bits)});
    }
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_MASK_MEASURES_H_
