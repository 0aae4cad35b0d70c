#ifndef LATTICEWORLD_TERRAIN_COMPONENTS_H_
#define LATTICEWORLD_TERRAIN_COMPONENTS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// The 8-connected pieces of a mask, numbered by their first cell in row-major order.
struct Components {
  Grid<std::int32_t> label;         // (rows x cols), -1 outside the mask
  std::vector<std::int32_t> cells;  // row * cols + col of every cell, piece after piece
  std::vector<std::int32_t> begin;  // piece i is cells[begin[i]] .. cells[begin[i + 1] - 1]

  int count() const { return static_cast<int>(begin.size()) - 1; }
};

Components ComponentsOf(const Grid<unsigned char>& mask);

// Calls visit(row, col) for the up to 8 neighbours of a cell that lie in the grid, row by row.
template <typename T, typename Visit>
void ForEachNeighbour(const Grid<T>& grid, int row, int col, Visit visit) {
  const int row_end = row + 1 < grid.rows() ? row + 1 : row;
  const int col_begin = col > 0 ? col - 1 : col;
  const int col_end = col + 1 < grid.cols() ? col + 1 : col;
  for (int r = row > 0 ? row - 1 : row; r <= row_end; ++r) {
    for (int c = col_begin; c <= col_end; ++c) {
      if (r != row || c != col) visit(r, c);
    }
  }
}

// The value below which `share` in [0, 1] of the values lie. values: not empty, reordered.
float Quantile(double share, std::vector<float>* values);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_COMPONENTS_H_
