#include "latticeworld/relief/height_map/middle_square.h"

namespace latticeworld::internal {

MiddleSquare::MiddleSquare(int rows, int cols)
    : picture_rows(rows),
      picture_cols(cols),
      side(std::min(rows, cols)),
      row((rows - side) / 2),
      col((cols - side) / 2) {}

std::string CutWarning(const MiddleSquare& square, std::string_view what) {
  const bool wide = square.picture_cols > square.picture_rows;
  const int first = wide ? square.col : square.row;
  const int longer = std::max(square.picture_cols, square.picture_rows);
  return "the " + std::string(what) + " has " + std::to_string(square.picture_cols) + " x " +
         std::to_string(square.picture_rows) +
         " pixels, and a world is square: the middle is kept, " + (wide ? "columns " : "rows ") +
         std::to_string(first) + " to " + std::to_string(first + square.side - 1) + " of 0 to " +
         std::to_string(longer - 1) + ", and nothing is stretched";
}

}  // namespace latticeworld::internal
