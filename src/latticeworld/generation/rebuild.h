#ifndef LATTICEWORLD_GENERATION_REBUILD_H_
#define LATTICEWORLD_GENERATION_REBUILD_H_

#include <memory>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"

namespace latticeworld {

// Makes a world again from its request and the recorded answers of its language model, without the
// model: on the same build the same world, with the same id. Errors: as WorldGenerator.
Result<std::shared_ptr<const World>> RebuildWorld(const World& world, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_REBUILD_H_
