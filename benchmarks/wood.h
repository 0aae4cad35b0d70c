#ifndef LATTICEWORLD_BENCHMARKS_WOOD_H_
#define LATTICEWORLD_BENCHMARKS_WOOD_H_

#include <memory>

#include "latticeworld/scene/scene.h"

namespace latticeworld {

// A kilometre of hilly land at 0.5 m with 100,000 trees of 8 to 22 m at random, made once a
// process.
std::shared_ptr<const Scene> KilometreOfWood();

}  // namespace latticeworld

#endif  // LATTICEWORLD_BENCHMARKS_WOOD_H_
