#include "latticeworld/generation/bundle/rebuild.h"

#include <algorithm>
#include <utility>

#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/generation/bundle/load_language.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {

Result<std::shared_ptr<const World>> RebuildWorld(const World& world, const Progress& progress,
                                                  SketchTranslator sketches) {
  const std::string& made_by = world.request.sketch_translator;
  if (!made_by.empty() && made_by != sketches.name()) {
    return FailedPrecondition("the world's sketch became land by " + made_by + ", not by " +
                              sketches.name() + "; give the model that it was made with");
  }
  WorldGenerator generator(MakeReplayStack(world.replies), std::move(sketches),
                           world.scene->catalogue);
  return generator.Generate(world.request, progress);
}

std::vector<std::string> DifferingFiles(const Manifest& a, const Manifest& b) {
  std::vector<std::string> names;
  for (const auto& [here, there] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const BundleFile& file : here->files) {
      const bool same =
          std::any_of(there->files.begin(), there->files.end(), [&file](const BundleFile& other) {
            return other.name == file.name && other.sha256 == file.sha256;
          });
      if (!same) names.push_back(file.name);
    }
  }
  const auto rest_of = [](Manifest manifest) {
    manifest.files.clear();
    manifest.stages.clear();
    return EncodeManifest(manifest);
  };
  if (rest_of(a) != rest_of(b)) names.emplace_back(kManifestFile);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace latticeworld
