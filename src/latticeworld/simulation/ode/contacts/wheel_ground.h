#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_WHEEL_GROUND_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_WHEEL_GROUND_H_

#include <ode/ode.h>

#include <Eigen/Core>

#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld {

// What a wheel that touches the ground carries.
struct WheelLoad {
  double mass_kg;
  const WheelSpec& wheel;
};

// Speed by which the tread of a turning wheel slips for each newton that it pushes with [m/s/N]:
// gross traction grows with slip as 1 - exp(-0.3 Cn s) after Wismer and Luth (1974), Cn being the
// cone index times width and diameter over the load, up to what friction holds; the straight line
// through the slip at which the wheel overcomes its own rolling resistance stands for the curve. A
// wheel that stands does not slip. friction: along the wheel. rate_radps: of the wheel.
double SlipPerForce(const WheelLoad& load, const SurfaceProperties& surface, double friction,
                    double rate_radps);

// Says where a wheel rolls on the ground.
struct RollingContact {
  dBodyID wheel = nullptr;
  double load_kg = 0.0;     // that the wheel carries
  double share = 1.0;       // of that load on this contact
  Eigen::Vector3d normal;   // unit, out of the ground
  Eigen::Vector3d forward;  // along the wheel, of any length
};

// Holds the wheel back by the rolling resistance of the surface against the direction that it rolls
// in, and never turns it round.
void ResistRolling(const RollingContact& contact, const SurfaceProperties& surface, double step_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_WHEEL_GROUND_H_
