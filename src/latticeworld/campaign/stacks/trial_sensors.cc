#include "latticeworld/campaign/stacks/trial_sensors.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/sensed.h"

namespace latticeworld {
namespace {

constexpr double kKeptPoses_s = 1.5;  // longer than any sweep of the catalogue
constexpr double kTolerance_s = 1e-9;

// Returns the direction of a beam of a 2D scanner, a unit vector in the sensor's frame.
Eigen::Vector3f DirectionOf(const LidarModel& model, int column, int columns) {
  const double elevation = model.ring_elevations_rad.empty() ? 0.0 : model.ring_elevations_rad[0];
  const double azimuth = model.first_azimuth_rad + model.field_of_view_rad / columns * column;
  return Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth), std::sin(elevation))
      .cast<float>();
}

}  // namespace

Result<TrialSensors> TrialSensors::Create(std::shared_ptr<const Scene> scene,
                                          std::shared_ptr<const SpeciesCatalogue> species,
                                          const TrialSensorsOptions& options) {
  const auto catalogue = SensorCatalogue::BuiltIn();
  const SensorSuite* found = catalogue->FindSuite(options.suite);
  if (found == nullptr) return NotFound("there is no suite of sensors \"" + options.suite + "\"");
  const auto suite = std::make_shared<const SensorSuite>(*found);
  SensorRigOptions rig_options;
  rig_options.seed = options.seed;
  TrialSensors sensors(std::move(species), options);
  LW_ASSIGN_OR_RETURN(sensors.rig_,
                      SensorRig::Create(std::move(scene), rig_options,
                                        [suite, robot = options.robot](const SensedAgent& agent) {
                                          return agent.name == robot ? suite : nullptr;
                                        }));
  sensors.rig_->Restart(options.seed);
  return sensors;
}

Status TrialSensors::Step(const WorldState& state, double next_control_s) {
  const SensedWorld world = Sensed(state, *species_);
  const double now_s = world.time_s;
  for (const SensedAgent& agent : world.agents) {
    if (agent.name != options_.robot) continue;
    poses_.emplace_back(now_s, agent.map_from_base);
    height_m_ = agent.height_m;
    true_speed_mps_ = agent.linear_velocity_mps.dot(agent.map_from_base.linear().col(0));
    true_yaw_rate_radps_ = agent.angular_velocity_radps.z();
  }
  while (!poses_.empty() && poses_.front().first < now_s - kKeptPoses_s) poses_.pop_front();

  const auto wanted = [&](const std::string&, const SensorSpec& sensor) {
    SensorWish wish;
    wish.any = std::holds_alternative<WheelOdometryModel>(sensor.model);
    if (options_.scans && std::holds_alternative<LidarModel>(sensor.model)) {
      // Two revolutions: the first of them may have begun before.
      wish.any = sensor.rate_hz <= options_.control_hz ||
                 now_s >= next_control_s - 2.0 / sensor.rate_hz - kTolerance_s;
    }
    return wish;
  };
  LW_ASSIGN_OR_RETURN(auto frames, rig_->Step(world, options_.step_s, wanted));
  for (SensorFrame& frame : frames) {
    if (const auto* reading = std::get_if<WheelOdometryReading>(&frame.reading))
      odometry_ = *reading;
    if (!std::holds_alternative<LidarSweep>(frame.reading)) continue;
    const auto same = std::find_if(sweeps_.begin(), sweeps_.end(), [&](const SensorFrame& other) {
      return other.sensor->name == frame.sensor->name;
    });
    if (same != sweeps_.end()) sweeps_.erase(same);
    sweeps_.push_back(std::move(frame));
  }
  return Status();
}

Eigen::Isometry3d TrialSensors::PoseAt(double time_s) const {
  std::size_t after = poses_.size() - 1;
  while (after > 0 && poses_[after - 1].first >= time_s) --after;
  if (after == 0 || poses_[after].first <= time_s) return poses_[after].second;
  const auto& [from_s, from] = poses_[after - 1];
  const auto& [to_s, to] = poses_[after];
  const double share = (time_s - from_s) / (to_s - from_s);
  Eigen::Isometry3d pose;
  pose.linear() = Eigen::Quaterniond(from.linear())
                      .slerp(share, Eigen::Quaterniond(to.linear()))
                      .toRotationMatrix();
  pose.translation() = (1.0 - share) * from.translation() + share * to.translation();
  return pose;
}

StackScan TrialSensors::ScanOf(const SensorFrame& frame) const {
  const auto& sweep = std::get<LidarSweep>(frame.reading);
  const auto& model = std::get<LidarModel>(frame.sensor->model);
  const Eigen::Isometry3d base_from_sensor = BaseFromSensor(*frame.sensor, height_m_);
  StackScan scan;
  scan.time_s = sweep.end_s;
  scan.map_from_sensor = PoseAt(sweep.end_s) * base_from_sensor;
  scan.planar = sweep.rings == 1;
  const Eigen::Isometry3d end_from_map = scan.map_from_sensor.inverse();
  // Points are met from where the sensor then was.
  const auto end_from_fired = [&](double time_s) {
    return Eigen::Isometry3f((end_from_map * PoseAt(time_s) * base_from_sensor).cast<float>());
  };
  if (!scan.planar) {
    double last_s = -1.0;
    Eigen::Isometry3f moved = Eigen::Isometry3f::Identity();
    for (const LidarPoint& point : sweep.points) {
      const double fired_s = sweep.begin_s + 1e-9 * point.time_ns;
      // Columns within a millisecond share a pose.
      if (std::abs(fired_s - last_s) > 1e-3) {
        moved = end_from_fired(fired_s);
        last_s = fired_s;
      }
      scan.hits_m.push_back(moved * Eigen::Vector3f(point.x_m, point.y_m, point.z_m));
    }
    return scan;
  }
  // Beams of a 2D scanner are points, or misses as far as it sees; a few columns share a pose.
  const double column_s =
      model.field_of_view_rad / sweep.columns / (2.0 * M_PI * frame.sensor->rate_hz);
  Eigen::Isometry3f moved = Eigen::Isometry3f::Identity();
  for (int column = 0; column < sweep.columns; ++column) {
    if (column % 16 == 0) moved = end_from_fired(sweep.begin_s + column_s * column);
    const float range_m = sweep.ranges_m[static_cast<std::size_t>(column)];
    const Eigen::Vector3f direction = DirectionOf(model, column, sweep.columns);
    if (std::isfinite(range_m)) {
      scan.hits_m.push_back(moved * Eigen::Vector3f(range_m * direction));
    } else if (range_m > 0.0f) {
      scan.misses_m.push_back(moved *
                              Eigen::Vector3f(static_cast<float>(model.max_range_m) * direction));
    }
  }
  return scan;
}

StackInput TrialSensors::Take() {
  StackInput input;
  if (poses_.empty()) return input;
  input.time_s = poses_.back().first;
  input.map_from_base = poses_.back().second;
  input.speed_mps = odometry_ ? odometry_->forward_mps : true_speed_mps_;
  input.yaw_rate_radps = odometry_ ? odometry_->yaw_rate_radps : true_yaw_rate_radps_;
  for (const SensorFrame& frame : sweeps_) input.scans.push_back(ScanOf(frame));
  sweeps_.clear();
  return input;
}

}  // namespace latticeworld
