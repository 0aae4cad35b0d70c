#include "latticeworld/sensing/motion/imu.h"

#include <cmath>

#include "latticeworld/sensing/counter_noise.h"

namespace latticeworld {
namespace {

Eigen::Vector3d Cut(const Eigen::Vector3d& value, double limit) {
  return value.cwiseMax(-limit).cwiseMin(limit);
}

}  // namespace

PointMotion MotionOf(const Eigen::Isometry3d& map_from_base,
                     const Eigen::Vector3d& linear_velocity_mps,
                     const Eigen::Vector3d& angular_velocity_radps,
                     const Eigen::Isometry3d& base_from_sensor) {
  const Eigen::Vector3d arm_mps = angular_velocity_radps.cross(base_from_sensor.translation());
  return {map_from_base * base_from_sensor, linear_velocity_mps + map_from_base.linear() * arm_mps};
}

void InertialIntegral::Add(const PointMotion& before, const PointMotion& now, double duration_s,
                           double gravity_mps2) {
  const Eigen::Quaterniond from(before.map_from_sensor.linear());
  const Eigen::Quaterniond to(now.map_from_sensor.linear());
  const Eigen::AngleAxisd turn(from.conjugate() * to);
  const double angle_rad = std::remainder(turn.angle(), 2.0 * M_PI);
  angle_rad_ += angle_rad * turn.axis();
  // The sensor's frame half way through the turn: exact for an even turn up to its third power.
  const Eigen::Quaterniond middle = from * Eigen::AngleAxisd(0.5 * angle_rad, turn.axis());
  const Eigen::Vector3d gravity(0.0, 0.0, -gravity_mps2);
  velocity_mps_ +=
      middle.conjugate() * (now.velocity_mps - before.velocity_mps - duration_s * gravity);
  duration_s_ += duration_s;
}

ImuErrors::Axes::Axes(const InertialNoise& noise, double rate_hz, std::uint64_t key)
    : white_key(KeyOf(key, 0)),
      white(noise.density * std::sqrt(rate_hz)),
      turn_on(noise.bias * NormalsAt(KeyOf(key, 1), 0)),
      wandering(KeyOf(key, 2), Eigen::Vector3d::Constant(noise.bias_instability), 1.0 / rate_hz,
                noise.bias_time_s) {}

Eigen::Vector3d ImuErrors::Axes::At(std::uint64_t k) {
  return turn_on + wandering.At(k) + white * NormalsAt(white_key, k);
}

ImuErrors::ImuErrors(const ImuModel& model, double rate_hz, std::uint64_t key)
    : model_(model),
      gyroscope_(model.gyroscope, rate_hz, KeyOf(key, 0)),
      accelerometer_(model.accelerometer, rate_hz, KeyOf(key, 1)) {}

ImuReading ImuErrors::Read(const InertialIntegral& integral, std::uint64_t k) {
  ImuReading reading;
  reading.angular_velocity_radps =
      Cut(integral.MeanRate() + gyroscope_.At(k), model_.max_rate_radps);
  reading.acceleration_mps2 =
      Cut(integral.MeanSpecificForce() + accelerometer_.At(k), model_.max_acceleration_mps2);
  return reading;
}

}  // namespace latticeworld
