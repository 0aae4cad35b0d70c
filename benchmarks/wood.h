#ifndef LATTICEWORLD_BENCHMARKS_WOOD_H_
#define LATTICEWORLD_BENCHMARKS_WOOD_H_

#include <memory>

#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/embree_handles.h"

namespace latticeworld {

// A kilometre of hilly land at 0.5 m with 100,000 trees of 8 to 22 m at random, made once a
// process.
std::shared_ptr<const Scene> KilometreOfWood();

// Its trees as one mesh of 50 triangles each: a trunk of 7 sides and a closed ellipsoid of a crown
// from 0.3 of the height to the top.
EmbreeGeometry SolidTrees(RTCDevice device, const Scene& wood);

}  // namespace latticeworld

#endif  // LATTICEWORLD_BENCHMARKS_WOOD_H_
