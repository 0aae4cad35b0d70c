#ifndef LATTICEWORLD_GENERATION_WORLD_ID_H_
#define LATTICEWORLD_GENERATION_WORLD_ID_H_

#include <string>

#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// "world-" and the first 12 hexadecimal digits of the SHA-256 over all that a world is made of:
// layout, environment, every grid of the terrain, assets, atmosphere and agents. What was asked
// for, who answered and how long it took do not count: the same content has the same id.
std::string ContentId(const SymbolicLayout& layout, const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_WORLD_ID_H_
