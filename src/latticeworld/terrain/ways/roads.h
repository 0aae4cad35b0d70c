#ifndef LATTICEWORLD_TERRAIN_WAYS_ROADS_H_
#define LATTICEWORLD_TERRAIN_WAYS_ROADS_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/terrain/water/banks.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld::internal {

struct RoadRule {
  double max_slope = 0.12;        // along the road [m/m]
  double embankment_slope = 0.5;  // of cuts and fills beside it [m/m]
};

// Grades roads along their course by cut and fill, level across. Where a road fords a river it goes
// down to the river's bed; to its bridges it climbs, or they lie as high as the road does.
// road: 1 on roads. lines: crossings and centre lines on the same lattice. ford_depth_m: of the
// water over each cell of a ford. bridges: as low as they may lie; get their heights. land_m:
// fitted to the banks; gets roads and embankments. open: 1 below decks over gorges, which stay as
// they are; may be empty. share: gets how much of each cell is shaped by
// them, in [0, 1].
void GradeRoads(const GridGeometry& lattice, const Grid<unsigned char>& road,
                const DecodedLayout& lines, const Banks& banks, const Grid<float>& ford_depth_m,
                const RoadRule& rule, const Grid<unsigned char>& open, std::vector<Bridge>* bridges,
                Grid<float>* land_m, Grid<float>* share);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_ROADS_H_
