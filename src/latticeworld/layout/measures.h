#ifndef LATTICEWORLD_LAYOUT_MEASURES_H_
#define LATTICEWORLD_LAYOUT_MEASURES_H_

#include <vector>

#include "latticeworld/geometry/region.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// Share of the region's cells that carry the letter, in [0, 1].
double ShareIn(const SymbolicLayout& layout, char letter, Region region);

struct LayoutComponent {
  std::vector<CellIndex> cells;  // in row-major order
};
// 8-connected pieces of one letter, largest first (ties: the first cell in row-major order).
std::vector<LayoutComponent> ComponentsOf(const SymbolicLayout& layout, char letter);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_MEASURES_H_
