// From words to a world to a picture, without ROS.
//
// Usage: make_world LAND ENVIRONMENT FILE.png

#include <cstdlib>
#include <iostream>
#include <string>

#include "latticeworld/common/files.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/rendering/picture.h"

namespace lw = latticeworld;

// Makes the world, says of each claim that the words make whether the world keeps it, and draws it.
lw::Status MakeWorld(const lw::GenerationRequest& request, const std::string& file) {
  lw::WorldGenerator generator = lw::MakeDefaultWorldGenerator();
  LW_ASSIGN_OR_RETURN(const auto world, generator.Generate(request, lw::Progress()));
  for (const auto& claim : world->fidelity.claims)
    std::cout << (claim.satisfied ? "kept    " : "missed  ") << claim.words << "\n";
  std::cout << world->id << " has " << world->scene->assets.size() << " plants and things\n";
  LW_ASSIGN_OR_RETURN(const std::string png, lw::DrawWorld(*world->scene, lw::PictureOptions()));
  return lw::WriteFile(file, png);
}

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: make_world LAND ENVIRONMENT FILE.png\n";
    return 2;
  }
  lw::GenerationRequest request;
  request.layout_instruction = argv[1];
  request.environment_instruction = argv[2];
  request.seed = 37;  // The same words and seed give the same world, bit for bit.
  request.size_m = 256.0;
  const lw::Status status = MakeWorld(request, argv[3]);
  if (!status.ok()) std::cerr << "make_world: " << status.ToString() << "\n";
  return status.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
