#ifndef LATTICEWORLD_TERRAIN_WATER_WATER_BODIES_H_
#define LATTICEWORLD_TERRAIN_WATER_WATER_BODIES_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/terrain/components.h"

namespace latticeworld::internal {

// The water of a world by its nature. What is wide, or compact, stands still: lakes, and the sea,
// which touches much of the world's edge. The rest runs: rivers.
struct WaterBodies {
  Grid<unsigned char> wet;  // 1 where water is, or would be without a road over it
  // Bodies hang together, or so nearly (within four cells) that they have to agree on their levels.
  Components bodies;
  Grid<std::int32_t> near_body;        // body that a cell lies within two cells of, else -1
  Grid<std::int32_t> still;            // number of the still water, -1: runs, or dry
  std::vector<std::int32_t> still_in;  // body of each still water
  std::vector<bool> is_sea;            // of each still water
  std::vector<bool> has_sea;           // of each body
  std::vector<bool> at_edge;           // of each body: touches the world's edge

  int still_count() const { return static_cast<int>(is_sea.size()); }
};

// layout_cell: width of a cell of the layout [cells]. Lone water that neither is compact nor
// reaches the edge stands still where lone_is_still, else it runs to its lowest end.
WaterBodies FindWaterBodies(Grid<unsigned char> wet, double layout_cell, bool lone_is_still);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WATER_WATER_BODIES_H_
