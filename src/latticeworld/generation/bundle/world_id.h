#ifndef LATTICEWORLD_GENERATION_BUNDLE_WORLD_ID_H_
#define LATTICEWORLD_GENERATION_BUNDLE_WORLD_ID_H_

#include <optional>
#include <string>

#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// "world-" and the first 12 hexadecimal digits of the SHA-256 over all that a world is made of:
// layout, environment, every grid of the terrain, assets, the texts of the files added to the
// catalogue, atmosphere, agents, props, and where it lies on the earth. What was asked for, who
// answered and how long it took do not count: the same content has the same id.
std::string ContentId(const SymbolicLayout& layout, const Scene& scene,
                      const std::optional<GeoOrigin>& geo);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_WORLD_ID_H_
