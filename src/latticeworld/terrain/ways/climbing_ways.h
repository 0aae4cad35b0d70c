#ifndef LATTICEWORLD_TERRAIN_WAYS_CLIMBING_WAYS_H_
#define LATTICEWORLD_TERRAIN_WAYS_CLIMBING_WAYS_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/ways/street_network.h"

namespace latticeworld::internal {

// The ground that ways are laid over, on the lattice.
struct ClimbingGround {
  const Grid<float>& height_m;
  const Grid<unsigned char>& road;     // 1 where the layout's roads are: where ways begin
  const Grid<unsigned char>& blocked;  // 1 where no way goes: water, buildings
};

// Ways from the next road to the top of what a road is said to climb: of least cost, where whatever
// is steeper than `max_slope` [m/m] is dear, so that they bend back and forth where they must
// (Galin et al. 2010, "Procedural generation of roads"). None where there is no road.
std::vector<Street> ClimbingWays(const std::vector<ReliefWish>& wishes,
                                 const std::vector<ReliefPiece>& pieces,
                                 const GridGeometry& lattice, const ClimbingGround& ground,
                                 double max_slope);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_CLIMBING_WAYS_H_
