#ifndef LATTICEWORLD_GENERATION_REBUILD_H_
#define LATTICEWORLD_GENERATION_REBUILD_H_

#include <memory>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld/generation/world.h"

namespace latticeworld {

// Makes a world again from its request and the recorded answers of its language model, without the
// model, from its own catalogue: on the same build the same world, with the same id. sketches: has
// to be what the world's sketch became land by. Errors: as WorldGenerator; FAILED_PRECONDITION for
// another translator.
Result<std::shared_ptr<const World>> RebuildWorld(const World& world, const Progress& progress,
                                                  SketchTranslator sketches = SketchTranslator());

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_REBUILD_H_
