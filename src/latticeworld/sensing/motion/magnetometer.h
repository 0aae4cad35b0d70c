#ifndef LATTICEWORLD_SENSING_MOTION_MAGNETOMETER_H_
#define LATTICEWORLD_SENSING_MOTION_MAGNETOMETER_H_

#include <Eigen/Core>
#include <cstdint>

#include "latticeworld/sensing/motion/motion_sensors.h"

namespace latticeworld {

// The earth's field at the world's origin, in the sensor's frame, with a constant bias and white
// noise. What is of iron in the world bends no field.
class Magnetometer {
 public:
  Magnetometer(const MagnetometerModel& model, const GeoOrigin& origin, std::uint64_t key);

  // k: the reading's number; time_s is left as it is.
  MagnetometerReading Read(const Eigen::Matrix3d& map_from_sensor, std::uint64_t k) const;

 private:
  MagnetometerModel model_;
  Eigen::Vector3d field_t_;  // map frame
  Eigen::Vector3d bias_t_;   // sensor frame
  std::uint64_t white_key_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_MAGNETOMETER_H_
