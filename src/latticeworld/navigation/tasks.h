#ifndef LATTICEWORLD_NAVIGATION_TASKS_H_
#define LATTICEWORLD_NAVIGATION_TASKS_H_

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/navigation/surface_path.h"

namespace latticeworld {

struct Scene;

// How hard a way is, measured on the shortest one.
struct TaskDifficulty {
  double length_m = 0.0;  // of the shortest way, on the surface
  double climb_m = 0.0;   // all that it goes up
  double density =
      0.0;              // share of the ground within kDensityReach_m of it that is not free, [0, 1]
  double detour = 1.0;  // its length by that of the straight line in space, >= 1
  int agents = 0;       // that begin within kAgentReach_m of it, the controllable ones left out
};
inline constexpr double kDensityReach_m = 3.0;
inline constexpr double kAgentReach_m = 20.0;

// Says from where to where a robot is to go. Solvable: `way` is free for the robot all along.
struct NavigationTask {
  WorldPoint start;
  double start_heading_rad = 0.0;
  WorldPoint goal;
  double goal_radius_m = 0.5;
  TaskDifficulty difficulty;
  SurfacePath way;
};

struct DifficultyRange {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  bool Contains(double value) const { return value >= low && value <= high; }
};

struct TaskWishes {
  int count = 10;  // [1, 1000]
  std::uint64_t seed = 1;
  RobotLimits robot;
  double goal_radius_m = 0.5;  // (0, 100]
  DifficultyRange length_m{20.0};
  DifficultyRange climb_m, density, detour, agents;
};
// Errors: INVALID_ARGUMENT with every violation: ranges that are none, counts, radius.
Status Validate(const TaskWishes& wishes);

// Draws goals evenly from what is free, and starts from what has a way there of a wanted length,
// until `count` are of the wanted difficulty. The robot's disc lies within the world less its
// outermost cells all along, and at a start where agents are put (scene/agents/spawn_rules.h). The
// same scene and wishes: the same tasks. A thousand ways are tried for each task at most. Reports
// the stage "tasks". Errors: INVALID_ARGUMENT; FAILED_PRECONDITION: too few were found, naming the
// ranges that kept the ways out and what the world offers; CANCELLED.
Result<std::vector<NavigationTask>> SampleTasks(const Scene& scene, const TaskWishes& wishes,
                                                const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_NAVIGATION_TASKS_H_
