#include "latticeworld/layout/measures.h"

#include <algorithm>
#include <utility>

namespace latticeworld {
namespace {

template <typename Visit>
void ForEachCellIn(Region region, Visit&& visit) {
  const UnitBox box = BoxOf(region);
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (box.Contains((col + 0.5) / kLayoutSize, (row + 0.5) / kLayoutSize)) visit(row, col);
    }
  }
}

}  // namespace

double ShareIn(const SymbolicLayout& layout, char letter, Region region) {
  int total = 0, found = 0;
  ForEachCellIn(region, [&](int row, int col) {
    ++total;
    found += layout.cells(row, col) == letter;
  });
  return static_cast<double>(found) / total;
}

std::vector<LayoutComponent> ComponentsOf(const SymbolicLayout& layout, char letter) {
  std::vector<LayoutComponent> components;
  Grid<char> seen(kLayoutSize, kLayoutSize, 0);
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (layout.cells(row, col) != letter || seen(row, col)) continue;
      LayoutComponent component;
      component.cells.push_back({row, col});
      seen(row, col) = 1;
      for (std::size_t next = 0; next < component.cells.size(); ++next) {
        const CellIndex cell = component.cells[next];
        for (int dr = -1; dr <= 1; ++dr) {
          for (int dc = -1; dc <= 1; ++dc) {
            const CellIndex near{cell.row + dr, cell.col + dc};
            if (!layout.cells.Contains(near) || layout.cells[near] != letter ||
                seen(near.row, near.col)) {
              continue;
            }
            seen(near.row, near.col) = 1;
            component.cells.push_back(near);
          }
        }
      }
      components.push_back(std::move(component));
    }
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const LayoutComponent& a, const LayoutComponent& b) {
                     return a.cells.size() > b.cells.size();
                   });
  return components;
}

double AdjacencyOf(const SymbolicLayout& layout, char letter, char other) {
  int total = 0, touching = 0;
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (layout.cells(row, col) != letter) continue;
      ++total;
      bool touches = false;
      for (int dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          const CellIndex near{row + dr, col + dc};
          if (dr == 0 && dc == 0) continue;
          touches = touches || (layout.cells.Contains(near) && layout.cells[near] == other);
        }
      }
      touching += touches;
    }
  }
  return total == 0 ? 0.0 : static_cast<double>(touching) / total;
}

char DominantIn(const SymbolicLayout& layout, Region region) {
  char best = '\0';
  double best_share = -1.0;
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
    const double share = ShareIn(layout, entry.letter, region);
    if (share > best_share) {
      best = entry.letter;
      best_share = share;
    }
  }
  return best;
}

}  // namespace latticeworld
