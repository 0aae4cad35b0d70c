#include "latticeworld/dataset/captions/line_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld::internal {
namespace {

constexpr double kLineWidth = 1.25;   // cells: what is wider is an area
constexpr double kLineLength = 1.75;  // cells: what is shorter is a blot
constexpr double kEdge = 0.75;        // cells beyond an area that are still its edge
constexpr double kEndDepth = 0.5;     // cells that a line's end reaches into the last one

// The steps around a cell, anticlockwise from the east; even ones are the four nearest.
constexpr std::array<CellIndex, 8> kAround = {
    {{0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}}};

// What thin pixels do in one cell: how many there are, and the rows and columns they span.
struct Touch {
  int pixels = 0;
  int top = std::numeric_limits<int>::max(), bottom = -1;
  int left = std::numeric_limits<int>::max(), right = -1;
};

Grid<Touch> TouchesOf(const Grid<unsigned char>& thin) {
  Grid<Touch> touches(kLayoutSize, kLayoutSize);
  for (int i = 0; i < kLayoutSize; ++i) {
    for (int r = FirstPixelOf(i, thin.rows()); r < FirstPixelOf(i + 1, thin.rows()); ++r) {
      for (int j = 0; j < kLayoutSize; ++j) {
        Touch& touch = touches(i, j);
        for (int c = FirstPixelOf(j, thin.cols()); c < FirstPixelOf(j + 1, thin.cols()); ++c) {
          if (thin(r, c) == 0) continue;
          ++touch.pixels;
          touch.top = std::min(touch.top, r);
          touch.bottom = std::max(touch.bottom, r);
          touch.left = std::min(touch.left, c);
          touch.right = std::max(touch.right, c);
        }
      }
    }
  }
  return touches;
}

// Thinning of the cells of one class.
class Thinning {
 public:
  Thinning(const Grid<unsigned char>& thin, const Grid<unsigned char>& areas,
           const Grid<unsigned char>& avoid)
      : rows_(thin.rows()),
        cols_(thin.cols()),
        touches_(TouchesOf(thin)),
        avoid_(avoid),
        set_(areas),
        line_(kLayoutSize, kLayoutSize) {
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        line_(r, c) = touches_(r, c).pixels > 0 && areas(r, c) == 0 ? 1 : 0;
        set_(r, c) |= line_(r, c);
      }
    }
  }

  Grid<unsigned char> Run() {
    for (CellIndex cell = Worst(); cell.row >= 0; cell = Worst()) set_[cell] = line_[cell] = 0;
    return line_;
  }

 private:
  bool Has(CellIndex cell, int k) const {
    const CellIndex next{cell.row + kAround[k].row, cell.col + kAround[k].col};
    return set_.Contains(next) && set_[next] != 0;
  }

  // Whether the cells around it hang together, and what is around them, without it.
  bool IsSimple(CellIndex cell) const {
    int number = 0;
    for (int k = 0; k < 8; k += 2) {
      const int x = Has(cell, k) ? 1 : 0;
      const int corner = Has(cell, k + 1) && Has(cell, (k + 2) % 8) ? 1 : 0;
      number += x - x * corner;
    }
    return number == 1;
  }

  // How far the pixels reach into the cell from its neighbour at kAround[k] [cells].
  double Depth(CellIndex cell, int k) const {
    const Touch& touch = touches_[cell];
    const double height = rows_ / static_cast<double>(kLayoutSize);
    const double width = cols_ / static_cast<double>(kLayoutSize);
    switch (k) {
      case 0:
        return (FirstPixelOf(cell.col + 1, cols_) - touch.left) / width;
      case 2:
        return (touch.bottom + 1 - FirstPixelOf(cell.row, rows_)) / height;
      case 4:
        return (touch.right + 1 - FirstPixelOf(cell.col, cols_)) / width;
      default:
        return (FirstPixelOf(cell.row + 1, rows_) - touch.top) / height;
    }
  }

  // The sides of the picture that the cell's pixels reach, a bit each.
  unsigned SidesReached(CellIndex cell) const {
    const Touch& touch = touches_[cell];
    if (line_[cell] == 0) {
      return (cell.row == 0 ? 1u : 0u) | (cell.row == kLayoutSize - 1 ? 2u : 0u) |
             (cell.col == 0 ? 4u : 0u) | (cell.col == kLayoutSize - 1 ? 8u : 0u);
    }
    return (touch.top == 0 ? 1u : 0u) | (touch.bottom == rows_ - 1 ? 2u : 0u) |
           (touch.left == 0 ? 4u : 0u) | (touch.right == cols_ - 1 ? 8u : 0u);
  }

  bool IsEnd(CellIndex cell) const {
    int nearest = 0, k_nearest = 0;
    for (int k = 0; k < 8; k += 2) {
      if (!Has(cell, k)) continue;
      ++nearest;
      k_nearest = k;
    }
    if (nearest != 1) return false;
    const CellIndex step = kAround[static_cast<std::size_t>(k_nearest)];
    const unsigned beyond = SidesReached({cell.row + step.row, cell.col + step.col});
    // Here alone it leaves the picture.
    if ((SidesReached(cell) & ~beyond) != 0) return true;
    return Depth(cell, k_nearest) >= kEndDepth;
  }

  // Returns the cell that carries least among those that may go; row -1: none may go.
  CellIndex Worst() const {
    CellIndex worst{-1, -1};
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        const CellIndex cell{r, c};
        if (line_[cell] == 0 || !IsSimple(cell) || IsEnd(cell)) continue;
        if (worst.row < 0 || CarriesLess(cell, worst)) worst = cell;
      }
    }
    return worst;
  }
  bool CarriesLess(CellIndex a, CellIndex b) const {
    if (avoid_[a] != avoid_[b]) return avoid_[a] > avoid_[b];
    return touches_[a].pixels < touches_[b].pixels;
  }

  const int rows_, cols_;  // pixels
  const Grid<Touch> touches_;
  const Grid<unsigned char>& avoid_;
  Grid<unsigned char> set_;   // areas and lines
  Grid<unsigned char> line_;  // lines alone
};

// 8-connected pixels of `mask` from (r, c) on, which are taken out of it.
std::vector<CellIndex> TakePiece(CellIndex start, Grid<unsigned char>* mask) {
  std::vector<CellIndex> piece{start};
  (*mask)[start] = 0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (const CellIndex step : kAround) {
      const CellIndex next{piece[i].row + step.row, piece[i].col + step.col};
      if (!mask->Contains(next) || (*mask)[next] == 0) continue;
      (*mask)[next] = 0;
      piece.push_back(next);
    }
  }
  return piece;
}

}  // namespace

int FirstPixelOf(int cell, int size) {
  return static_cast<int>((static_cast<std::int64_t>(cell) * size + kLayoutSize - 1) / kLayoutSize);
}

Grid<unsigned char> ThinPixels(const Grid<unsigned char>& mask) {
  const int rows = mask.rows(), cols = mask.cols();
  const double cell = std::min(rows, cols) / static_cast<double>(kLayoutSize);
  const double radius = 0.5 * kLineWidth * cell;
  Grid<unsigned char> lines(rows, cols);

  // Centres of discs that lie in the mask, and what is left when their discs are taken out. The
  // distance counts from centre to centre of pixels: an edge lies half a pixel before.
  const Grid<float> inside = DistanceTo(false, mask, /*threads=*/1);
  Grid<unsigned char> centres(rows, cols);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    centres.data()[i] = mask.data()[i] != 0 && inside.data()[i] - 0.5 >= radius ? 1 : 0;
  }
  const Grid<float> beyond = DistanceTo(true, centres, /*threads=*/1);
  Grid<unsigned char> left(rows, cols);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    left.data()[i] = mask.data()[i] != 0 && beyond.data()[i] - 0.5 >= radius ? 1 : 0;
  }

  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      if (left(r, c) == 0) continue;
      const std::vector<CellIndex> piece = TakePiece({r, c}, &left);
      int top = rows, bottom = 0, west = cols, east = 0;
      bool reaches_out = false;
      for (const CellIndex pixel : piece) {
        top = std::min(top, pixel.row);
        bottom = std::max(bottom, pixel.row);
        west = std::min(west, pixel.col);
        east = std::max(east, pixel.col);
        reaches_out = reaches_out || beyond[pixel] >= radius + kEdge * cell;
      }
      const int length = 1 + std::max(bottom - top, east - west);
      if (!reaches_out || length < kLineLength * cell) continue;
      for (const CellIndex pixel : piece) lines[pixel] = 1;
    }
  }
  return lines;
}

Grid<unsigned char> LineCells(const Grid<unsigned char>& thin, const Grid<unsigned char>& areas,
                              const Grid<unsigned char>& avoid) {
  return Thinning(thin, areas, avoid).Run();
}

}  // namespace latticeworld::internal
