#ifndef LATTICEWORLD_TERRAIN_WAYS_GRADED_WAYS_H_
#define LATTICEWORLD_TERRAIN_WAYS_GRADED_WAYS_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/ways/climbing_ways.h"

namespace latticeworld::internal {

// Grades ways whose slope is said into the land [m], each along its own centre line, level across,
// by cut and fill: no steeper than a little less than what is said. A way begins as high as the
// road that it leaves. embankment_slope: of cuts and fills beside them [m/m]. road: 1 on graded
// roads, which stay as they are. share: gets how much of each cell the ways shape, in [0, 1].
void GradeWays(const GridGeometry& lattice, const std::vector<ClimbingWay>& ways,
               const Grid<unsigned char>& road, double embankment_slope, Grid<float>* land_m,
               Grid<float>* share);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_GRADED_WAYS_H_
