#include "latticeworld/generation/rebuild.h"

#include <utility>

#include "latticeworld/generation/language_backends.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {

Result<std::shared_ptr<const World>> RebuildWorld(const World& world, const Progress& progress,
                                                  SketchTranslator sketches) {
  const std::string& made_by = world.request.sketch_translator;
  if (!made_by.empty() && made_by != sketches.name()) {
    return FailedPrecondition("the world's sketch became land by " + made_by + ", not by " +
                              sketches.name() + "; give the model that it was made with");
  }
  LanguageBackends backends = MakeReplayBackends(world.replies);
  WorldGenerator generator(std::move(backends.by_name), "grounded", std::move(sketches),
                           world.scene->catalogue);
  return generator.Generate(world.request, progress);
}

}  // namespace latticeworld
