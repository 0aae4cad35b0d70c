#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_

#include <ode/ode.h>

#include <cstdint>
#include <memory>

namespace latticeworld {

struct OdeWorldDelete {
  void operator()(dxWorld* world) const { dWorldDestroy(world); }
};
using OdeWorldHandle = std::unique_ptr<dxWorld, OdeWorldDelete>;

// Readies ODE for the calling thread; cheap after the first call of a thread.
void ReadyOde();

// What the worlds of one thread at a time are stepped by: ODE's common one is for one thread alone.
class OdeThreading {
 public:
  OdeThreading();
  ~OdeThreading();
  OdeThreading(const OdeThreading&) = delete;
  OdeThreading& operator=(const OdeThreading&) = delete;

  // Makes a world. The caller must destroy it before this object.
  OdeWorldHandle MakeWorld() const;

 private:
  dThreadingImplementationID id_;
};

// One step of the world; several threads may step a world each. Constraints are shuffled by the
// seed alone: whatever else the world holds, bodies that touch each other move the same.
void StepOde(dWorldID world, double step_s, std::uint64_t solver_seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_LIBRARY_H_
