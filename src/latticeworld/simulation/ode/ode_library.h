#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_

#include <ode/ode.h>

#include <cstdint>

namespace latticeworld {

// Readies ODE for the calling thread; cheap after the first call of a thread.
void ReadyOde();

// One step of the world. ODE's random state, which orders the constraints, belongs to the process:
// it is seeded here and held until the step ends, so that worlds do not see each other. Worlds of
// one process thus solve one after the other, also on several threads.
void StepOde(dWorldID world, double step_s, std::uint64_t solver_seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_
