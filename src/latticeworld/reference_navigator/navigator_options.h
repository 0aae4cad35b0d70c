#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_NAVIGATOR_OPTIONS_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_NAVIGATOR_OPTIONS_H_

#include <limits>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// The robot that is driven, as its maker states it.
struct NavigatorRobot {
  double radius_m = 0.4;                     // [0.05, 5] of the circle that holds it in plan
  double max_speed_mps = 1.0;                // [0.05, 20] forward
  double max_reverse_mps = 0.3;              // [0, 20] 0: it cannot go backward
  double max_yaw_rate_radps = 1.0;           // [0.05, 20]
  double max_acceleration_mps2 = 1.0;        // [0.05, 50] and deceleration
  double max_yaw_acceleration_radps2 = 2.0;  // [0.05, 100]
  double min_turn_radius_m = 0.0;            // [0, 20] 0: it turns on the spot; above: it steers
  double max_slope_rad = 0.5236;             // [0.01, 1.4] that it can climb
  double max_step_m = 0.25;                  // [0.01, 5] that it can climb
  double height_m = 0.5;  // [0.05, 10] what is higher above the ground is no obstacle
};

struct NavigatorOptions {
  NavigatorRobot robot;
  // What arrival means: the base is so near the goal in plan, stands, and points so.
  double goal_radius_m = 0.5;                                                   // [0.05, 20]
  double goal_heading_tolerance_rad = std::numeric_limits<double>::infinity();  // above 0; inf: any
  // The map.
  int closed_cost = 100;        // [1, 100] from here on a cell is closed
  bool unknown_is_free = true;  // of cells of -1
  // Whether a closed cell says that the robot's centre cannot be in it, as the maps of this
  // project's worlds do. False: it holds an obstacle, which is grown by the robot's radius.
  bool map_is_inflated = true;
  double cost_weight = 2.0;       // [0, 100] a metre over cost 100 counts as 1 + so many metres
  double clearance_weight = 1.0;  // [0, 100] a metre along a closed cell counts as 1 + so many
  double clearance_m = 1.0;       // [0, 10] beyond which nearness to closed cells is no matter
  // What is seen.
  double local_size_m = 25.6;       // [4, 200] side of the square around the robot
  double local_resolution_m = 0.1;  // [0.02, 1]; local_size_m is at most 2000 of it
  double margin_m = 0.08;           // [0, 2] kept from what is seen, beyond the robot's radius
  double memory_s = 20.0;           // [0.5, 3600] until what is out of sight is forgotten
  // The controller.
  double lookahead_m = 1.2;  // [0.1, 20] at top speed; less the slower it goes
  double horizon_s = 1.0;    // [0.5, 10] that arcs are looked at
  // The following say when it gives up.
  double patience_s = 8.0;  // [0.5, 600] without progress until it tries to free itself
  int recoveries = 6;       // [0, 100] in a row without progress between them; then it fails
  double time_limit_s = std::numeric_limits<double>::infinity();  // above 0, of one goal
};

// Every violation; pointers are the fields' names ("robot.radius_m", "goal_radius_m").
std::vector<Violation> Validate(const NavigatorOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_NAVIGATOR_OPTIONS_H_
