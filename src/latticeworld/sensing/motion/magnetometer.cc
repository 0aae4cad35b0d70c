#include "latticeworld/sensing/motion/magnetometer.h"

#include "latticeworld/sensing/counter_noise.h"
#include "latticeworld/sensing/motion/geodesy.h"

namespace latticeworld {
Magnetometer::Magnetometer(const MagnetometerModel& model, const GeoOrigin& origin,
                           std::uint64_t key)
    : model_(model),
      field_t_(MagneticField(origin)),
      bias_t_(model.bias_t * NormalsAt(KeyOf(key, 0), 0)),
      white_key_(KeyOf(key, 1)) {}

MagnetometerReading Magnetometer::Read(const Eigen::Matrix3d& map_from_sensor,
                                       std::uint64_t k) const {
  MagnetometerReading reading;
  reading.field_t =
      map_from_sensor.transpose() * field_t_ + bias_t_ + model_.noise_t * NormalsAt(white_key_, k);
  return reading;
}

}  // namespace latticeworld
