#ifndef LATTICEWORLD_LAYOUT_CLAIMS_LINE_FRAME_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_LINE_FRAME_H_

#include <vector>

#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {

// A connected set of cells as a line: from one of its ends, the cell that is farthest along it,
// each cell has a number of steps. Distances are king's moves within the set.
struct LineFrame {
  int length = 0;                  // steps from the first end to the farthest cell
  std::vector<LayoutMask> levels;  // (length + 1), the cells that are so many steps from the end

  // The mean cells of the levels: the line's course without its width.
  std::vector<LayoutMask::Point> CenterLine() const;
};

// The set must be one 8-connected piece.
LineFrame LineFrameOf(const LayoutMask& piece);

// Length over width of the piece that both were made from, straight across it or along it where it
// is bent, whichever is more.
double SlimnessOf(const PrincipalAxes& axes, const LineFrame& frame);

// What lies at most `steps` king's moves to the left and to the right of the line, going along it
// from its first end; never its own cells.
struct LineSides {
  LayoutMask left;
  LayoutMask right;
};
LineSides SidesOf(const LayoutMask& piece, const LineFrame& frame, int steps);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_LINE_FRAME_H_
