#include "latticeworld/simulation/ode/ode_library.h"

#include <mutex>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

struct ThreadData {
  ThreadData() {
    LW_CHECK(dAllocateODEDataForThread(dAllocateMaskAll) != 0, "out of memory for ODE");
  }
  ~ThreadData() { dCleanupODEAllDataForThread(); }
};

}  // namespace

void ReadyOde() {
  static std::once_flag once;
  std::call_once(once, [] {
    LW_CHECK(dInitODE2(dInitFlagManualThreadCleanup) != 0, "ODE cannot be initialized");
  });
  static thread_local const ThreadData data;
  (void)data;
}

void StepOde(dWorldID world, double step_s, std::uint64_t solver_seed) {
  ReadyOde();
  static std::mutex random_state;
  const std::lock_guard<std::mutex> lock(random_state);
  dRandSetSeed(static_cast<unsigned long>(solver_seed & 0xffffffffULL));
  dWorldQuickStep(world, step_s);
}

}  // namespace latticeworld
