#ifndef LATTICEWORLD_MAPPING_GROUND_EFFORT_H_
#define LATTICEWORLD_MAPPING_GROUND_EFFORT_H_

#include <algorithm>

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
  // The same of the columns [col_begin, col_end): (col_end - col_begin).
  void Row(int row, int col_begin, int col_end, float* effort) const;

 private:
  const Terrain& terrain_;
  float max_slope_rad_, max_gradient_, max_difference_m_, max_depth_m_;
};

// What BuildTraversability makes of an effort. A slope at the robot's limit is still passable, and
// so not quite 0.
inline float TraversabilityOf(float effort) {
  constexpr float kMinPassable = 0.02f;
  return effort > 1.0f ? 0.0f : std::max(1.0f - effort, kMinPassable);
}

// Slope [rad] of one row of the ground, (cols).
void SlopeOfRow(const Terrain& terrain, int row, float* slope_rad);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_GROUND_EFFORT_H_
