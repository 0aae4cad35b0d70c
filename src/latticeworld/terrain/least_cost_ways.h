#ifndef LATTICEWORLD_TERRAIN_LEAST_COST_WAYS_H_
#define LATTICEWORLD_TERRAIN_LEAST_COST_WAYS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// The cheapest ways over a grid from the nearest of its sources to every cell (Dijkstra 1959), in
// king's moves. Equal costs go to the cell that comes first, so that ways are the same every time.
class LeastCostWays {
 public:
  // cost: of a step of one cell into each cell, > 0; infinity: no way. sources: cells that ways may
  // begin in, whatever they cost.
  LeastCostWays(const Grid<float>& cost, const std::vector<CellIndex>& sources);

  bool Reaches(CellIndex cell) const { return from_[cell] != kNowhere; }
  // From its source to the cell, both included. The cell must be reached.
  std::vector<CellIndex> WayTo(CellIndex cell) const;

 private:
  static constexpr std::int32_t kNowhere = -2;
  static constexpr std::int32_t kSource = -1;
  Grid<std::int32_t> from_;  // the cell before on the way
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_LEAST_COST_WAYS_H_
