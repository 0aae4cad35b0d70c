#ifndef LATTICEWORLD_GENERATION_BUNDLE_REBUILD_H_
#define LATTICEWORLD_GENERATION_BUNDLE_REBUILD_H_

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/bundle/manifest.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld/generation/world.h"

namespace latticeworld {

// Makes a world again from its request and the recorded answers of its language model, without the
// model, from its own catalogue: on the same build the same world, with the same id. sketches: has
// to be what the world's sketch became land by. Errors: as WorldGenerator; FAILED_PRECONDITION for
// another translator.
Result<std::shared_ptr<const World>> RebuildWorld(const World& world, const Progress& progress,
                                                  SketchTranslator sketches = SketchTranslator());

// The names of the files in which the bundles of two manifests differ or that only one of them has,
// sorted; world.json where it says anything else but the files and how long the stages took.
std::vector<std::string> DifferingFiles(const Manifest& a, const Manifest& b);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_REBUILD_H_
