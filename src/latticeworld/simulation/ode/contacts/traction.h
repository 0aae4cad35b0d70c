#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_TRACTION_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_TRACTION_H_

#include <Eigen/Core>

namespace latticeworld {

// How a contact pushes along the surface.
struct Traction {
  Eigen::Vector3d along = Eigen::Vector3d::Zero();  // first friction direction; zero: any
  double friction_along = 0.0;
  double friction_across = 0.0;
  double speed_mps = 0.0;       // of the body along `along` that friction pushes towards
  double slip_mps_per_n = 0.0;  // speed that the contact gives way along `along` under a force

  // Feet push the surface away: friction acts towards the wanted velocity along it. normal: unit.
  void WalkAt(const Eigen::Vector3d& wanted_mps, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d on_surface = wanted_mps - wanted_mps.dot(normal) * normal;
    if (on_surface.squaredNorm() > 1e-12) {
      along = on_surface;
      speed_mps = wanted_mps.norm();
    }
  }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_TRACTION_H_
