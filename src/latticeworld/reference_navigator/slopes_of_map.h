#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_SLOPES_OF_MAP_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_SLOPES_OF_MAP_H_

#include "latticeworld/reference_navigator/navigator.h"
#include "latticeworld/reference_navigator/obstacle_layer.h"

namespace latticeworld {

// Slopes as maps of costs have them: cost 50 is the steepest that the robot climbs.
class SlopesOfMap final : public GroundGuess {
 public:
  // map: has to outlive it.
  SlopesOfMap(const CostMap& map, double max_slope_rad) : map_(map), slope_(max_slope_rad) {}
  double MostRise(WorldPoint from, WorldPoint to) const override;

 private:
  const CostMap& map_;
  double slope_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_SLOPES_OF_MAP_H_
