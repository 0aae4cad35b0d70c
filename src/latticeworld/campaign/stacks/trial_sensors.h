#ifndef LATTICEWORLD_CAMPAIGN_STACKS_TRIAL_SENSORS_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_TRIAL_SENSORS_H_

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/campaign/stacks/robot_stack.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

struct TrialSensorsOptions {
  std::string robot;       // the agent that carries them
  std::string suite;       // of the built-in sensor catalogue
  std::uint64_t seed = 1;  // of noise
  double step_s = 0.01;    // of the simulation
  double control_hz = 10.0;
  bool scans = true;  // whether anybody looks at lidars
};

// The sensors of the robot of a trial: lidars and wheel odometry, and nothing that nobody looks at.
class TrialSensors {
 public:
  // Errors: NOT_FOUND (the suite), Embree's.
  static Result<TrialSensors> Create(std::shared_ptr<const Scene> scene,
                                     std::shared_ptr<const SpeciesCatalogue> species,
                                     const TrialSensorsOptions& options);

  // Is to be called after every step of the simulation, with the state before the first one too.
  // next_control_s: when the stack is asked next, so that no sweep is cast that it will not see.
  Status Step(const WorldState& state, double next_control_s);

  // The newest sweep of each lidar since the last call, and the pose as tf has it: ground truth.
  // Speeds are those of the last wheel odometry, or, of robots without one, the true ones.
  StackInput Take();

 private:
  TrialSensors(std::shared_ptr<const SpeciesCatalogue> species, const TrialSensorsOptions& options)
      : species_(std::move(species)), options_(options) {}
  StackScan ScanOf(const SensorFrame& frame) const;
  // map_from_base at that time, between two steps.
  Eigen::Isometry3d PoseAt(double time_s) const;

  std::shared_ptr<const SpeciesCatalogue> species_;
  TrialSensorsOptions options_;
  std::unique_ptr<SensorRig> rig_;
  std::deque<std::pair<double, Eigen::Isometry3d>> poses_;  // of the last steps, by time
  double height_m_ = 0.0;                                   // of the robot
  double true_speed_mps_ = 0.0, true_yaw_rate_radps_ = 0.0;
  std::optional<WheelOdometryReading> odometry_;
  std::vector<SensorFrame> sweeps_;  // the newest of each lidar
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_TRIAL_SENSORS_H_
