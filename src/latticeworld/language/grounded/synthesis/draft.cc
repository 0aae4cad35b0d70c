#include "latticeworld/language/grounded/synthesis/draft.h"

#include <algorithm>

namespace latticeworld {

LayoutMask LeftOf(const std::vector<CellIndex>& path) {
  LayoutMask left;
  const int last = static_cast<int>(path.size()) - 1;
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    int nearest = 0;
    int best = 1 << 20;
    for (int i = 0; i <= last; ++i) {
      const int rows = path[static_cast<std::size_t>(i)].row - cell.row;
      const int cols = path[static_cast<std::size_t>(i)].col - cell.col;
      if (rows * rows + cols * cols >= best) continue;
      best = rows * rows + cols * cols;
      nearest = i;
    }
    const CellIndex before = path[static_cast<std::size_t>(std::max(0, nearest - 2))];
    const CellIndex after = path[static_cast<std::size_t>(std::min(last, nearest + 2))];
    const int turn = (after.row - before.row) * (cell.col - before.col) -
                     (after.col - before.col) * (cell.row - before.row);
    if (turn > 0) left.Add(cell);
  }
  return left;
}

namespace {

// octagonal: every other step takes no corners.
Grid<float> Steps(const LayoutMask& set, bool octagonal) {
  Grid<float> steps(kLayoutSize, kLayoutSize, 99.0f);
  LayoutMask reached = set;
  LayoutMask shell = set;
  for (int step = 0; !shell.empty(); ++step) {
    for (int row = 0; row < kLayoutSize; ++row) {
      if (shell.row(row) == 0) continue;
      for (int col = 0; col < kLayoutSize; ++col) {
        if (shell.Contains({row, col})) steps(row, col) = static_cast<float>(step);
      }
    }
    const LayoutMask next = octagonal && step % 2 == 1 ? reached.Grown4() : reached.Grown8();
    shell = next - reached;
    reached = next;
  }
  return steps;
}

}  // namespace

Grid<float> StepsFrom(const LayoutMask& set) { return Steps(set, false); }
Grid<float> RoundStepsFrom(const LayoutMask& set) { return Steps(set, true); }

}  // namespace latticeworld
