#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_STRAYING_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_STRAYING_H_

#include <cstdint>

namespace latticeworld {

// Something that physics cannot compute, or that leaves the world again and again: one episode,
// which is told once. Episode steps.
struct Stray {
  std::uint64_t since = 0;
  std::uint64_t until = 0;  // then it is well again, when it does not stray until then
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_STRAYING_H_
