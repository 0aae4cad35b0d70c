#ifndef LATTICEWORLD_SIMULATION_AGENTS_LIMITS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_LIMITS_H_

#include <Eigen/Core>

namespace latticeworld {

// The vector, no longer than `most` [of its unit].
inline Eigen::Vector3d NoLongerThan(double most, const Eigen::Vector3d& vector) {
  const double length = vector.norm();
  return length > most ? Eigen::Vector3d(most / length * vector) : vector;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_LIMITS_H_
