#include "latticeworld/generation/rebuild.h"

#include <utility>

#include "latticeworld/generation/language_backends.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {

Result<std::shared_ptr<const World>> RebuildWorld(const World& world, const Progress& progress) {
  LanguageBackends backends = MakeReplayBackends(world.replies);
  WorldGenerator generator(std::move(backends.by_name), "grounded");
  return generator.Generate(world.request, progress);
}

}  // namespace latticeworld
