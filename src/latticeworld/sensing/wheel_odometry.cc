#include "latticeworld/sensing/wheel_odometry.h"

#include <Eigen/Geometry>
#include <cmath>

#include "latticeworld/sensing/counter_noise.h"

namespace latticeworld {
namespace {

// How far a wheel turned between two readings of an angle that wraps: the turn that comes nearest
// to what its rate says.
double TurnOf(double before_rad, double now_rad, double rate_radps, double step_s) {
  const double expected_rad = rate_radps * step_s;
  return expected_rad + std::remainder(now_rad - before_rad - expected_rad, 2.0 * M_PI);
}

// Along an arc that begins at the origin along x.
Eigen::Vector2d ArcEnd(double way_m, double turn_rad) {
  const double half = 0.5 * turn_rad;
  const double chord_m = std::abs(half) < 1e-6 ? way_m : way_m * std::sin(half) / half;
  return {chord_m * std::cos(half), chord_m * std::sin(half)};
}

}  // namespace

void WheelOdometer::Begin(const SensedWheels& wheels) {
  last_ = wheels;
  left_rad_ = right_rad_ = 0.0;
}

double WheelOdometer::Counted(double angle_rad) const {
  if (model_.ticks_per_revolution <= 0.0) return angle_rad;
  const double tick_rad = 2.0 * M_PI / model_.ticks_per_revolution;
  return std::floor(angle_rad / tick_rad) * tick_rad;
}

void WheelOdometer::Add(const SensedWheels& wheels, double step_s) {
  const double left_before_rad = Counted(left_rad_), right_before_rad = Counted(right_rad_);
  left_rad_ += TurnOf(last_.left_rad, wheels.left_rad, wheels.left_radps, step_s);
  right_rad_ += TurnOf(last_.right_rad, wheels.right_rad, wheels.right_radps, step_s);
  const double left_m = wheels.wheel_radius_m * (Counted(left_rad_) - left_before_rad);
  const double right_m = wheels.wheel_radius_m * (Counted(right_rad_) - right_before_rad);
  const double way_m = 0.5 * (left_m + right_m);
  const double turn_rad = wheels.steering_rad
                              ? way_m * std::tan(*wheels.steering_rad) / wheels.wheelbase_m
                              : (right_m - left_m) / wheels.track_m;
  moved_m_ += Eigen::Rotation2Dd(turn_rad_) * ArcEnd(way_m, turn_rad);
  way_m_ += way_m;
  turn_rad_ += turn_rad;
  duration_s_ += step_s;
  last_ = wheels;
}

WheelOdometryReading WheelOdometer::Read(std::uint64_t k) {
  const double turn2 = turn_rad_ * turn_rad_, way2 = way_m_ * way_m_;
  const double turn_error_rad =
      std::sqrt(model_.a1 * turn2 + model_.a2 * way2) * NormalAt(key_, 2 * k);
  const double way_error_m =
      std::sqrt(model_.a3 * way2 + model_.a4 * turn2) * NormalAt(key_, 2 * k + 1);
  // The error of the turn grows evenly along the way: half of it bends the chord.
  const Eigen::Vector2d along(std::cos(0.5 * turn_rad_), std::sin(0.5 * turn_rad_));
  position_m_ +=
      Eigen::Rotation2Dd(heading_rad_ + 0.5 * turn_error_rad) * (moved_m_ + way_error_m * along);
  heading_rad_ = std::remainder(heading_rad_ + turn_rad_ + turn_error_rad, 2.0 * M_PI);

  WheelOdometryReading reading;
  reading.position_m = position_m_;
  reading.heading_rad = heading_rad_;
  if (duration_s_ > 0.0) {
    reading.forward_mps = (way_m_ + way_error_m) / duration_s_;
    reading.yaw_rate_radps = (turn_rad_ + turn_error_rad) / duration_s_;
  }
  duration_s_ = way_m_ = turn_rad_ = 0.0;
  moved_m_.setZero();
  return reading;
}

}  // namespace latticeworld
