#ifndef LATTICEWORLD_TERRAIN_WAYS_CLIMBING_WAYS_H_
#define LATTICEWORLD_TERRAIN_WAYS_CLIMBING_WAYS_H_

#include <optional>
#include <vector>

#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/ways/street_network.h"
#include "latticeworld/terrain/ways/way_finder.h"

namespace latticeworld::internal {

// A way that climbs, and the slope that is said of it [m/m]; none: that of every road.
struct ClimbingWay {
  Street street;
  std::optional<double> slope;
};

// Ways from the next road to the top of what a road is said to climb, or to its pass: of least
// cost, where whatever is steeper than a share of the said slope, or than `max_slope` [m/m], is
// dear. Where there is no road, those whose slope is said begin at the world's edge, and no others
// do.
std::vector<ClimbingWay> ClimbingWays(const std::vector<ReliefWish>& wishes,
                                      const std::vector<ReliefPiece>& pieces,
                                      const WayFinder& finder, double max_slope);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_CLIMBING_WAYS_H_
