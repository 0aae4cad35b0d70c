#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_NAVIGATOR_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_NAVIGATOR_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/reference_navigator/navigator_options.h"

namespace latticeworld {

// Says where the robot may go, in the map frame.
struct CostMap {
  GridGeometry geometry;
  // (rows x cols), row 0 north; as nav_msgs/OccupancyGrid means it: -1 unknown, 0 free .. 100
  // closed; what lies between costs more.
  Grid<std::int8_t> cost;
};

// What a range sensor saw in one sweep.
struct SensorSighting {
  double time_s = 0.0;
  Eigen::Isometry3d map_from_sensor = Eigen::Isometry3d::Identity();
  // Ends of rays [m], sensor frame. Points that are not finite are left out.
  std::vector<Eigen::Vector3f> hits_m;
  std::vector<Eigen::Vector3f> misses_m;  // of rays that met nothing as far as that: they clear
  bool planar = false;                    // of a 2D scan: any hit may be rising ground
};

// Says where the robot is, by tf and odometry.
struct NavigatorPose {
  double time_s = 0.0;
  // x forward, z up; its origin is at most about the robot's height above the ground.
  Eigen::Isometry3d map_from_base = Eigen::Isometry3d::Identity();
  double speed_mps = 0.0;       // forward, by its wheels
  double yaw_rate_radps = 0.0;  // to the left
};

enum class NavigatorState : std::uint8_t { kIdle, kFollowing, kRecovering, kArrived, kFailed };

// What to do until the next Update.
struct NavigatorOutput {
  NavigatorState state = NavigatorState::kIdle;
  double speed_mps = 0.0;
  double yaw_rate_radps = 0.0;
  Status why;               // OK unless kFailed
  double way_left_m = 0.0;  // along the way, in plan
  // The way that is followed, from where it was planned to the goal, map frame; null: none.
  std::shared_ptr<const std::vector<WorldPoint>> way;
};

// Drives one robot to goals: a planner over a map of costs, a layer of what is seen that the map
// has not, and a controller of speeds, as docs/navigation.md describes. It knows what a robot
// knows and nothing of a simulation. Deterministic: the same calls give the same answers; time is
// what poses and sightings say. Not thread-safe.
class Navigator {
 public:
  // Errors: INVALID_ARGUMENT with every violation of the options.
  static Result<std::unique_ptr<Navigator>> Create(const NavigatorOptions& options);
  ~Navigator();
  Navigator(const Navigator&) = delete;
  Navigator& operator=(const Navigator&) = delete;

  // The map from here on; what is seen and the goal under way stay, and the next Update plans anew.
  // A cost grid that is not of the geometry's size is a bug of the caller.
  void SetMap(CostMap map);

  // Begins to drive to `goal`; heading_rad is what it should point to there (0 east, to the left),
  // where goal_heading_tolerance_rad is finite. Errors, which leave the goal before as it is:
  // INVALID_ARGUMENT (no finite numbers), OUT_OF_RANGE (outside the map, with its bounds),
  // FAILED_PRECONDITION (the map closes the place, or there is no map), NOT_FOUND (no way there).
  Status SetGoal(WorldPoint goal, std::optional<double> heading_rad, const NavigatorPose& pose);
  // Gives the goal up: kIdle.
  void Cancel();

  // What was seen; of any sensor, in the order of time.
  void See(const SensorSighting& sighting);
  // Forgets all that was seen.
  void Forget();

  // Every control period, at 5 to 50 Hz. After kArrived or kFailed it says so until the next goal.
  // A pose that is not finite commands a stop and changes nothing.
  NavigatorOutput Update(const NavigatorPose& pose);

  // A way by the map and by what is seen, within tolerance_m of the goal where the goal itself is
  // closed; the goal under way stays. Errors: those of SetGoal.
  Result<std::vector<WorldPoint>> Plan(WorldPoint start, WorldPoint goal, double tolerance_m) const;

 private:
  class Impl;
  explicit Navigator(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_NAVIGATOR_H_
