#ifndef LATTICEWORLD_NAVIGATION_DISTANCE_FIELD_H_
#define LATTICEWORLD_NAVIGATION_DISTANCE_FIELD_H_

#include <limits>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

struct NavigableMap;

// How far it is from every place to one goal along the ground.
struct DistanceField {
  GridGeometry geometry;
  WorldPoint goal;
  // (rows x cols) geodesic distance of cell centres [m]; infinity: no way, or farther than asked.
  Grid<float> distance_m;

  // Interpolated between the reachable ones of the four centres around; infinity where none is.
  double At(WorldPoint point) const;
};

// Fast marching on the surface (Sethian 1996; Kimmel and Sethian 1998): every vertex is updated
// from the eight flat triangles between it and two neighbours side by side, whose angle there is
// acute on any ground that a robot climbs; a queue of buckets (Yatziv, Bartesaghi and Sapiro 2006)
// keeps it linear in cells. Within a few cells of the goal distances are those of straight lines.
// Distances are a little too long: by less than 1 % from twenty cells on. max_m: cells farther than
// this stay at infinity. Errors: FAILED_PRECONDITION (the goal is not free), OUT_OF_RANGE
// (outside), INVALID_ARGUMENT (not finite).
Result<DistanceField> DistancesTo(const NavigableMap& map, WorldPoint goal,
                                  double max_m = std::numeric_limits<double>::infinity());

}  // namespace latticeworld

#endif  // LATTICEWORLD_NAVIGATION_DISTANCE_FIELD_H_
