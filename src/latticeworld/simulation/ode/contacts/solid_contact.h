#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_SOLID_CONTACT_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_SOLID_CONTACT_H_

#include <Eigen/Core>

#include "latticeworld/simulation/ode/contacts/contact_joints.h"
#include "latticeworld/simulation/ode/contacts/traction.h"

namespace latticeworld {

// What contacts with assets and with other bodies have in common.

inline constexpr double kObstacleFriction = 0.3;  // of bodies beside trunks, walls and each other
inline constexpr double kOnTop = 0.5;  // z of the normal from which on a body stands on another
inline constexpr double kJudgedApproach_mps = 0.05;  // from which on the judge is asked

// Whoever stands on something drives and walks on it; what is beside it only rubs. normal: unit,
// into the body.
Traction SolidTraction(const ContactSide& side, const Eigen::Vector3d& normal);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_SOLID_CONTACT_H_
