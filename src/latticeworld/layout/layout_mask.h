#ifndef LATTICEWORLD_LAYOUT_LAYOUT_MASK_H_
#define LATTICEWORLD_LAYOUT_LAYOUT_MASK_H_

#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// A set of cells of a layout, one bit a cell: what takes a walk over 1024 cells otherwise takes 32
// word operations, so that thousands of layouts can be measured while one is searched for.
class LayoutMask {
 public:
  LayoutMask() = default;
  static LayoutMask All();

  bool Contains(CellIndex cell) const { return (rows_[Row(cell)] >> cell.col & 1u) != 0; }
  void Add(CellIndex cell) { rows_[Row(cell)] |= 1u << cell.col; }
  void Remove(CellIndex cell) { rows_[Row(cell)] &= ~(1u << cell.col); }
  bool empty() const;
  int count() const;
  // Bit c of row r is the cell in row r (from the north), column c (from the west).
  std::uint32_t row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
  void set_row(int index, std::uint32_t bits) { rows_[static_cast<std::size_t>(index)] = bits; }

  LayoutMask operator&(const LayoutMask& other) const;
  LayoutMask operator|(const LayoutMask& other) const;
  LayoutMask operator-(const LayoutMask& other) const;  // cells of this that are not of other
  LayoutMask operator~() const;
  bool operator==(const LayoutMask& other) const { return rows_ == other.rows_; }

  // These add every cell that is at most one step away: 4 neighbours, 8 neighbours.
  LayoutMask Grown4() const;
  LayoutMask Grown8() const;
  // Adds every cell that is at most `steps` king's moves away.
  LayoutMask Grown8(int steps) const;
  // The 8-connected (4-connected) cells of this set that hang together with `start`.
  LayoutMask Flooded8(const LayoutMask& start) const;
  LayoutMask Flooded4(const LayoutMask& start) const;
  // 8-connected pieces, largest first (ties: the first cell in row-major order).
  std::vector<LayoutMask> Pieces() const;
  // The first cell in row-major order. The set must not be empty.
  CellIndex FirstCell() const;
  // Mean row and column. The set must not be empty.
  struct Point {
    double row = 0.0;
    double col = 0.0;
  };
  Point Centroid() const;

 private:
  static std::size_t Row(CellIndex cell) { return static_cast<std::size_t>(cell.row); }
  std::array<std::uint32_t, kLayoutSize> rows_{};
};

// The cells of a letter.
LayoutMask MaskOf(const SymbolicLayout& layout, char letter);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_LAYOUT_MASK_H_
