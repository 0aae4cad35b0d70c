#ifndef LATTICEWORLD_TESTS_SIMULATION_ODE_CLOSED_FORM_BODIES_H_
#define LATTICEWORLD_TESTS_SIMULATION_ODE_CLOSED_FORM_BODIES_H_

#include "simulation/ode/test_bodies.h"

namespace latticeworld {

using test_bodies::At;
using test_bodies::BallInTheAir;
using test_bodies::Box;

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SIMULATION_ODE_CLOSED_FORM_BODIES_H_
