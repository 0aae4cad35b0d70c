#ifndef LATTICEWORLD_TESTS_GEOMETRY_IN_REGION_H_
#define LATTICEWORLD_TESTS_GEOMETRY_IN_REGION_H_

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geometry/region.h"

namespace latticeworld {

// Whether a point of the world [m] lies in the region; borders belong to both sides.
inline bool IsIn(Region region, const GridGeometry& geometry, WorldPoint point) {
  return BoxOf(region).Contains((point.x_m + geometry.half_size_m()) / geometry.size_m(),
                                (geometry.half_size_m() - point.y_m) / geometry.size_m());
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_GEOMETRY_IN_REGION_H_
