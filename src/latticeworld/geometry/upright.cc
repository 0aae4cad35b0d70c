#include "latticeworld/geometry/upright.h"

namespace latticeworld {

// In one source alone: for opposite directions Eigen asks a singular value decomposition, which a
// compiler works at for five seconds.
Eigen::Quaterniond TurnFromUp(const Eigen::Vector3d& direction) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction);
}

}  // namespace latticeworld
