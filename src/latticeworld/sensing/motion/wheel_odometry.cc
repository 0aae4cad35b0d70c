#include "latticeworld/sensing/motion/wheel_odometry.h"

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

// A quarter turn to the left: what a small turn of the heading moves a way by.
Eigen::Vector2d LeftOf(const Eigen::Vector2d& way) { return {-way.y(), way.x()}; }

// Returns the end of an arc that begins at the origin along x [m].
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
  rolled_m_ += 0.5 * (std::abs(left_m) + std::abs(right_m));
  const double turn_rad = wheels.steering_rad
                              ? way_m * std::tan(*wheels.steering_rad) / wheels.wheelbase_m
                              : (right_m - left_m) / wheels.track_m;
  moved_m_ += Eigen::Rotation2Dd(turn_rad_) * ArcEnd(way_m, turn_rad);
  way_m_ += way_m;
  turn_rad_ += turn_rad;
  duration_s_ += step_s;
  last_ = wheels;
}

void WheelOdometer::Spread(const Eigen::Vector2d& moved_m, const Eigen::Vector2d& along) {
  const Eigen::Vector2d aside_m = LeftOf(moved_m);
  // An error of the heading turns the interval's way.
  Eigen::Matrix3d carried = Eigen::Matrix3d::Identity();
  carried.topRightCorner<2, 1>() = aside_m;
  // Errors of the interval's own turn turn half of it.
  const Eigen::Vector3d by_turn(0.5 * aside_m.x(), 0.5 * aside_m.y(), 1.0);
  const Eigen::Vector3d by_way(along.x(), along.y(), 0.0);
  noise_ = carried * noise_ * carried.transpose() + TurnNoise() * by_turn * by_turn.transpose() +
           WayNoise() * by_way * by_way.transpose();
  lasting_ = carried * lasting_;
  lasting_.col(0) += Eigen::Vector3d(moved_m.x(), moved_m.y(), 0.0) + turn_rad_ * by_turn;
  lasting_.col(1) += Eigen::Vector3d(aside_m.x(), aside_m.y(), 0.0);
  if (last_.skids) lasting_.col(2) += std::copysign(rolled_m_, turn_rad_) * by_turn;
}

double WheelOdometer::TickVariance() const {
  if (model_.ticks_per_revolution <= 0.0) return 0.0;
  const double tick_m = last_.wheel_radius_m * 2.0 * M_PI / model_.ticks_per_revolution;
  return tick_m * tick_m / 12.0;  // even within a tick
}

Eigen::Matrix3d WheelOdometer::PoseCovariance() const {
  const Eigen::Vector3d lasting(model_.slip, model_.slip, model_.skid_radpm);
  Eigen::Matrix3d covariance =
      noise_ + lasting_ * lasting.cwiseAbs2().asDiagonal() * lasting_.transpose();
  // The ticks of two wheels, of which the way is the mean and the turn the difference.
  const double ticks_m2 = TickVariance();
  covariance.diagonal() +=
      ticks_m2 * Eigen::Vector3d(0.5, 0.5, 2.0 / (last_.track_m * last_.track_m));
  const Eigen::Vector2d from_axle =
      -last_.axle_m * Eigen::Vector2d(std::cos(heading_rad_), std::sin(heading_rad_));
  Eigen::Matrix3d base = Eigen::Matrix3d::Identity();
  base.topRightCorner<2, 1>() = LeftOf(from_axle);
  return base * covariance * base.transpose();
}

Eigen::Vector3d WheelOdometer::TwistVariances() const {
  // Both ends of the interval are whole ticks.
  const double ticks_m2 = 2.0 * TickVariance();
  const double slip2 = model_.slip * model_.slip;
  const double skid_rad = last_.skids ? model_.skid_radpm * rolled_m_ : 0.0;
  const double way = WayNoise() + 0.5 * ticks_m2 + slip2 * way_m_ * way_m_;
  const double turn = TurnNoise() + 2.0 * ticks_m2 / (last_.track_m * last_.track_m) +
                      slip2 * turn_rad_ * turn_rad_ + skid_rad * skid_rad;
  const double aside = slip2 * way_m_ * way_m_ + last_.axle_m * last_.axle_m * turn;
  return Eigen::Vector3d(way, aside, turn) / (duration_s_ * duration_s_);
}

WheelOdometryReading WheelOdometer::Read(std::uint64_t k) {
  const double turn_error_rad = std::sqrt(TurnNoise()) * NormalAt(key_, 2 * k);
  const double way_error_m = std::sqrt(WayNoise()) * NormalAt(key_, 2 * k + 1);
  // The error of the turn grows evenly along the way: half of it bends the chord.
  const Eigen::Rotation2Dd began(heading_rad_ + 0.5 * turn_error_rad);
  const Eigen::Vector2d along =
      began * Eigen::Vector2d(std::cos(0.5 * turn_rad_), std::sin(0.5 * turn_rad_));
  const Eigen::Vector2d moved_m = began * moved_m_ + way_error_m * along;
  Spread(moved_m, along);
  position_m_ += moved_m;
  heading_rad_ = std::remainder(heading_rad_ + turn_rad_ + turn_error_rad, 2.0 * M_PI);

  WheelOdometryReading reading;
  reading.position_m = position_m_ + last_.axle_m * Eigen::Vector2d(1.0 - std::cos(heading_rad_),
                                                                    -std::sin(heading_rad_));
  reading.heading_rad = heading_rad_;
  reading.pose_covariance = PoseCovariance();
  if (duration_s_ > 0.0) {
    reading.forward_mps = (way_m_ + way_error_m) / duration_s_;
    reading.yaw_rate_radps = (turn_rad_ + turn_error_rad) / duration_s_;
    reading.sideways_mps = -last_.axle_m * reading.yaw_rate_radps;
    reading.twist_variances = TwistVariances();
  }
  duration_s_ = way_m_ = turn_rad_ = rolled_m_ = 0.0;
  moved_m_.setZero();
  return reading;
}

}  // namespace latticeworld
