#ifndef LATTICEWORLD_TESTS_SENSING_RIG_WORLD_FOR_TESTS_H_
#define LATTICEWORLD_TESTS_SENSING_RIG_WORLD_FOR_TESTS_H_

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/sensing/sensor_rig.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {

inline constexpr double kStep_s = 0.005;

inline Scene LevelScene(double height_m = 0.0) {
  return MakeScene(64, 128.0, [height_m](double, double) { return height_m; });
}

// A robot that goes at an even speed and turns evenly about z, from the origin at time 0.
inline SensedAgent RobotAt(double time_s, const Eigen::Vector3d& velocity_mps, double turn_radps,
                           const std::string& name = "robot") {
  SensedAgent robot;
  robot.name = name;
  robot.category = AgentCategory::kWheeledRobot;
  robot.height_m = 0.5;
  robot.has_sensors = true;
  robot.map_from_base.translation() = time_s * velocity_mps;
  robot.map_from_base.rotate(Eigen::AngleAxisd(turn_radps * time_s, Eigen::Vector3d::UnitZ()));
  robot.linear_velocity_mps = velocity_mps;
  robot.angular_velocity_radps = turn_radps * Eigen::Vector3d::UnitZ();
  return robot;
}

inline SensedWorld WorldAt(std::uint64_t step, std::vector<SensedAgent> agents) {
  SensedWorld world;
  world.step = step;
  world.time_s = static_cast<double>(step) * kStep_s;
  world.atmosphere.visibility_m = 1e9;
  world.agents = std::move(agents);
  return world;
}

inline SensedProp CrateAt(const Eigen::Vector3d& base_m, const Eigen::Vector3d& size_m) {
  SensedProp crate;
  crate.name = "crate_1";
  crate.kind = PropKind::kCrate;
  crate.size_m = size_m;
  crate.map_from_prop.translation() = base_m;
  return crate;
}

template <typename Model>
SensorSpec Spec(const std::string& name, double rate_hz, const Model& model,
                const Eigen::Vector3d& place_m = Eigen::Vector3d(0.0, 0.0, 1.0)) {
  SensorSpec spec;
  spec.name = name;
  spec.rate_hz = rate_hz;
  spec.base_from_sensor_m = place_m;
  spec.model = model;
  return spec;
}

// Without noise, all around.
inline LidarModel Scanner(int columns = 360) {
  LidarModel model;
  model.name = "scanner";
  model.ring_elevations_rad = {0.0};
  model.columns = columns;
  model.noise_m = 0.0;
  model.max_range_m = 60.0;
  model.min_range_m = 0.05;
  return model;
}

inline std::unique_ptr<SensorRig> RigOf(const Scene& scene, std::vector<SensorSpec> sensors,
                                        const SensorRigOptions& options = {}) {
  auto suite = std::make_shared<SensorSuite>();
  suite->name = "test";
  suite->sensors = std::move(sensors);
  return SensorRig::Create(std::make_shared<Scene>(scene), options,
                           [suite](const SensedAgent&) { return suite; })
      .value();
}

inline SensorWish Everything() { return {true, {true, true, true, true}}; }
inline SensorWish WantAll(const std::string&, const SensorSpec&) { return Everything(); }

// Those of steps [0, steps] of a world that `world_at` tells.
inline std::vector<SensorFrame> FramesOf(SensorRig* rig, int steps,
                                         const std::function<SensedWorld(std::uint64_t)>& world_at,
                                         const SensorRig::Wanted& wanted = WantAll) {
  std::vector<SensorFrame> frames;
  for (int step = 0; step <= steps; ++step) {
    std::vector<SensorFrame> of_step = rig->Step(world_at(step), kStep_s, wanted).value();
    for (SensorFrame& frame : of_step) {
      frames.push_back(std::move(frame));
    }
  }
  return frames;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SENSING_RIG_WORLD_FOR_TESTS_H_
