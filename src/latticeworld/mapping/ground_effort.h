#ifndef LATTICEWORLD_MAPPING_GROUND_EFFORT_H_
#define LATTICEWORLD_MAPPING_GROUND_EFFORT_H_

#include <algorithm>
#include <array>

#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// Whether they are what BuildTraversability takes.
bool AreLegal(const RobotLimits& limits);

// Steepest slope [rad] that the robot climbs on that surface: its own limit, or what the ground
// holds. Below 0: it cannot go there at all.
double SteepestSlope(const RobotLimits& limits, const SurfaceProperties& surface);

// How hard ground that nothing stands on is to cross, row by row.
class GroundEffort {
 public:
  static constexpr float kImpassable = 2.0f;

  // limits: legal. terrain: outlives this.
  GroundEffort(const Terrain& terrain, const RobotLimits& limits, const SurfaceTable& surfaces);

  // (cols): 0 level and dry .. 1 at a limit of the robot, or kImpassable.
  void Row(int row, float* effort) const;
  // The same of the columns [col_begin, col_end): (col_end - col_begin).
  void Row(int row, int col_begin, int col_end, float* effort) const;

 private:
  // The same of a few columns.
  void Piece(int row, int col_begin, int col_end, float* effort) const;

  struct Climb {
    float max_gradient;  // tangent of the steepest slope; below 0: none
    float slope_shares;  // one over the steepest slope [1/rad]
  };

  const Terrain& terrain_;
  std::array<Climb, kSurfaceClassCount> climbs_;
  float max_difference_m_, max_depth_m_;
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
