#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_STILLNESS_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_STILLNESS_H_

#include "latticeworld/simulation/ode/body/body_control.h"
#include "latticeworld/simulation/ode/body/body_parts.h"

namespace latticeworld {

// Nothing is wanted of a body that is not held fast, and it hardly moves.
bool IsStill(const BodyParts& parts, const BodyControl& control);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_STILLNESS_H_
