#include "latticeworld/layout/crossings.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace latticeworld {
namespace {

constexpr int kWidestRoad_cells = 3;  // that water is taken to run on under
constexpr int kWidestFord_cells = 3;
constexpr int kLongestFord_cells = 6;  // of a road that crosses a river at a slant

char At(const SymbolicLayout& layout, int row, int col) {
  return layout.cells.Contains({row, col}) ? layout.cells(row, col) : '\0';
}

// The first cell that is no road from `cell` on in steps of (d_row, d_col).
CellIndex FirstOffRoad(const SymbolicLayout& layout, CellIndex cell, int d_row, int d_col) {
  while (At(layout, cell.row, cell.col) == 'R') {
    cell.row += d_row;
    cell.col += d_col;
  }
  return cell;
}

// How many water cells lie side by side through `cell` in the direction (d_row, d_col).
int WidthOf(const SymbolicLayout& layout, CellIndex cell, int d_row, int d_col) {
  int width = 1;
  for (const int sign : {-1, 1}) {
    for (int k = 1; At(layout, cell.row + sign * k * d_row, cell.col + sign * k * d_col) == 'W';
         ++k) {
      ++width;
    }
  }
  return width;
}

// A piece of road over water is a ford or a bridge as a whole: a bridge where it is long, or mostly
// over what is wide.
void DecideByPiece(Grid<Crossing>* crossings) {
  Grid<unsigned char> seen(crossings->rows(), crossings->cols(), 0);
  for (int row = 0; row < crossings->rows(); ++row) {
    for (int col = 0; col < crossings->cols(); ++col) {
      if ((*crossings)(row, col) == Crossing::kNone || seen(row, col) != 0) continue;
      std::vector<CellIndex> piece = {{row, col}};
      seen(row, col) = 1;
      int wide = 0;
      for (std::size_t next = 0; next < piece.size(); ++next) {
        const CellIndex cell = piece[next];
        wide += (*crossings)[cell] == Crossing::kBridge;
        for (int r = cell.row - 1; r <= cell.row + 1; ++r) {
          for (int c = cell.col - 1; c <= cell.col + 1; ++c) {
            if (!crossings->Contains({r, c}) || seen(r, c) != 0) continue;
            if ((*crossings)(r, c) == Crossing::kNone) continue;
            seen(r, c) = 1;
            piece.push_back({r, c});
          }
        }
      }
      const int cells = static_cast<int>(piece.size());
      const bool bridge = cells > kLongestFord_cells || 2 * wide > cells;
      for (const CellIndex cell : piece) {
        (*crossings)[cell] = bridge ? Crossing::kBridge : Crossing::kFord;
      }
    }
  }
}

}  // namespace

Grid<Crossing> CrossingsOf(const SymbolicLayout& layout, bool fords) {
  Grid<Crossing> crossings(layout.cells.rows(), layout.cells.cols(), Crossing::kNone);
  if (layout.vocabulary != Vocabulary::kSuburb) return crossings;
  constexpr int kDirections[4][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  for (int row = 0; row < layout.cells.rows(); ++row) {
    for (int col = 0; col < layout.cells.cols(); ++col) {
      if (layout.cells(row, col) != 'R') continue;
      for (const auto& step : kDirections) {
        const CellIndex ahead = FirstOffRoad(layout, {row, col}, step[0], step[1]);
        const CellIndex behind = FirstOffRoad(layout, {row, col}, -step[0], -step[1]);
        const int road_cells =
            std::max(std::abs(ahead.row - behind.row), std::abs(ahead.col - behind.col)) - 1;
        if (At(layout, ahead.row, ahead.col) != 'W' || At(layout, behind.row, behind.col) != 'W' ||
            road_cells > kWidestRoad_cells) {
          continue;
        }
        const int width = std::min(WidthOf(layout, ahead, -step[1], step[0]),
                                   WidthOf(layout, behind, -step[1], step[0]));
        // What is narrow one way is narrow.
        if (fords && width <= kWidestFord_cells) {
          crossings(row, col) = Crossing::kFord;
        } else if (crossings(row, col) == Crossing::kNone) {
          crossings(row, col) = Crossing::kBridge;
        }
      }
    }
  }
  DecideByPiece(&crossings);
  return crossings;
}

Grid<unsigned char> CornerCrossingsOf(const SymbolicLayout& layout) {
  const int rows = layout.cells.rows(), cols = layout.cells.cols();
  Grid<unsigned char> corners(rows + 1, cols + 1, 0);
  if (layout.vocabulary != Vocabulary::kSuburb) return corners;
  for (int row = 1; row < rows; ++row) {
    for (int col = 1; col < cols; ++col) {
      const char a = layout.cells(row - 1, col - 1), b = layout.cells(row - 1, col);
      const char c = layout.cells(row, col - 1), d = layout.cells(row, col);
      const bool falls = a == 'R' && d == 'R' && b == 'W' && c == 'W';
      const bool rises = a == 'W' && d == 'W' && b == 'R' && c == 'R';
      corners(row, col) = falls || rises ? 1 : 0;
    }
  }
  return corners;
}

}  // namespace latticeworld
