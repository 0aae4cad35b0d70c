#include "example_world.h"

#include <map>

#include "latticeworld/generation/world_generator.h"

namespace latticeworld {

GenerationRequest ExampleRequest() {
  GenerationRequest request;
  request.layout_instruction =
      "A river winds from the north to the south between dense forest in the upper left and "
      "farmland on the right. A road runs from the west to the east, with a small village in the "
      "center.";
  request.environment_instruction =
      "A sunny autumn afternoon. Nine sheep graze in the lower left, two goblins "
      "patrol near the upper right, an eagle circles above, and a wheeled robot waits in the "
      "center.";
  request.seed = 1;
  return request;
}

std::shared_ptr<const World> ExampleWorld(const std::string& agents) {
  static std::map<std::string, std::shared_ptr<const World>> worlds;
  std::shared_ptr<const World>& world = worlds[agents];
  if (world == nullptr) {
    GenerationRequest request = ExampleRequest();
    if (!agents.empty()) request.environment_instruction = "A sunny summer day. " + agents;
    world = MakeDefaultWorldGenerator().Generate(request, Progress()).value();
  }
  return world;
}

}  // namespace latticeworld
