#include <map>
#include <string>
#include <utility>

#include "latticeworld/generation/world_generator.h"
#include "latticeworld/language/grounded/grounded.h"

namespace latticeworld {

WorldGenerator MakeDefaultWorldGenerator() {
  std::map<std::string, LanguageBackend> backends;
  backends["grounded"] = {MakeGroundedLayoutGenerator(), MakeGroundedEnvironmentGenerator()};
  return WorldGenerator(std::move(backends), "grounded");
}

}  // namespace latticeworld
