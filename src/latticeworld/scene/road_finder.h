#ifndef LATTICEWORLD_SCENE_ROAD_FINDER_H_
#define LATTICEWORLD_SCENE_ROAD_FINDER_H_

#include <optional>
#include <vector>

#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// Finds the nearest road cell within reach, for buildings that stand along it.
class RoadFinder {
 public:
  static constexpr double kReach_m = 48.0;

  // Looks at every cell of coarse resolutions, and at one a metre of fine ones.
  explicit RoadFinder(const Terrain& terrain);

  struct Road {
    double distance_m;   // to the centre of the nearest cell of it
    double heading_rad;  // from the point towards the road, the mean over the cells that are nearly
                         // as near, which is square to a straight road
  };
  // nullopt: no road within kReach_m, or the point is on one.
  std::optional<Road> Nearest(WorldPoint point) const;

 private:
  GridGeometry buckets_;
  Grid<std::vector<WorldPoint>> cells_;  // centres of road cells by bucket
  bool any_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_ROAD_FINDER_H_
