#ifndef LATTICEWORLD_LEARNING_ROBOT_VIEW_H_
#define LATTICEWORLD_LEARNING_ROBOT_VIEW_H_

#include <string>

#include "latticeworld/sensing/lidar/lidar_model.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

// What a learner is told of a robot, all of it doubles, so that a row of an array holds one.
struct RobotView {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;  // map
  double yaw_rad = 0.0;                    // map, counter-clockwise from east
  double forward_mps = 0.0;                // base_link
  double yaw_rate_radps = 0.0;             // base_link
  double health = 1.0;                     // [0, 1]
  double contact_n = 0.0;                  // hardest bump of the last step; 0: none
  double alive = 1.0;                      // 0: dead; -1: no longer in the world
};
inline constexpr int kRobotViewFields = 9;
static_assert(sizeof(RobotView) == kRobotViewFields * sizeof(double), "a row of doubles");

// nullptr: there is none of that name.
const AgentSnapshot* FindAgent(const WorldState& state, const std::string& name);
RobotView ViewOf(const AgentSnapshot& agent);

// The nearest return in each of `sectors` equal parts of a sweep, in 0 .. max_range_m, into
// sectors_m. What is nearer than the scanner sees, was dropped or met nothing counts as
// max_range_m, and so does everything while there is no sweep (null). Where there are more sectors
// than beams, each takes the beam at its begin.
void NearestInSectors(const LidarSweep* sweep, double min_range_m, int sectors, float max_range_m,
                      float* sectors_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LEARNING_ROBOT_VIEW_H_
