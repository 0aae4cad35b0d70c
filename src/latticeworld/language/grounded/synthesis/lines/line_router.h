#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_ROUTER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_ROUTER_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {

struct RouteOptions {
  Grid<float> cost;                     // of entering a cell, above 0, (32 x 32)
  const Grid<float>* height = nullptr;  // rivers: going up costs dear; nullptr: the same all over
  std::vector<LayoutMask> stops;        // from any cell of the first, by way of each, to the last
};

// The cheapest way from stop to stop, as 8-connected cells without steps of a staircase: as a
// smooth curve through the stops where that costs little more, else with its bends rounded by
// moving means as far as the cost allows. Empty: a stop is empty.
std::vector<CellIndex> Route(const RouteOptions& options);

// The cells between two cells, 8-connected (Bresenham 1965), both included.
std::vector<CellIndex> StraightCells(CellIndex from, CellIndex to);

// Returns the path without detours: a cell that touches a later one (of the next `reach`) leaps to
// it.
std::vector<CellIndex> Thinned(const std::vector<CellIndex>& path, int reach);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_LINE_ROUTER_H_
