#include "latticeworld_ros/viewer/viewer_conversion.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostRows = 65535;
constexpr std::size_t kMostCloudPoints = 16384;
constexpr std::size_t kMostPathPoints = 500;
constexpr char kFallingNamespace[] = "trees";
constexpr char kSimulationStatus[] = "world_server: simulation";

Eigen::Vector3d FromPoint(const geometry_msgs::Point& point) { return {point.x, point.y, point.z}; }

Eigen::Quaterniond FromQuaternion(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

StreamedThing ThingAt(const geometry_msgs::Pose& pose) {
  return StreamedPose(FromPoint(pose.position), FromQuaternion(pose.orientation));
}

double ValueOf(const diagnostic_msgs::DiagnosticStatus& status, std::string_view key_begin) {
  for (const diagnostic_msgs::KeyValue& entry : status.values) {
    if (!StartsWith(entry.key, key_begin)) continue;
    const double value = std::strtod(entry.value.c_str(), nullptr);
    return std::isfinite(value) ? value : 0.0;
  }
  return 0.0;
}

// Returns where a float32 field stands in a point [bytes]; nullopt: there is none.
std::optional<std::size_t> OffsetOf(const sensor_msgs::PointCloud2& cloud, const char* name) {
  for (const sensor_msgs::PointField& field : cloud.fields) {
    if (field.name != name || field.datatype != sensor_msgs::PointField::FLOAT32) continue;
    if (field.offset + sizeof(float) <= cloud.point_step) return field.offset;
  }
  return std::nullopt;
}

float FloatAt(const std::vector<std::uint8_t>& data, std::size_t offset) {
  float value;
  std::memcpy(&value, data.data() + offset, sizeof(value));
  return value;
}

std::uint8_t IntensityByte(float intensity) {
  return std::isfinite(intensity)
             ? static_cast<std::uint8_t>(std::clamp(intensity, 0.0f, 1.0f) * 255.0f)
             : 0;
}

}  // namespace

StreamedState<AgentRow> Streamed(const latticeworld_msgs::AgentStates& message) {
  StreamedState<AgentRow> state;
  const std::size_t count = std::min(message.agents.size(), kMostRows);
  state.rows.reserve(count);
  state.things.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const latticeworld_msgs::AgentState& agent = message.agents[i];
    state.rows.push_back(
        {agent.name, agent.species, agent.policy, agent.team, agent.controllable != 0});
    StreamedThing thing = ThingAt(agent.pose);
    thing.behaviour =
        static_cast<std::uint8_t>(FromName<Behaviour>(agent.behaviour).value_or(Behaviour::kIdle));
    thing.health = HealthByte(agent.health);
    state.things.push_back(thing);
  }
  return state;
}

StreamedState<PropRow> Streamed(const latticeworld_msgs::ElementStates& message) {
  StreamedState<PropRow> state;
  const std::size_t count = std::min(message.elements.size(), kMostRows);
  for (std::size_t i = 0; i < count; ++i) {
    const latticeworld_msgs::ElementState& prop = message.elements[i];
    state.rows.push_back({prop.name, prop.kind, FromVector(prop.size)});
    StreamedThing thing = ThingAt(prop.pose);
    thing.behaviour = prop.broken ? 1 : 0;
    thing.health = OpeningByte(prop.opening);
    state.things.push_back(thing);
  }
  return state;
}

Atmosphere ToAtmosphere(const latticeworld_msgs::Weather& message) {
  Atmosphere atmosphere;
  atmosphere.weather = FromName<Weather>(message.weather).value_or(Weather::kSunny);
  atmosphere.intensity = message.intensity;
  atmosphere.visibility_m = message.visibility;
  atmosphere.rain_mmph = message.rain;
  atmosphere.snowfall_mmph = message.snowfall;
  atmosphere.cloud_cover = message.cloud_cover;
  atmosphere.wind_mps = FromVector(message.wind);
  atmosphere.gust_mps = message.gust;
  atmosphere.hour = message.hour;
  atmosphere.sun_direction = FromVector(message.sun_direction);
  atmosphere.sun_intensity = message.sun_intensity;
  atmosphere.ambient_intensity = message.ambient_intensity;
  atmosphere.ground_wetness = message.ground_wetness;
  atmosphere.snow_depth_m = message.snow_depth;
  atmosphere.blown_sand = message.blown_sand;
  atmosphere.water_rise_m = message.water_rise;
  return atmosphere;
}

std::vector<LyingTree> FelledOf(const latticeworld_msgs::SceneChanges& message) {
  std::vector<LyingTree> trees;
  for (const latticeworld_msgs::FelledTree& felled : message.felled) {
    trees.push_back(
        {felled.asset, FromPoint(felled.foot), FromPoint(felled.tip), felled.at_rest != 0});
  }
  return trees;
}

void UpdateFalling(const visualization_msgs::MarkerArray& markers, std::vector<LyingTree>* trees) {
  for (const visualization_msgs::Marker& marker : markers.markers) {
    // Stems have even numbers, twice the asset's; crowns the ones after.
    if (marker.ns != kFallingNamespace || marker.id < 0 || marker.id % 2 != 0) continue;
    const auto tree = std::find_if(trees->begin(), trees->end(), [&marker](const LyingTree& entry) {
      return !entry.at_rest && entry.asset == static_cast<std::uint32_t>(marker.id / 2);
    });
    if (tree == trees->end()) continue;
    const Eigen::Vector3d middle_m = FromPoint(marker.pose.position);
    const Eigen::Vector3d half_m =
        FromQuaternion(marker.pose.orientation) * Eigen::Vector3d(0.0, 0.0, 0.5 * marker.scale.z);
    if (!middle_m.allFinite() || !half_m.allFinite()) continue;
    tree->foot_m = middle_m - half_m;
    tree->tip_m = middle_m + half_m;
  }
}

std::optional<SimulationReport> ReportOf(const diagnostic_msgs::DiagnosticArray& message) {
  for (const diagnostic_msgs::DiagnosticStatus& status : message.status) {
    if (status.name != kSimulationStatus) continue;
    SimulationReport report;
    report.has_world = status.level == diagnostic_msgs::DiagnosticStatus::OK;
    report.paused = status.message == "paused";
    report.real_time_factor = ValueOf(status, "real-time factor");
    report.speed = ValueOf(status, "wanted real-time factor");
    // A simulation that failed still has its world, which stands.
    report.has_world = report.has_world || status.level == diagnostic_msgs::DiagnosticStatus::ERROR;
    return report;
  }
  return std::nullopt;
}

Eigen::Isometry3d PoseFrom(const geometry_msgs::Pose& pose) {
  return ToIsometry(FromPoint(pose.position), FromQuaternion(pose.orientation));
}

Eigen::Isometry3d TransformFrom(const geometry_msgs::Transform& transform) {
  return ToIsometry(FromVector(transform.translation), FromQuaternion(transform.rotation));
}

std::vector<ViewerPoint> PointsOf(const sensor_msgs::PointCloud2& cloud,
                                  const Eigen::Matrix3d& map_from_sensor) {
  std::vector<ViewerPoint> points;
  const auto x = OffsetOf(cloud, "x"), y = OffsetOf(cloud, "y"), z = OffsetOf(cloud, "z");
  const auto intensity = OffsetOf(cloud, "intensity");
  if (!x || !y || !z || cloud.is_bigendian != 0 || cloud.point_step == 0) return points;
  const std::size_t count =
      std::min(static_cast<std::size_t>(cloud.width) * std::max(1u, cloud.height),
               cloud.data.size() / cloud.point_step);
  const std::size_t stride = std::max<std::size_t>(1, count / kMostCloudPoints);
  const Eigen::Matrix3f turn = map_from_sensor.cast<float>();
  for (std::size_t i = 0; i < count; i += stride) {
    const std::size_t at = i * cloud.point_step;
    const Eigen::Vector3f point(FloatAt(cloud.data, at + *x), FloatAt(cloud.data, at + *y),
                                FloatAt(cloud.data, at + *z));
    if (!point.allFinite()) continue;
    points.push_back({turn * point, intensity ? IntensityByte(FloatAt(cloud.data, at + *intensity))
                                              : std::uint8_t{255}});
  }
  return points;
}

std::vector<ViewerPoint> PointsOf(const sensor_msgs::LaserScan& scan,
                                  const Eigen::Matrix3d& map_from_sensor) {
  std::vector<ViewerPoint> points;
  const std::size_t stride = std::max<std::size_t>(1, scan.ranges.size() / kMostCloudPoints);
  const Eigen::Matrix3f turn = map_from_sensor.cast<float>();
  for (std::size_t i = 0; i < scan.ranges.size(); i += stride) {
    const float range_m = scan.ranges[i];
    if (!(range_m >= scan.range_min && range_m <= scan.range_max)) continue;
    const float angle_rad = scan.angle_min + static_cast<float>(i) * scan.angle_increment;
    const Eigen::Vector3f point(range_m * std::cos(angle_rad), range_m * std::sin(angle_rad), 0.0f);
    if (!point.allFinite()) continue;
    points.push_back({turn * point, i < scan.intensities.size() ? IntensityByte(scan.intensities[i])
                                                                : std::uint8_t{255}});
  }
  return points;
}

std::vector<Eigen::Vector3d> PointsOf(const nav_msgs::Path& path) {
  std::vector<Eigen::Vector3d> points;
  const std::size_t count = path.poses.size();
  const std::size_t stride =
      std::max<std::size_t>(1, (count + kMostPathPoints - 2) / (kMostPathPoints - 1));
  for (std::size_t i = 0; i < count; i += stride) {
    const bool is_last = i + stride >= count;
    const Eigen::Vector3d point = FromPoint(path.poses[is_last ? count - 1 : i].pose.position);
    if (point.allFinite()) points.push_back(point);
  }
  return points;
}

}  // namespace latticeworld
