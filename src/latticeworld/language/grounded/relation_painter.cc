#include "latticeworld/language/grounded/relation_painter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace latticeworld {
namespace {

std::vector<CellIndex> CellsOf(const Canvas& canvas, char letter) {
  std::vector<CellIndex> cells;
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (canvas.at({row, col}) == letter) cells.push_back({row, col});
    }
  }
  return cells;
}

bool MayPaint(const Canvas& canvas, CellIndex cell, char letter) {
  return canvas.Contains(cell) && !canvas.locked(cell) && !canvas.IsForbidden(letter, cell);
}

// A ragged tongue of `letter` between the two nearest cells of the letters.
void Join(char letter, char object, RandomStream* random, Canvas* canvas) {
  const std::vector<CellIndex> subjects = CellsOf(*canvas, letter);
  const std::vector<CellIndex> objects = CellsOf(*canvas, object);
  if (subjects.empty() || objects.empty()) return;
  CellIndex from = subjects.front();
  CellIndex to = objects.front();
  int nearest = 1 << 20;
  for (const CellIndex subject : subjects) {
    for (const CellIndex candidate : objects) {
      const int rows = subject.row - candidate.row;
      const int cols = subject.col - candidate.col;
      if (rows * rows + cols * cols >= nearest) continue;
      nearest = rows * rows + cols * cols;
      from = subject;
      to = candidate;
    }
  }
  const int steps = std::max(std::abs(to.row - from.row), std::abs(to.col - from.col));
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const CellIndex cell{static_cast<int>(std::lround(from.row + t * (to.row - from.row))),
                         static_cast<int>(std::lround(from.col + t * (to.col - from.col)))};
    // A tongue of land: only what lies on the way is covered, not other things beside it.
    const char ground = canvas->at(cell);
    for (int row = -2; row <= 2; ++row) {
      for (int col = -2; col <= 2; ++col) {
        if (row * row + col * col > 4 || (row * row + col * col > 1 && random->Chance(0.3))) {
          continue;
        }
        const CellIndex wide{cell.row + row, cell.col + col};
        if (MayPaint(*canvas, wide, letter) && canvas->at(wide) == ground) {
          canvas->Paint(wide, letter, -1);
        }
      }
    }
    if (MayPaint(*canvas, cell, letter)) canvas->Paint(cell, letter, -1);
  }
}

void Ring(char letter, char object, RandomStream* random, Canvas* canvas) {
  const std::vector<CellIndex> objects = CellsOf(*canvas, object);
  for (const CellIndex cell : objects) {
    for (int row = -2; row <= 2; ++row) {
      for (int col = -2; col <= 2; ++col) {
        const CellIndex near{cell.row + row, cell.col + col};
        if (!MayPaint(*canvas, near, letter) || canvas->at(near) == object) continue;
        const bool outer = std::abs(row) == 2 || std::abs(col) == 2;
        const bool far_corner = std::abs(row) == 2 && std::abs(col) == 2;
        // A ragged outer rim, whole inside.
        if (far_corner || (outer && !random->Chance(0.75))) continue;
        canvas->Paint(near, letter, -1);
      }
    }
  }
}

}  // namespace

void PaintRelation(const RelationWish& relation, RandomStream* random, Canvas* canvas) {
  if (relation.kind == ClaimKind::kSurrounds) {
    Ring(relation.subject, relation.object, random, canvas);
    return;
  }
  for (const CellIndex cell : CellsOf(*canvas, relation.subject)) {
    if (canvas->HasNeighbour(cell, relation.object)) return;
  }
  // What spreads reaches out to what runs, not the other way about.
  const bool object_moves = relation.subject_area < 0 && relation.object_area >= 0;
  if (object_moves) {
    Join(relation.object, relation.subject, random, canvas);
  } else {
    Join(relation.subject, relation.object, random, canvas);
  }
}

}  // namespace latticeworld
