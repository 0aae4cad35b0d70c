#ifndef LATTICEWORLD_SENSING_MOTION_BUMPER_H_
#define LATTICEWORLD_SENSING_MOTION_BUMPER_H_

#include <Eigen/Core>

#include "latticeworld/sensing/motion/motion_sensors.h"

namespace latticeworld {

// A switch around the body. It holds until it is read, so that a short bump is not missed: a
// reading tells the hardest contact since the one before.
class Bumper {
 public:
  explicit Bumper(const BumperModel& model) : model_(model) {}

  // The hardest contact of a step; direction: to it, in base_link, any length.
  void Add(double force_n, const Eigen::Vector3d& direction);
  // Force and bearing are 0 where it is not pressed; time_s is left as it is.
  BumperReading Read();

 private:
  BumperModel model_;
  double force_n_ = 0.0;
  double bearing_rad_ = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_BUMPER_H_
