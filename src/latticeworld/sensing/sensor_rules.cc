#include "latticeworld/sensing/sensor_rules.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

// Topics and frames that every robot has below its name.
constexpr const char* kTakenNames[] = {"base_link",    "cmd_vel",       "ground_truth",
                                       "joint_states", "joint_command", "odom"};

// Points tell nanoseconds after a revolution's begin in 32 bits.
constexpr double kSlowestLidar_hz = 0.25;

void Add(const char* code, std::string pointer, std::string message, std::string given,
         std::vector<Violation>* violations) {
  violations->push_back({code, std::move(pointer), std::move(message), std::move(given)});
}

// Whether every pixel of the picture's edge, and so every pixel, has a direction of its own.
bool CoversPicture(const CameraModel& model) {
  constexpr int kPlaces = 64;  // along an edge
  for (int i = 0; i <= kPlaces; ++i) {
    const double u = -0.5 + static_cast<double>(model.width) * i / kPlaces;
    const double v = -0.5 + static_cast<double>(model.height) * i / kPlaces;
    const Eigen::Vector2d places[] = {
        {u, -0.5}, {u, model.height - 0.5}, {-0.5, v}, {model.width - 0.5, v}};
    for (const Eigen::Vector2d& place : places) {
      const Eigen::Vector2d distorted((place.x() - model.cx_px) / model.fx_px,
                                      (place.y() - model.cy_px) / model.fy_px);
      if (!Undistort(model, distorted)) return false;
    }
  }
  return true;
}

}  // namespace

void CheckLidar(const LidarModel& model, const std::string& pointer,
                std::vector<Violation>* violations) {
  const std::vector<double>& rings = model.ring_elevations_rad;
  for (std::size_t i = 1; i < rings.size(); ++i) {
    if (rings[i] >= rings[i - 1]) continue;
    Add("out_of_range", pointer,
        "rings must be in order, the lowest first; ring " + std::to_string(i) +
            " lies below the one before it",
        FormatDouble(rings[i] * 180.0 / M_PI), violations);
    break;
  }
  if (model.min_range_m >= model.max_range_m) {
    Add("out_of_range", pointer + "/min_range_m",
        "must be below max_range_m, " + FormatDouble(model.max_range_m),
        FormatDouble(model.min_range_m), violations);
  }
  const double beams = static_cast<double>(rings.size()) * model.columns;
  if (beams > kMaxBeams) {
    Add("out_of_range", pointer + "/columns",
        "times " + std::to_string(rings.size()) + " rings must be at most " +
            std::to_string(kMaxBeams) + " beams",
        std::to_string(model.columns), violations);
  }
}

void CheckCamera(const CameraModel& model, const std::string& pointer,
                 std::vector<Violation>* violations) {
  if (model.near_m >= model.far_m) {
    Add("out_of_range", pointer + "/near_m", "must be below far_m, " + FormatDouble(model.far_m),
        FormatDouble(model.near_m), violations);
  }
  if (!CoversPicture(model)) {
    Add("out_of_range", pointer + "/distortion",
        "folds the picture: past the radius " + FormatDouble(MonotonousRadius(model)) +
            " on the plane z = 1 it is not monotonous, and the picture reaches further",
        FormatDouble(model.distortion[0]), violations);
  }
}

void CheckSensorName(const std::string& name, const std::string& pointer,
                     std::vector<Violation>* violations) {
  if (std::find(std::begin(kTakenNames), std::end(kTakenNames), name) == std::end(kTakenNames)) {
    return;
  }
  Add("unknown_value", pointer + "/name",
      "is the name of another topic or frame of every robot; those are " +
          Join({std::begin(kTakenNames), std::end(kTakenNames)}, ", "),
      Quote(name), violations);
}

void CheckLidarSensor(const SensorSpec& spec, const std::string& pointer,
                      std::vector<Violation>* violations) {
  const LidarModel& model = std::get<LidarModel>(spec.model);
  const auto rings = static_cast<double>(model.ring_elevations_rad.size());
  if (rings * model.columns > kMaxBeams) {
    Add("out_of_range", pointer + "/lidar/columns",
        "times the " + FormatDouble(rings) + " rings of " + Quote(model.name) +
            " must be at most " + std::to_string(kMaxBeams) + " beams",
        std::to_string(model.columns), violations);
  }
  if (spec.rate_hz < kSlowestLidar_hz) {
    Add("out_of_range", pointer + "/rate_hz",
        "of a lidar must be at least " + FormatDouble(kSlowestLidar_hz), FormatDouble(spec.rate_hz),
        violations);
  }
  if (model.ring_delay_s * (rings - 1.0) * spec.rate_hz >= 1.0) {
    Add("out_of_range", pointer + "/rate_hz",
        "the beams of one column of " + Quote(model.name) + " take longer than a revolution",
        FormatDouble(spec.rate_hz), violations);
  }
}

}  // namespace latticeworld
