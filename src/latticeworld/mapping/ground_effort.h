#ifndef LATTICEWORLD_MAPPING_GROUND_EFFORT_H_
#define LATTICEWORLD_MAPPING_GROUND_EFFORT_H_

#include "latticeworld/mapping/traversability.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// How hard ground that nothing stands on is to cross, row by row.
class GroundEffort {
 public:
  static constexpr float kImpassable = 2.0f;

  GroundEffort(const Terrain& terrain, const RobotLimits& limits);

  // (cols): 0 level and dry .. 1 at a limit of the robot, or kImpassable.
  void Row(int row, float* effort) const;

 private:
  const Terrain& terrain_;
  float max_slope_rad_, max_gradient_, max_difference_m_, max_depth_m_;
};

// Slope [rad] of one row of the ground, (cols).
void SlopeOfRow(const Terrain& terrain, int row, float* slope_rad);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_GROUND_EFFORT_H_
