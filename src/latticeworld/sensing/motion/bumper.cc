#include "latticeworld/sensing/motion/bumper.h"

#include <cmath>

namespace latticeworld {

void Bumper::Add(double force_n, const Eigen::Vector3d& direction) {
  if (!(force_n > force_n_)) return;
  force_n_ = force_n;
  bearing_rad_ = std::atan2(direction.y(), direction.x());
}

BumperReading Bumper::Read() {
  BumperReading reading;
  reading.pressed = force_n_ > model_.threshold_n;
  if (reading.pressed) {
    reading.force_n = force_n_;
    reading.bearing_rad = bearing_rad_;
  }
  force_n_ = bearing_rad_ = 0.0;
  return reading;
}

}  // namespace latticeworld
