#ifndef LATTICEWORLD_TERRAIN_ROADS_H_
#define LATTICEWORLD_TERRAIN_ROADS_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/terrain/banks.h"

namespace latticeworld::internal {

struct RoadRule {
  double max_slope = 0.12;         // along the road [m/m]
  double embankment_slope = 0.5;   // of cuts and fills beside it [m/m]
  double causeway_height_m = 0.4;  // of a dam above its water
};

// Grades roads along their course by cut and fill, level across. Where a road fords a river it goes
// down to the river's bed; over wide water it lies on a dam.
// road: 1 on roads. lines: crossings and centre lines on the same lattice. ford_depth_m: of the
// water over each cell of a ford. land_m: fitted to the banks; gets roads and embankments. share:
// gets how much of each cell is shaped by them, in [0, 1].
void GradeRoads(const GridGeometry& lattice, const Grid<unsigned char>& road,
                const DecodedLayout& lines, const Banks& banks, const Grid<float>& ford_depth_m,
                const RoadRule& rule, Grid<float>* land_m, Grid<float>* share);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_ROADS_H_
