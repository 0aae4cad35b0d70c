// Makes a small world with the core and puts its layout into a message: a program of somebody else.

// The messages' namespace is named as the core's; this keeps the two apart.
#define latticeworld latticeworld_msgs
#include <latticeworld/Layout.h>
#undef latticeworld

#include <cstdlib>
#include <iostream>

#include "latticeworld/generation/world_generator.h"

int main() {
  latticeworld::GenerationRequest request;
  request.layout_instruction = "A lake in the center, forest around it.";
  request.environment_instruction = "A sunny noon.";
  request.seed = 3;
  request.size_m = 64.0;
  latticeworld::WorldGenerator generator = latticeworld::MakeDefaultWorldGenerator();
  const auto world = generator.Generate(request, latticeworld::Progress());
  if (!world.ok()) {
    std::cerr << world.status().ToString() << "\n";
    return EXIT_FAILURE;
  }
  latticeworld_msgs::Layout message;
  message.world_id = world.value()->id;
  std::cout << message.world_id << "\n";
  return EXIT_SUCCESS;
}
