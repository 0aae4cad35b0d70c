#ifndef LATTICEWORLD_SENSING_WHEEL_ODOMETRY_H_
#define LATTICEWORLD_SENSING_WHEEL_ODOMETRY_H_

#include <Eigen/Core>
#include <cstdint>

#include "latticeworld/sensing/motion_sensors.h"
#include "latticeworld/sensing/sensed_world.h"

namespace latticeworld {

// Dead reckoning from encoders: ways of the left and the right wheels, and, where wheels are
// steered, the angle of the steering (a bicycle); else their difference over the track. Each step
// is an arc. Wheels that slip take the reckoning with them. Noise is drawn once a reading, of the
// turn and the way since the one before.
class WheelOdometer {
 public:
  WheelOdometer(const WheelOdometryModel& model, std::uint64_t key) : model_(model), key_(key) {}

  // Where the counting of the wheels begins; what was reckoned before stays.
  void Begin(const SensedWheels& wheels);
  // Wheels step_s after those of Begin or the last Add.
  void Add(const SensedWheels& wheels, double step_s);
  // Ends an interval; k: the reading's number; time_s is left as it is. Called for every reading
  // that is due, listened to or not.
  WheelOdometryReading Read(std::uint64_t k);

 private:
  // Of the wheels' angle since the beginning, as the encoder tells it.
  double Counted(double angle_rad) const;

  WheelOdometryModel model_;
  std::uint64_t key_;
  SensedWheels last_;
  double left_rad_ = 0.0, right_rad_ = 0.0;  // since Begin
  // Since the reading before.
  double duration_s_ = 0.0, way_m_ = 0.0, turn_rad_ = 0.0;
  Eigen::Vector2d moved_m_ = Eigen::Vector2d::Zero();  // in the frame of the reading before
  // At the reading before, noise included.
  Eigen::Vector2d position_m_ = Eigen::Vector2d::Zero();
  double heading_rad_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_WHEEL_ODOMETRY_H_
