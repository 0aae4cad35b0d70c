#include "latticeworld/language/grounded/island_painter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace latticeworld {
namespace {

constexpr double kRing = 2.2;  // cells of water around an island

bool IsLake(const Canvas& canvas, CellIndex cell) {
  return canvas.at(cell) == 'W' && !canvas.locked(cell);
}

// Distance to the nearest land or map edge [cells].
double ToShore(const Canvas& canvas, CellIndex cell) {
  double nearest = 1.0 + std::min(std::min(cell.row, kLayoutSize - 1 - cell.row),
                                  std::min(cell.col, kLayoutSize - 1 - cell.col));
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (canvas.at({row, col}) == 'W') continue;
      nearest = std::min(nearest, std::hypot(row - cell.row, col - cell.col));
    }
  }
  return nearest;
}

template <typename Visit>
void ForEachWithin(CellIndex middle, double radius, const Canvas& canvas, const Visit& visit) {
  const int reach = static_cast<int>(std::ceil(radius));
  for (int row = -reach; row <= reach; ++row) {
    for (int col = -reach; col <= reach; ++col) {
      const CellIndex cell{middle.row + row, middle.col + col};
      if (canvas.Contains(cell) && !canvas.locked(cell) && std::hypot(row, col) <= radius) {
        visit(cell);
      }
    }
  }
}

}  // namespace

void PaintIslands(const IslandWish& wish, Canvas* canvas) {
  const double radius = std::max(1.0, std::sqrt(wish.cells / 3.14159));
  for (int piece = 0; piece < wish.pieces; ++piece) {
    CellIndex middle{-1, -1};
    double widest = 0.0;
    for (int row = 0; row < kLayoutSize; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) {
        const CellIndex cell{row, col};
        if (!IsLake(*canvas, cell)) continue;
        const double width = ToShore(*canvas, cell);
        if (width <= widest) continue;
        widest = width;
        middle = cell;
      }
    }
    if (middle.row < 0) return;
    ForEachWithin(middle, radius + kRing, *canvas, [&](CellIndex cell) {
      // Not over an island laid before.
      if (piece == 0 && !canvas->IsForbidden('W', cell)) canvas->Paint(cell, 'W', -1);
    });
    ForEachWithin(middle, std::min(radius, piece == 0 ? radius : std::max(0.5, widest - 1.5)),
                  *canvas, [&](CellIndex cell) {
                    if (!canvas->IsForbidden(wish.letter, cell)) {
                      canvas->Paint(cell, wish.letter, -1);
                    }
                  });
  }
}

}  // namespace latticeworld
