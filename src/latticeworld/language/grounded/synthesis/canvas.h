#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_CANVAS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_CANVAS_H_

#include <array>
#include <cmath>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/layout_mask.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

inline constexpr int kCellCount = kLayoutSize * kLayoutSize;
inline CellIndex CellOf(int id) { return {id / kLayoutSize, id % kLayoutSize}; }
inline int IdOf(CellIndex cell) { return cell.row * kLayoutSize + cell.col; }
inline bool IsInside(CellIndex cell) {
  return cell.row >= 0 && cell.row < kLayoutSize && cell.col >= 0 && cell.col < kLayoutSize;
}

inline constexpr int kNeighbours8[8][2] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                           {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};  // row, col; the
                                                                                 // first four share
                                                                                 // a side

// A continuous place on the layout [cells]; a cell's middle has whole numbers.
using Spot = LayoutMask::Point;
CellIndex NearestCell(Spot spot);
double DistanceBetween(Spot a, Spot b);
// Returns the length of a way of so many rows and columns; std::hypot, careful of overflow, takes
// several times as long.
inline double LengthOf(double rows, double cols) { return std::sqrt(rows * rows + cols * cols); }

// The letters that an instruction forbids, cell by cell.
class ForbiddenCells {
 public:
  explicit ForbiddenCells(const LayoutPlan& plan);
  const LayoutMask& of(char letter) const { return masks_[Slot(letter)]; }
  bool Contains(char letter, CellIndex cell) const { return masks_[Slot(letter)].Contains(cell); }

 private:
  static std::size_t Slot(char letter) { return static_cast<unsigned char>(letter) & 31; }
  std::array<LayoutMask, 32> masks_{};
};

// How little a relief likes a letter in a cell, [0, 1]; 0 without a relief (nullptr). Water wants
// the lows, snow and rock the heights, houses and fields no heights.
double AversionTo(char letter, CellIndex cell, Vocabulary vocabulary, const Relief* relief);

// A layout in the making: letters, and which feature laid them.
class Canvas {
 public:
  static constexpr char kFree = '\0';

  Canvas() : letters_(kLayoutSize, kLayoutSize, kFree), features_(kLayoutSize, kLayoutSize, -1) {}

  char at(CellIndex cell) const { return letters_[cell]; }
  int feature_at(CellIndex cell) const { return features_[cell]; }  // -1: none
  bool is_line(CellIndex cell) const { return lines_.Contains(cell); }
  const LayoutMask& lines() const { return lines_; }

  void Paint(CellIndex cell, char letter, int feature) {
    letters_[cell] = letter;
    features_[cell] = feature;
    lines_.Remove(cell);
  }
  void PaintLine(CellIndex cell, char letter, int feature) {
    Paint(cell, letter, feature);
    lines_.Add(cell);
  }

  LayoutMask MaskOfLetter(char letter) const;
  LayoutMask MaskOfFeature(int feature) const;
  LayoutMask FreeCells() const { return MaskOfLetter(kFree); }

  const Grid<char>& letters() const { return letters_; }

 private:
  Grid<char> letters_;
  Grid<int> features_;
  LayoutMask lines_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_CANVAS_H_
