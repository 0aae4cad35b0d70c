#ifndef LATTICEWORLD_SENSING_SENSOR_SUITE_H_
#define LATTICEWORLD_SENSING_SENSOR_SUITE_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/sensing/camera/camera_model.h"
#include "latticeworld/sensing/lidar/lidar_model.h"
#include "latticeworld/sensing/motion/motion_sensors.h"

namespace latticeworld {

// Which pictures a camera gives.
struct CameraOutputs {
  bool colour = false, depth = false, class_labels = false, instance_labels = false;
};

struct CameraSensor {
  CameraModel model;
  CameraOutputs outputs;
};

// One sensor of a robot. Its frame is <robot>/<name>; x forward, z up; a camera's pictures are in
// <robot>/<name>_optical (z forward, x right, y down).
struct SensorSpec {
  std::string name;       // unique in the suite, a ROS base name; topics and frames begin with it
  double rate_hz = 10.0;  // of simulated time, (0, 1000]; what steps cannot hit exactly is taken at
                          // the first step at or after its time
  Eigen::Vector3d base_from_sensor_m = Eigen::Vector3d::Zero();  // z from base_link, or, where
  bool on_top = false;                                           // on_top, from the body's top
  Eigen::Vector3d roll_pitch_yaw_rad = Eigen::Vector3d::Zero();
  std::variant<LidarModel, CameraSensor, ImuModel, GnssModel, MagnetometerModel, WheelOdometryModel,
               BumperModel>
      model;
};

// Returns the pose of a sensor on a body of that height [m].
Eigen::Isometry3d BaseFromSensor(const SensorSpec& spec, double body_height_m);

// What a robot carries.
struct SensorSuite {
  std::string name;                 // "none", "standard", "survey"
  std::vector<SensorSpec> sensors;  // by name
};

// Most beams of one revolution that a lidar may have.
inline constexpr int kMaxBeams = 1 << 21;

// Suites and the models of lidars that they name. Immutable and shared. The built-in ones are data
// files of this room; users add or replace with files of the same schema.
class SensorCatalogue {
 public:
  // "none" (nothing), "scanner" (2D scan, IMU, wheel odometry, bumper), "standard" (GNSS,
  // magnetometer, depth and colour camera of 320 x 240 beside these), "survey" (3D lidar of
  // 64 x 1024, camera of 640 x 480), "perception" (labels too) and more.
  static std::shared_ptr<const SensorCatalogue> BuiltIn();
  // The built-in ones and those of files, or of every *.json of a folder. Errors: NOT_FOUND,
  // INVALID_ARGUMENT with every violation (JSON pointer, value, what is legal).
  static Result<std::shared_ptr<const SensorCatalogue>> Load(
      const std::vector<std::filesystem::path>& paths);
  // The same from texts: {name of the file, its text}.
  static Result<std::shared_ptr<const SensorCatalogue>> Extended(
      const std::vector<std::pair<std::string, std::string>>& files);
  // JSON Schema (draft 7) of a file.
  static std::string_view schema();

  const std::vector<SensorSuite>& suites() const { return suites_; }  // sorted by name
  const std::vector<LidarModel>& lidars() const { return lidars_; }   // sorted by name
  const SensorSuite* FindSuite(std::string_view name) const;          // nullptr: there is none
  const LidarModel* FindLidar(std::string_view name) const;

 private:
  friend class SensorCatalogueBuilder;
  SensorCatalogue() = default;
  std::vector<SensorSuite> suites_;
  std::vector<LidarModel> lidars_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SENSOR_SUITE_H_
