#ifndef LATTICEWORLD_SENSING_MOTION_WHEEL_ODOMETRY_H_
#define LATTICEWORLD_SENSING_MOTION_WHEEL_ODOMETRY_H_

#include <Eigen/Core>
#include <cstdint>

#include "latticeworld/sensing/motion/motion_sensors.h"
#include "latticeworld/sensing/sensed_world.h"

namespace latticeworld {

// Dead reckoning from encoders: ways of the left and the right wheels, and, where wheels are
// steered, the angle of the steering (a bicycle); else their difference over the track. Each step
// is an arc. Wheels that slip take the reckoning with them. Noise is drawn once a reading, of the
// turn and the way since the one before. The axle is reckoned, base_link is told.
//
// Covariances: that of the noise adds up from reading to reading; what lasts (the model's slip,
// along and across, and skid) is one unknown each for the whole drive, so that its share of the
// error grows with the way itself; the encoders' ticks do not add up at all.
class WheelOdometer {
 public:
  WheelOdometer(const WheelOdometryModel& model, std::uint64_t key) : model_(model), key_(key) {}

  // Starts counting the wheels from these angles; what was reckoned before stays.
  void Begin(const SensedWheels& wheels);
  // Wheels step_s after those of Begin or the last Add.
  void Add(const SensedWheels& wheels, double step_s);
  // Ends an interval; k: the reading's number; time_s is left as it is. Called for every reading
  // that is due, listened to or not.
  WheelOdometryReading Read(std::uint64_t k);

 private:
  // Returns as much of a wheel's angle since the beginning as the encoder tells.
  double Counted(double angle_rad) const;
  double TickVariance() const;  // of a wheel's count [m^2]
  // Variances of a turn and a way by the model's noise.
  double TurnNoise() const {
    return model_.a1 * turn_rad_ * turn_rad_ + model_.a2 * way_m_ * way_m_;
  }
  double WayNoise() const {
    return model_.a3 * way_m_ * way_m_ + model_.a4 * turn_rad_ * turn_rad_;
  }
  // Takes the covariances on by an interval in which the axle went `moved_m`, in the frame where it
  // began, and its way pointed `along`.
  void Spread(const Eigen::Vector2d& moved_m, const Eigen::Vector2d& along);
  Eigen::Matrix3d PoseCovariance() const;  // of base_link
  Eigen::Vector3d TwistVariances() const;  // of the interval

  WheelOdometryModel model_;
  std::uint64_t key_;
  SensedWheels last_;
  double left_rad_ = 0.0, right_rad_ = 0.0;  // since Begin
  // These are sums since the reading before.
  double duration_s_ = 0.0, way_m_ = 0.0, turn_rad_ = 0.0;
  double rolled_m_ = 0.0;                              // by a wheel, to and fro alike, on average
  Eigen::Vector2d moved_m_ = Eigen::Vector2d::Zero();  // in the frame of the reading before
  // The axle's pose at the reading before, noise included, from where it began.
  Eigen::Vector2d position_m_ = Eigen::Vector2d::Zero();
  double heading_rad_ = 0.0;
  Eigen::Matrix3d noise_ = Eigen::Matrix3d::Zero();  // covariance of x, y, heading by noise alone
  // What x, y and heading err by for a unit of slip along, slip across and skid (columns).
  Eigen::Matrix3d lasting_ = Eigen::Matrix3d::Zero();
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_WHEEL_ODOMETRY_H_
