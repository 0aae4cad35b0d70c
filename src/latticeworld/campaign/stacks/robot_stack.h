#ifndef LATTICEWORLD_CAMPAIGN_STACKS_ROBOT_STACK_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_ROBOT_STACK_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/campaign/campaign.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/navigation/tasks.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// One revolution of a lidar, each echo where it was when it was met.
struct StackScan {
  double time_s = 0.0;                                                // its end
  Eigen::Isometry3d map_from_sensor = Eigen::Isometry3d::Identity();  // at that time
  std::vector<Eigen::Vector3f> hits_m;    // in the sensor's frame of that time
  std::vector<Eigen::Vector3f> misses_m;  // ends of beams that met nothing
  bool planar = false;                    // of a 2D scanner
};

// What a robot knows at one moment.
struct StackInput {
  double time_s = 0.0;
  Eigen::Isometry3d map_from_base = Eigen::Isometry3d::Identity();  // as tf has it
  double speed_mps = 0.0, yaw_rate_radps = 0.0;                     // by its wheels' encoders
  std::vector<StackScan> scans;                                     // since the last one, by time
};

enum class StackState : std::uint8_t { kDriving, kArrived, kFailed };
struct StackOutput {
  StackState state = StackState::kDriving;
  double speed_mps = 0.0, yaw_rate_radps = 0.0;
  std::string why;  // of kFailed
};

// What a stack is told before it begins.
struct StackTask {
  const CampaignRobot& robot;
  const Species& species;
  const GridGeometry& geometry;
  const Grid<std::int8_t>& occupancy;  // of the robot's limits, as BuildOccupancy has it
  const NavigationTask& task;
  double control_hz;  // how often it is asked
};

// Drives a robot to a goal. Those of StackNames() are deterministic.
class RobotStack {
 public:
  virtual ~RobotStack() = default;
  // Whether it looks at StackInput::scans.
  virtual bool UsesScans() const = 0;
  // Errors: why the task cannot be begun.
  virtual Status Begin(const StackTask& task, const StackInput& start) = 0;
  virtual StackOutput Update(const StackInput& input) = 0;
};

// "reference": the navigator of docs/navigation.md. "way": follows the task's shortest way without
// looking, as a measure of what the way alone is worth.
std::vector<std::string> StackNames();
// The one of them that the robot names, or its program.
std::unique_ptr<RobotStack> MakeStack(const CampaignRobot& robot);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_ROBOT_STACK_H_
