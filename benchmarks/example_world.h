#ifndef LATTICEWORLD_BENCHMARKS_EXAMPLE_WORLD_H_
#define LATTICEWORLD_BENCHMARKS_EXAMPLE_WORLD_H_

#include <memory>
#include <string>

#include "latticeworld/generation/world.h"

namespace latticeworld {

// The README's request at the default size: 512 m at 0.5 m, seed 1.
GenerationRequest ExampleRequest();

// Its world, generated once a process. `agents` replaces the agents' part of the environment
// instruction when it is not empty.
std::shared_ptr<const World> ExampleWorld(const std::string& agents = "");

}  // namespace latticeworld

#endif  // LATTICEWORLD_BENCHMARKS_EXAMPLE_WORLD_H_
