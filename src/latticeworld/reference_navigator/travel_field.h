#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_TRAVEL_FIELD_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_TRAVEL_FIELD_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Steps between neighbouring cells of a grid are dear or not to be made.
inline constexpr float kClosedCell = 0.0f;  // any other price is at least 1, by which lengths count

// What it costs to get from every cell to one: length times the mean price of the cells that it
// leads over.
struct TravelField {
  double resolution_m = 0.0;
  Grid<float> cost_m;  // (rows x cols); infinity: no way
};

// A cell from which the field spreads, and what getting on from there costs.
struct TravelSeed {
  CellIndex cell;
  float cost_m = 0.0f;
};

// Dijkstra's search over the eight neighbours; corners of closed cells are not cut. The queue is
// one of buckets, so that it is linear in cells. enough: cells beyond the first one reached that is
// this are not looked at; null: all are.
TravelField SpreadFrom(const std::vector<TravelSeed>& seeds, const Grid<float>& prices,
                       double resolution_m, const CellIndex* enough = nullptr);

// Cells from `start` down the field to a seed, both among them; empty where there is no way.
std::vector<CellIndex> Descend(const TravelField& field, const Grid<float>& prices,
                               CellIndex start);

// Whether the straight line between two cells' centres leads over open cells alone, none of which
// is dearer than the dearest of `limit`.
bool IsStraightOpen(const Grid<float>& prices, CellIndex from, CellIndex to, float limit);

// The way with its corners alone: each leg straight over open cells that are no dearer than those
// of the way that it replaces.
std::vector<CellIndex> PulledStraight(const std::vector<CellIndex>& way, const Grid<float>& prices);

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_TRAVEL_FIELD_H_
