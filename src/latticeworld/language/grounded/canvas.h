#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_CANVAS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_CANVAS_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "latticeworld/geometry/region.h"
#include "latticeworld/layout/claims.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// The middle of a layout's cell in relative coordinates.
inline double UnitOf(int index) { return (index + 0.5) / kLayoutSize; }
inline bool IsIn(const UnitBox& box, CellIndex cell) {
  return box.Contains(UnitOf(cell.col), UnitOf(cell.row));
}
// How far the cell lies outside the box [cells]; 0 inside.
double CellsOutside(const UnitBox& box, CellIndex cell);

inline constexpr int kNeighbours8[8][2] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                           {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};  // row, col; the
                                                                                 // first four share
                                                                                 // a side

// A layout in the making.
class Canvas {
 public:
  static constexpr char kFree = '\0';

  // claims: those of kind kAbsent say where a letter must not lie. relief: or nullptr.
  Canvas(const std::vector<Claim>& claims, const Relief* relief);

  char at(CellIndex cell) const { return cells_[cell]; }
  int piece_at(CellIndex cell) const { return pieces_[cell]; }  // -1: none
  bool locked(CellIndex cell) const { return locked_[cell] != 0; }
  bool Contains(CellIndex cell) const { return cells_.Contains(cell); }

  void Paint(CellIndex cell, char letter, int piece) {
    cells_[cell] = letter;
    pieces_[cell] = piece;
  }
  void Lock(CellIndex cell) { locked_[cell] = 1; }
  int NewPiece() { return next_piece_++; }

  // Whether an instruction forbids the letter in this cell.
  bool IsForbidden(char letter, CellIndex cell) const;
  // How little the relief likes the letter here, [0, 1]; 0 without a relief.
  double Aversion(char letter, CellIndex cell) const;
  bool HasNeighbour(CellIndex cell, char letter) const;  // of 8

  Grid<char>& cells() { return cells_; }
  const Grid<char>& cells() const { return cells_; }

 private:
  struct Absence {
    char letter;
    UnitBox box;
  };
  std::vector<Absence> absences_;
  const Relief* relief_;
  Grid<char> cells_;
  Grid<int> pieces_;
  Grid<std::uint8_t> locked_;
  int next_piece_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_CANVAS_H_
