#ifndef LATTICEWORLD_GEOMETRY_GRID_H_
#define LATTICEWORLD_GEOMETRY_GRID_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace latticeworld {

// Row 0 is the north (upper) edge, column 0 the west (left) edge.
struct CellIndex {
  int row = 0;
  int col = 0;
  friend bool operator==(CellIndex a, CellIndex b) { return a.row == b.row && a.col == b.col; }
  friend bool operator!=(CellIndex a, CellIndex b) { return !(a == b); }
};

// A dense matrix of cells, (rows x cols), row-major, row 0 north. It knows no metres: GridGeometry
// places it in the world.
template <typename T>
class Grid {
 public:
  Grid() = default;
  Grid(int rows, int cols, T value = T{})
      : rows_(rows),
        cols_(cols),
        cells_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols), value) {}

  int rows() const { return rows_; }
  int cols() const { return cols_; }
  std::size_t size() const { return cells_.size(); }
  bool empty() const { return cells_.empty(); }

  T& operator()(int row, int col) { return cells_[Offset(row, col)]; }
  const T& operator()(int row, int col) const { return cells_[Offset(row, col)]; }
  T& operator[](CellIndex cell) { return (*this)(cell.row, cell.col); }
  const T& operator[](CellIndex cell) const { return (*this)(cell.row, cell.col); }

  bool Contains(CellIndex cell) const {
    return cell.row >= 0 && cell.row < rows_ && cell.col >= 0 && cell.col < cols_;
  }
  // The value of the nearest cell inside.
  const T& Clamped(int row, int col) const {
    return (*this)(std::clamp(row, 0, rows_ - 1), std::clamp(col, 0, cols_ - 1));
  }

  T* row(int r) { return cells_.data() + Offset(r, 0); }
  const T* row(int r) const { return cells_.data() + Offset(r, 0); }
  T* data() { return cells_.data(); }
  const T* data() const { return cells_.data(); }
  typename std::vector<T>::iterator begin() { return cells_.begin(); }
  typename std::vector<T>::iterator end() { return cells_.end(); }
  typename std::vector<T>::const_iterator begin() const { return cells_.begin(); }
  typename std::vector<T>::const_iterator end() const { return cells_.end(); }

  friend bool operator==(const Grid& a, const Grid& b) {
    return a.rows_ == b.rows_ && a.cols_ == b.cols_ && a.cells_ == b.cells_;
  }
  friend bool operator!=(const Grid& a, const Grid& b) { return !(a == b); }

 private:
  std::size_t Offset(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols_) +
           static_cast<std::size_t>(col);
  }

  int rows_ = 0;
  int cols_ = 0;
  std::vector<T> cells_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMETRY_GRID_H_
