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

constexpr int kShuffleEvery = 8;  // iterations of QuickStep

// What the thread shuffles constraints with, in the step that it is at.
struct Shuffling {
  std::uint64_t seed = 0;
  int of_island = 1;  // shuffles that each island has
  int begun = 0;      // of the island at hand
  std::uint32_t state = 0;
};
thread_local Shuffling shuffling;

// SplitMix64's (Steele, Lea and Flood 2014).
std::uint64_t Mixed(std::uint64_t bits) {
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
  return bits ^ bits >> 31;
}

int ShufflesOf(int iterations) { return (iterations - 1) / kShuffleEvery; }

// How many shuffles a step over one island takes from us.
int ShufflesOfAnIsland(int iterations) {
  const OdeThreading threading;
  const OdeWorldHandle world = threading.MakeWorld();
  const dJointID hinge = dJointCreateHinge(world.get(), nullptr);
  dJointAttach(hinge, dBodyCreate(world.get()), nullptr);
  dWorldSetQuickStepNumIterations(world.get(), iterations);
  shuffling = {};
  shuffling.of_island = iterations;
  dWorldQuickStep(world.get(), 0.01);
  return shuffling.begun;
}

}  // namespace

OdeThreading::OdeThreading() : id_(dThreadingAllocateSelfThreadedImplementation()) {}

OdeThreading::~OdeThreading() { dThreadingFreeImplementation(id_); }

OdeWorldHandle OdeThreading::MakeWorld() const {
  OdeWorldHandle world(dWorldCreate());
  dWorldSetStepThreadingImplementation(world.get(), dThreadingImplementationGetFunctions(id_), id_);
  return world;
}

void ReadyOde() {
  static std::once_flag once;
  std::call_once(once, [] {
    LW_CHECK(dInitODE2(dInitFlagManualThreadCleanup) != 0, "ODE cannot be initialized");
    LW_CHECK(dAllocateODEDataForThread(dAllocateMaskAll) != 0, "out of memory for ODE");
    for (const int iterations : {1, 8, 9, 12, 45}) {
      LW_CHECK(ShufflesOfAnIsland(iterations) == ShufflesOf(iterations),
               "ODE shuffles constraints by other random numbers or at other times");
    }
  });
  static thread_local const ThreadData data;
  (void)data;
}

void StepOde(dWorldID world, double step_s, std::uint64_t solver_seed) {
  ReadyOde();
  shuffling.seed = solver_seed;
  shuffling.of_island = ShufflesOf(dWorldGetQuickStepNumIterations(world));
  shuffling.begun = 0;
  dWorldQuickStep(world, step_s);
}

}  // namespace latticeworld

// Takes the place of ODE's own, whose state belongs to the process. QuickStep shuffles the
// constraints of an island with it, every so many iterations anew, and each shuffle begins with a
// draw of two. There the numbers begin anew, so that shuffles depend on the step's seed and on
// their number in the island, and neither on other islands nor on who solves them. Between, the
// numbers are those of a linear congruential generator (Press et al. 1992), whose high bits are
// used.
extern "C" __attribute__((visibility("default"))) int dRandInt(int n) {
  latticeworld::Shuffling& own = latticeworld::shuffling;
  if (n == 2) {
    if (own.begun >= own.of_island) own.begun = 0;
    ++own.begun;
    own.state = static_cast<std::uint32_t>(latticeworld::Mixed(
        own.seed + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(own.begun)));
  }
  own.state = 1664525u * own.state + 1013904223u;
  const auto range = static_cast<std::uint32_t>(n);
  return static_cast<int>(static_cast<std::uint64_t>(own.state) * range >> 32);
}
