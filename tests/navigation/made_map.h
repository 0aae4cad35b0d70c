#ifndef LATTICEWORLD_TESTS_NAVIGATION_MADE_MAP_H_
#define LATTICEWORLD_TESTS_NAVIGATION_MADE_MAP_H_

#include <functional>

#include "latticeworld/navigation/navigable_map.h"

namespace latticeworld {

// A map of that many cells a side whose ground is height(x, y) [m] and that is free where blocked
// says no.
inline NavigableMap MadeMap(
    int cells, double size_m, const std::function<double(double, double)>& height,
    const std::function<bool(double, double)>& blocked = [](double, double) { return false; }) {
  const GridGeometry geometry = GridGeometry::FromCells(cells, size_m);
  Grid<float> height_m(cells, cells);
  NavigableMap map;
  map.free = Grid<std::uint8_t>(cells, cells, 1);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      const WorldPoint at = geometry.CenterOf({row, col});
      height_m(row, col) = static_cast<float>(height(at.x_m, at.y_m));
      map.free(row, col) = blocked(at.x_m, at.y_m) ? 0 : 1;
    }
  }
  map.ground = HeightField(geometry, std::move(height_m));
  return map;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_NAVIGATION_MADE_MAP_H_
