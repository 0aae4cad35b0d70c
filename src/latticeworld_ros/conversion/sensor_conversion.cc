#include "latticeworld_ros/conversion/sensor_conversion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

// The variance of what comes exact from the simulation: zeros in a covariance would mean "unknown".
constexpr double kExact = 1e-9;
// The variance of a pose before anything has made it uncertain: that of exact odometry.
constexpr double kExactPose = 1e-6;
// The variance of what wheels know nothing of: rising, rolling, pitching.
constexpr double kUnmeasured = 1e6;

std_msgs::Header HeaderOf(const std::string& frame_id, ros::Time stamp) {
  std_msgs::Header header;
  header.frame_id = frame_id;
  header.stamp = stamp;
  return header;
}

// Variances on the diagonal of a row-major 3 x 3 matrix.
template <typename Matrix>
void SetDiagonal(const Eigen::Vector3d& variances, Matrix* matrix) {
  for (int i = 0; i < 3; ++i) (*matrix)[static_cast<std::size_t>(4 * i)] = variances[i];
}

// Returns the variance of one reading of an inertial sensor's white noise.
double VarianceOf(const InertialNoise& noise, double rate_hz) {
  return std::max(kExact, noise.density * noise.density * rate_hz);
}

constexpr std::uint32_t kPointBytes = 22;

template <typename T>
void Put(T value, std::uint8_t* at) {
  std::memcpy(at, &value, sizeof(value));
}

sensor_msgs::PointField FieldAt(const char* name, std::uint32_t offset, std::uint8_t type) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = type;
  field.count = 1;
  return field;
}

}  // namespace

ros::Duration DurationOf(double seconds) {
  return ros::Duration().fromNSec(std::llround(seconds * 1e9));
}

std::string SensorFrameId(const std::string& robot, const SensorSpec& sensor) {
  return robot + "/" + sensor.name;
}

std::string OpticalFrameId(const std::string& robot, const SensorSpec& sensor) {
  return SensorFrameId(robot, sensor) + "_optical";
}

sensor_msgs::LaserScan ToLaserScan(const LidarSweep& sweep, const LidarModel& model, double rate_hz,
                                   const std::string& frame_id, ros::Time end) {
  sensor_msgs::LaserScan scan;
  scan.header = HeaderOf(frame_id, end - DurationOf(sweep.end_s - sweep.begin_s));
  const double step_rad = model.field_of_view_rad / sweep.columns;
  scan.angle_min = static_cast<float>(model.first_azimuth_rad);
  scan.angle_increment = static_cast<float>(step_rad);
  scan.angle_max = static_cast<float>(model.first_azimuth_rad + step_rad * (sweep.columns - 1));
  scan.scan_time = static_cast<float>(1.0 / rate_hz);
  scan.time_increment = static_cast<float>(step_rad / (2.0 * M_PI * rate_hz));
  scan.range_min = static_cast<float>(model.min_range_m);
  scan.range_max = static_cast<float>(model.max_range_m);
  scan.ranges = sweep.ranges_m;
  scan.intensities = sweep.intensities;
  return scan;
}

sensor_msgs::PointCloud2 ToPointCloud2(const LidarSweep& sweep, const std::string& frame_id,
                                       ros::Time end, PointTimes times) {
  using sensor_msgs::PointField;
  const double revolution_s = sweep.end_s - sweep.begin_s;
  const bool from_begin = times == PointTimes::kBegin;
  const double stamp_s = from_begin ? 0.0 : revolution_s;  // after the revolution's begin
  sensor_msgs::PointCloud2 cloud;
  cloud.header = HeaderOf(frame_id, from_begin ? end - DurationOf(revolution_s) : end);
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(sweep.points.size());
  cloud.fields = {
      FieldAt("x", 0, PointField::FLOAT32),    FieldAt("y", 4, PointField::FLOAT32),
      FieldAt("z", 8, PointField::FLOAT32),    FieldAt("intensity", 12, PointField::FLOAT32),
      FieldAt("ring", 16, PointField::UINT16), FieldAt("time", 18, PointField::FLOAT32)};
  cloud.is_bigendian = false;
  cloud.point_step = kPointBytes;
  cloud.row_step = kPointBytes * cloud.width;
  cloud.is_dense = true;
  cloud.data.resize(cloud.row_step);
  std::uint8_t* at = cloud.data.data();
  for (const LidarPoint& point : sweep.points) {
    Put(point.x_m, at);
    Put(point.y_m, at + 4);
    Put(point.z_m, at + 8);
    Put(point.intensity, at + 12);
    Put(point.ring, at + 16);
    Put(static_cast<float>(point.time_ns * 1e-9 - stamp_s), at + 18);
    at += kPointBytes;
  }
  return cloud;
}

sensor_msgs::Imu ToImu(const ImuReading& reading, const ImuModel& model, double rate_hz,
                       const std::string& frame_id, ros::Time stamp) {
  sensor_msgs::Imu imu;
  imu.header = HeaderOf(frame_id, stamp);
  if (model.gives_orientation) {
    imu.orientation = ToQuaternion(reading.map_from_sensor);
    SetDiagonal(Eigen::Vector3d::Constant(kExact), &imu.orientation_covariance);
  } else {
    imu.orientation.w = 1.0;
    imu.orientation_covariance[0] = -1.0;
  }
  imu.angular_velocity = ToVector3(reading.angular_velocity_radps);
  SetDiagonal(Eigen::Vector3d::Constant(VarianceOf(model.gyroscope, rate_hz)),
              &imu.angular_velocity_covariance);
  imu.linear_acceleration = ToVector3(reading.acceleration_mps2);
  SetDiagonal(Eigen::Vector3d::Constant(VarianceOf(model.accelerometer, rate_hz)),
              &imu.linear_acceleration_covariance);
  return imu;
}

sensor_msgs::NavSatFix ToNavSatFix(const GnssReading& reading, const std::string& frame_id,
                                   ros::Time stamp) {
  sensor_msgs::NavSatFix fix;
  fix.header = HeaderOf(frame_id, stamp);
  fix.status.status = sensor_msgs::NavSatStatus::STATUS_FIX;
  fix.status.service = sensor_msgs::NavSatStatus::SERVICE_GPS;
  fix.latitude = reading.latitude_deg;
  fix.longitude = reading.longitude_deg;
  fix.altitude = reading.altitude_m;
  SetDiagonal(reading.stddev_m.cwiseAbs2().cwiseMax(kExact), &fix.position_covariance);
  fix.position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_DIAGONAL_KNOWN;
  return fix;
}

sensor_msgs::MagneticField ToMagneticField(const MagnetometerReading& reading,
                                           const MagnetometerModel& model,
                                           const std::string& frame_id, ros::Time stamp) {
  sensor_msgs::MagneticField field;
  field.header = HeaderOf(frame_id, stamp);
  field.magnetic_field = ToVector3(reading.field_t);
  SetDiagonal(Eigen::Vector3d::Constant(model.noise_t * model.noise_t),
              &field.magnetic_field_covariance);
  return field;
}

nav_msgs::Odometry ToOdometry(const WheelOdometryReading& reading, const std::string& frame_id,
                              const std::string& child_frame_id, ros::Time stamp) {
  nav_msgs::Odometry odometry;
  odometry.header = HeaderOf(frame_id, stamp);
  odometry.child_frame_id = child_frame_id;
  odometry.pose.pose.position.x = reading.position_m.x();
  odometry.pose.pose.position.y = reading.position_m.y();
  odometry.pose.pose.orientation.z = std::sin(0.5 * reading.heading_rad);
  odometry.pose.pose.orientation.w = std::cos(0.5 * reading.heading_rad);
  odometry.twist.twist.linear.x = reading.forward_mps;
  odometry.twist.twist.linear.y = reading.sideways_mps;
  odometry.twist.twist.angular.z = reading.yaw_rate_radps;
  constexpr std::array<std::size_t, 3> kPlanar = {0, 1, 5};  // x, y, yaw of six
  constexpr std::array<std::size_t, 3> kOutOfPlane = {2, 3, 4};
  for (const std::size_t i : kOutOfPlane) {
    odometry.pose.covariance[7 * i] = odometry.twist.covariance[7 * i] = kUnmeasured;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 3; ++j) {
      odometry.pose.covariance[6 * kPlanar[i] + kPlanar[j]] =
          reading.pose_covariance(row, static_cast<Eigen::Index>(j)) + (i == j ? kExactPose : 0.0);
    }
    odometry.twist.covariance[7 * kPlanar[i]] = reading.twist_variances[row] + kExact;
  }
  return odometry;
}

latticeworld_msgs::Bumper ToBumper(const BumperReading& reading, const std::string& frame_id,
                                   ros::Time stamp) {
  latticeworld_msgs::Bumper bumper;
  bumper.header = HeaderOf(frame_id, stamp);
  bumper.pressed = reading.pressed;
  bumper.force = reading.force_n;
  bumper.bearing = reading.bearing_rad;
  return bumper;
}

}  // namespace latticeworld
