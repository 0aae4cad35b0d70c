#ifndef LATTICEWORLD_SENSING_MOTION_IMU_H_
#define LATTICEWORLD_SENSING_MOTION_IMU_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

#include "latticeworld/sensing/motion/motion_sensors.h"
#include "latticeworld/sensing/motion/wandering_bias.h"

namespace latticeworld {

// How a point of a body moves at one moment.
struct PointMotion {
  Eigen::Isometry3d map_from_sensor = Eigen::Isometry3d::Identity();
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  // of the sensor's origin, in map
};
// Returns the motion of a sensor at base_from_sensor on a body: v + omega x r. linear_velocity_mps:
// of base_link, in map; angular_velocity_radps: in base_link.
PointMotion MotionOf(const Eigen::Isometry3d& map_from_base,
                     const Eigen::Vector3d& linear_velocity_mps,
                     const Eigen::Vector3d& angular_velocity_radps,
                     const Eigen::Isometry3d& base_from_sensor);

// What an ideal strapdown sensor integrates (Titterton and Weston 2004, chapter 11): angles turned
// and specific force summed in its own turning frame, from changes of velocity and orientation.
class InertialIntegral {
 public:
  // Adds the motion from `before` to `now`, duration_s > 0 later. gravity_mps2: along -z of map.
  void Add(const PointMotion& before, const PointMotion& now, double duration_s,
           double gravity_mps2);
  void Clear() { *this = InertialIntegral(); }

  double duration_s() const { return duration_s_; }
  // Means over the duration, in the sensor frame; duration_s() > 0.
  Eigen::Vector3d MeanRate() const { return angle_rad_ / duration_s_; }
  Eigen::Vector3d MeanSpecificForce() const { return velocity_mps_ / duration_s_; }

 private:
  double duration_s_ = 0.0;
  Eigen::Vector3d angle_rad_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_mps_ = Eigen::Vector3d::Zero();
};

// Noise and biases of an IMU; k: the reading's number.
class ImuErrors {
 public:
  ImuErrors(const ImuModel& model, double rate_hz, std::uint64_t key);

  // Returns the means over a whole interval, with errors, cut at the model's limits.
  ImuReading Read(const InertialIntegral& integral, std::uint64_t k);

 private:
  struct Axes {
    Axes(const InertialNoise& noise, double rate_hz, std::uint64_t key);
    Eigen::Vector3d At(std::uint64_t k);

    std::uint64_t white_key;
    double white;  // standard deviation of one reading
    Eigen::Vector3d turn_on;
    WanderingBias wandering;
  };
  ImuModel model_;
  Axes gyroscope_, accelerometer_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_IMU_H_
