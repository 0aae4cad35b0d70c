#ifndef LATTICEWORLD_PYTHON_CORE_SIMULATION_H_
#define LATTICEWORLD_PYTHON_CORE_SIMULATION_H_

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include "errors.h"
#include "latticeworld/learning/arena.h"
#include "world.h"

namespace latticeworld::python {

// An arena as Python has it. A call while another thread is in one is refused: nobody waits for
// something that may itself wait for Python's lock.
class PySimulation {
 public:
  PySimulation(std::shared_ptr<PyWorld> world, std::unique_ptr<Arena> arena)
      : world_(std::move(world)), arena_(std::move(arena)) {}
  ~PySimulation() {
    if (guard_.forked()) (void)arena_.release();  // Embree's threads cannot be waited for
  }
  PySimulation(const PySimulation&) = delete;
  PySimulation& operator=(const PySimulation&) = delete;

  // Holds the simulation for one call.
  class Use {
   public:
    explicit Use(PySimulation* simulation) : simulation_(simulation) {
      simulation_->guard_.Check();
      if (simulation_->used_.exchange(true)) {
        throw StatusError(FailedPrecondition(
            "this simulation is in a call of another thread; one at a time is legal"));
      }
    }
    ~Use() { simulation_->used_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    Arena* operator->() const { return simulation_->arena_.get(); }
    Arena* get() const { return simulation_->arena_.get(); }

   private:
    PySimulation* simulation_;
  };

  const std::shared_ptr<PyWorld>& world() const { return world_; }

 private:
  ForkGuard guard_{"this simulation"};
  std::atomic<bool> used_{false};
  std::shared_ptr<PyWorld> world_;
  std::unique_ptr<Arena> arena_;
};

void BindSimulation(nb::module_& module);

}  // namespace latticeworld::python

#endif  // LATTICEWORLD_PYTHON_CORE_SIMULATION_H_
