#include "latticeworld/sensing/sensor_file.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "latticeworld/common/data_files.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"
#include "latticeworld/sensing/sensor_rules.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

constexpr double kRadPerDeg = M_PI / 180.0;
constexpr const char* kModelKeys[] = {"lidar",        "camera",         "imu",   "gnss",
                                      "magnetometer", "wheel_odometry", "bumper"};

// What the json has of the key; else it stays as it is.
template <typename Value>
void Read(const Json& json, const char* key, Value* value) {
  const auto found = json.find(key);
  if (found != json.end()) *value = found->get<Value>();
}
void ReadDegrees(const Json& json, const char* key, double* value_rad) {
  const auto found = json.find(key);
  if (found != json.end()) *value_rad = found->get<double>() * kRadPerDeg;
}

std::vector<double> RingsOf(const Json& json) {
  std::vector<double> rings_rad;
  if (json.contains("ring_elevations_deg")) {
    for (const double ring_deg : json.at("ring_elevations_deg").get<std::vector<double>>()) {
      rings_rad.push_back(ring_deg * kRadPerDeg);
    }
  } else if (json.contains("evenly_spaced_rings")) {
    const Json& even = json.at("evenly_spaced_rings");
    const int count = even.at("count");
    const double low_deg = even.at("lowest_deg"), high_deg = even.at("highest_deg");
    for (int i = 0; i < count; ++i) {
      rings_rad.push_back((low_deg + (high_deg - low_deg) * i / (count - 1)) * kRadPerDeg);
    }
  } else {
    rings_rad = {0.0};
  }
  return rings_rad;
}

// json: keeps to the schema, here and below.
LidarModel ReadLidarModel(const Json& json) {
  LidarModel model;
  model.name = json.at("name");
  model.source = json.at("source");
  model.ring_elevations_rad = RingsOf(json);
  if (json.contains("ring_azimuths_deg")) {
    const auto pattern_deg = json.at("ring_azimuths_deg").get<std::vector<double>>();
    for (std::size_t i = 0; i < model.ring_elevations_rad.size(); ++i) {
      model.ring_azimuths_rad.push_back(pattern_deg[i % pattern_deg.size()] * kRadPerDeg);
    }
  }
  model.first_azimuth_rad = -M_PI;
  model.field_of_view_rad = 2.0 * M_PI;
  Read(json, "columns", &model.columns);
  ReadDegrees(json, "first_azimuth_deg", &model.first_azimuth_rad);
  ReadDegrees(json, "field_of_view_deg", &model.field_of_view_rad);
  Read(json, "ring_delay_s", &model.ring_delay_s);
  Read(json, "min_range_m", &model.min_range_m);
  Read(json, "max_range_m", &model.max_range_m);
  Read(json, "max_range_reflectivity", &model.max_range_reflectivity);
  Read(json, "noise_m", &model.noise_m);
  Read(json, "range_step_m", &model.range_step_m);
  Read(json, "dropout_probability", &model.dropout_probability);
  return model;
}

CameraSensor ReadCamera(const Json& json) {
  CameraSensor camera;
  CameraModel& model = camera.model;
  for (const Json& output : json.at("outputs")) {
    if (output == "colour") camera.outputs.colour = true;
    if (output == "depth") camera.outputs.depth = true;
    if (output == "class_labels") camera.outputs.class_labels = true;
    if (output == "instance_labels") camera.outputs.instance_labels = true;
  }
  Read(json, "width", &model.width);
  Read(json, "height", &model.height);
  Read(json, "fx_px", &model.fx_px);
  Read(json, "fy_px", &model.fy_px);
  Read(json, "cx_px", &model.cx_px);
  Read(json, "cy_px", &model.cy_px);
  Read(json, "distortion", &model.distortion);
  Read(json, "near_m", &model.near_m);
  Read(json, "far_m", &model.far_m);
  Read(json, "depth_noise", &model.depth_noise);
  Read(json, "colour_noise", &model.colour_noise);
  return camera;
}

InertialNoise ReadInertialNoise(const Json& json, const char* key) {
  InertialNoise noise;
  if (!json.contains(key)) return noise;
  Read(json.at(key), "density", &noise.density);
  Read(json.at(key), "bias", &noise.bias);
  Read(json.at(key), "bias_instability", &noise.bias_instability);
  Read(json.at(key), "bias_time_s", &noise.bias_time_s);
  return noise;
}

ImuModel ReadImu(const Json& json) {
  ImuModel model;
  model.gyroscope = ReadInertialNoise(json, "gyroscope");
  model.accelerometer = ReadInertialNoise(json, "accelerometer");
  Read(json, "max_rate_radps", &model.max_rate_radps);
  Read(json, "max_acceleration_mps2", &model.max_acceleration_mps2);
  Read(json, "gives_orientation", &model.gives_orientation);
  return model;
}

GnssModel ReadGnss(const Json& json) {
  GnssModel model;
  Read(json, "horizontal_noise_m", &model.horizontal_noise_m);
  Read(json, "vertical_noise_m", &model.vertical_noise_m);
  Read(json, "horizontal_wander_m", &model.horizontal_wander_m);
  Read(json, "vertical_wander_m", &model.vertical_wander_m);
  Read(json, "wander_time_s", &model.wander_time_s);
  Read(json, "canopy_factor", &model.canopy_factor);
  return model;
}

void ReadModel(const Json& json, SensorEntry* entry) {
  if (json.contains("lidar")) {
    entry->lidar = json.at("lidar").at("model");
    if (json.at("lidar").contains("columns")) entry->columns = json.at("lidar").at("columns");
    entry->spec.model = LidarModel();
  } else if (json.contains("camera")) {
    entry->spec.model = ReadCamera(json.at("camera"));
  } else if (json.contains("imu")) {
    entry->spec.model = ReadImu(json.at("imu"));
  } else if (json.contains("gnss")) {
    entry->spec.model = ReadGnss(json.at("gnss"));
  } else if (json.contains("magnetometer")) {
    MagnetometerModel model;
    Read(json.at("magnetometer"), "noise_t", &model.noise_t);
    Read(json.at("magnetometer"), "bias_t", &model.bias_t);
    entry->spec.model = model;
  } else if (json.contains("wheel_odometry")) {
    WheelOdometryModel model;
    const Json& odometry = json.at("wheel_odometry");
    Read(odometry, "ticks_per_revolution", &model.ticks_per_revolution);
    Read(odometry, "a1", &model.a1);
    Read(odometry, "a2", &model.a2);
    Read(odometry, "a3", &model.a3);
    Read(odometry, "a4", &model.a4);
    Read(odometry, "slip", &model.slip);
    Read(odometry, "skid_radpm", &model.skid_radpm);
    entry->spec.model = model;
  } else {
    BumperModel model;
    Read(json.at("bumper"), "threshold_n", &model.threshold_n);
    entry->spec.model = model;
  }
}

SensorEntry ReadSensor(const Json& json, const std::string& pointer) {
  SensorEntry entry;
  entry.pointer = pointer;
  entry.spec.name = json.at("name");
  Read(json, "rate_hz", &entry.spec.rate_hz);
  Read(json, "on_top", &entry.spec.on_top);
  for (int axis = 0; axis < 3; ++axis) {
    if (json.contains("position_m")) {
      entry.spec.base_from_sensor_m[axis] = json.at("position_m")[axis];
    }
    if (json.contains("roll_pitch_yaw_deg")) {
      entry.spec.roll_pitch_yaw_rad[axis] =
          json.at("roll_pitch_yaw_deg")[axis].get<double>() * kRadPerDeg;
    }
  }
  ReadModel(json, &entry);
  return entry;
}

// What a schema of this project cannot say: that exactly one, or at most one, of some keys is
// there.
int CountOf(const Json& json, const char* const* begin, const char* const* end) {
  int count = 0;
  for (const char* const* key = begin; key != end; ++key) count += json.contains(*key) ? 1 : 0;
  return count;
}

void CheckOneModel(const Json& json, const std::string& pointer,
                   std::vector<Violation>* violations) {
  const int count = CountOf(json, std::begin(kModelKeys), std::end(kModelKeys));
  if (count == 1) return;
  violations->push_back({"wrong_count", pointer,
                         "must have one key of " +
                             Join({std::begin(kModelKeys), std::end(kModelKeys)}, ", ") + ", not " +
                             std::to_string(count),
                         std::to_string(count)});
}

void ReadLidars(const Json& json, const std::string& origin, SensorFile* file,
                std::vector<Violation>* violations) {
  constexpr const char* kRingKeys[] = {"ring_elevations_deg", "evenly_spaced_rings"};
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string pointer = origin + "/lidars/" + std::to_string(i);
    if (!IsSound(pointer, *violations)) continue;
    if (CountOf(json[i], std::begin(kRingKeys), std::end(kRingKeys)) > 1) {
      violations->push_back({"wrong_count", pointer,
                             "must have at most one key of ring_elevations_deg, "
                             "evenly_spaced_rings, not 2",
                             "2"});
      continue;
    }
    LidarEntry entry = {ReadLidarModel(json[i]), pointer};
    CheckLidar(entry.model, pointer, violations);
    if (IsSound(pointer, *violations)) file->lidars.push_back(std::move(entry));
  }
}

void ReadSuites(const Json& json, const std::string& origin, SensorFile* file,
                std::vector<Violation>* violations) {
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string pointer = origin + "/suites/" + std::to_string(i);
    if (!IsSound(pointer, *violations)) continue;
    SuiteEntry suite;
    suite.name = json[i].at("name");
    suite.pointer = pointer;
    Read(json[i], "extends", &suite.extends);
    const Json& sensors = json[i].at("sensors");
    for (std::size_t k = 0; k < sensors.size(); ++k) {
      const std::string at = pointer + "/sensors/" + std::to_string(k);
      CheckOneModel(sensors[k], at, violations);
      if (!IsSound(at, *violations)) continue;
      SensorEntry entry = ReadSensor(sensors[k], at);
      CheckSensorName(entry.spec.name, at, violations);
      for (const SensorEntry& before : suite.sensors) {
        if (before.spec.name != entry.spec.name) continue;
        violations->push_back({"duplicate_value", at + "/name",
                               "a sensor of this name stands at " + before.pointer,
                               Quote(entry.spec.name)});
      }
      if (const auto* camera = std::get_if<CameraSensor>(&entry.spec.model)) {
        CheckCamera(camera->model, at + "/camera", violations);
      }
      suite.sensors.push_back(std::move(entry));
    }
    if (IsSound(pointer, *violations)) file->suites.push_back(std::move(suite));
  }
}

}  // namespace

SensorFile ReadSensorFile(const std::string& file_name, const std::string& text,
                          const SchemaChecker& checker, std::vector<Violation>* violations) {
  SensorFile file;
  std::vector<Violation> found;
  const std::string origin = file_name + "#";
  Json json;
  if (ParseStrictly(text, origin, JsonLimits(), &json, &found)) {
    checker.Check(json, origin, &found);
    if (json.is_object()) {
      if (json.contains("lidars") && json.at("lidars").is_array()) {
        ReadLidars(json.at("lidars"), origin, &file, &found);
      }
      if (json.contains("suites") && json.at("suites").is_array()) {
        ReadSuites(json.at("suites"), origin, &file, &found);
      }
    }
  }
  violations->insert(violations->end(), found.begin(), found.end());
  return file;
}

}  // namespace latticeworld
