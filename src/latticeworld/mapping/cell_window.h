#ifndef LATTICEWORLD_MAPPING_CELL_WINDOW_H_
#define LATTICEWORLD_MAPPING_CELL_WINDOW_H_

namespace latticeworld {

// Cells [row_begin, row_end) x [col_begin, col_end) of a scene's geometry.
struct CellWindow {
  int row_begin = 0, row_end = 0;
  int col_begin = 0, col_end = 0;

  int rows() const { return row_end - row_begin; }
  int cols() const { return col_end - col_begin; }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_CELL_WINDOW_H_
