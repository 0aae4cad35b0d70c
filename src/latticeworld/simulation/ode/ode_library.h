#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_

#include <ode/ode.h>

#include <cstdint>

namespace latticeworld {

// Readies ODE for the calling thread; cheap after the first call of a thread.
void ReadyOde();

// One step of the world; several threads may step a world each. Constraints are shuffled by the
// seed alone: whatever else the world holds, bodies that touch each other move the same.
void StepOde(dWorldID world, double step_s, std::uint64_t solver_seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_
