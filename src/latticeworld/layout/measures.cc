#include "latticeworld/layout/measures.h"

#include <utility>

#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

double ShareIn(const SymbolicLayout& layout, char letter, Region region) {
  const LayoutMask zone = MaskOf(ZoneOf(region));
  return static_cast<double>((MaskOf(layout, letter) & zone).count()) / zone.count();
}

std::vector<LayoutComponent> ComponentsOf(const SymbolicLayout& layout, char letter) {
  std::vector<LayoutComponent> components;
  for (const LayoutMask& piece : MaskOf(layout, letter).Pieces()) {
    LayoutComponent component;
    ForEachCell(piece, [&](CellIndex cell) { component.cells.push_back(cell); });
    components.push_back(std::move(component));
  }
  return components;
}

}  // namespace latticeworld
