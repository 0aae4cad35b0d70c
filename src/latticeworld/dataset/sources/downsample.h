#ifndef LATTICEWORLD_DATASET_SOURCES_DOWNSAMPLE_H_
#define LATTICEWORLD_DATASET_SOURCES_DOWNSAMPLE_H_

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// Marks a pixel of a mask that nothing is known of.
inline constexpr char kNoData = '\0';

// The grid turned anticlockwise by quarter_turns * 90 degrees.
template <typename T>
Grid<T> Turned(const Grid<T>& grid, int quarter_turns) {
  const int turns = ((quarter_turns % 4) + 4) % 4;
  const int rows = grid.rows(), cols = grid.cols();
  Grid<T> turned(turns % 2 == 0 ? rows : cols, turns % 2 == 0 ? cols : rows);
  for (int r = 0; r < turned.rows(); ++r) {
    for (int c = 0; c < turned.cols(); ++c) {
      turned(r, c) = turns == 0   ? grid(r, c)
                     : turns == 1 ? grid(c, cols - 1 - r)
                     : turns == 2 ? grid(rows - 1 - r, cols - 1 - c)
                                  : grid(rows - 1 - c, r);
    }
  }
  return turned;
}

// The layout of a segmented picture. A cell takes the letter that most of its pixels have, but
// roads and rivers thinner than 1.25 cells, of whatever width, become lines one cell wide that hang
// together as they do in the picture (line_cells.h); the remains of an area's edge do not. Where
// both run through a cell the road counts. A cell without data takes the letter of the cells
// around it. mask: letters of the vocabulary or kNoData, (rows x cols), row 0 north, spanning the
// layout whatever its shape.
//
// A turned mask gives the layout turned: all choices between equals are made in one of the four
// orientations, which the pixels decide. Only a mask that is itself the same when turned may give a
// layout that is not.
//
// Errors: INVALID_ARGUMENT (a side of less than 32 pixels; more than half of them no data).
Result<SymbolicLayout> Downsample(const Grid<char>& mask, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_DOWNSAMPLE_H_
