#ifndef LATTICEWORLD_GEOMETRY_UPRIGHT_H_
#define LATTICEWORLD_GEOMETRY_UPRIGHT_H_

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace latticeworld {

// Returns the shortest turn that carries up (0, 0, 1) to a direction of any length above 0: how
// what stood upright stands on a slope, or lies along its stem.
Eigen::Quaterniond TurnFromUp(const Eigen::Vector3d& direction);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMETRY_UPRIGHT_H_
