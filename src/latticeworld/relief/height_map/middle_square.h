#ifndef LATTICEWORLD_RELIEF_HEIGHT_MAP_MIDDLE_SQUARE_H_
#define LATTICEWORLD_RELIEF_HEIGHT_MAP_MIDDLE_SQUARE_H_

#include <algorithm>
#include <string>
#include <string_view>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// The largest square in the middle of a picture. Worlds are square, and what a user gave is never
// stretched. Where the two sides differ by an odd number of pixels, the left or upper edge loses
// the smaller part.
struct MiddleSquare {
  MiddleSquare(int picture_rows, int picture_cols);

  // Whether something of the picture lies outside.
  bool cuts() const { return picture_rows != picture_cols; }

  int picture_rows;
  int picture_cols;
  int side;  // [pixels]
  int row;   // of the picture: the square's first
  int col;
};

// What lies in the square.
template <typename T>
Grid<T> CutOut(const MiddleSquare& square, const Grid<T>& picture) {
  Grid<T> middle(square.side, square.side);
  for (int r = 0; r < square.side; ++r) {
    std::copy_n(picture.row(square.row + r) + square.col, square.side, middle.row(r));
  }
  return middle;
}

// Says of a picture that the square cuts which of its pixels are kept. what: "height map".
std::string CutWarning(const MiddleSquare& square, std::string_view what);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_HEIGHT_MAP_MIDDLE_SQUARE_H_
