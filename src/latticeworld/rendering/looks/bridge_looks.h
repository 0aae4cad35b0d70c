#ifndef LATTICEWORLD_RENDERING_LOOKS_BRIDGE_LOOKS_H_
#define LATTICEWORLD_RENDERING_LOOKS_BRIDGE_LOOKS_H_

#include "latticeworld/environment/attributes.h"
#include "latticeworld/rendering/ray/picture_light.h"
#include "latticeworld/rendering/ray/ray_materials.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {

// RgbOfBridge (bridge_colors.h), as pictures have colours.
Color ColorOfBridge(BridgeKind kind, BridgePartKind part, bool top);

// Returns the look of a bridge where a ray met it: planks, courses of stone or smooth concrete.
// footprint_m: the extent of a sample of the picture there.
SurfaceLook LookOfBridge(const Bridge& bridge, ArtisticStyle style, const RayHit& hit,
                         const Eigen::Vector3f& point_m, float footprint_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_BRIDGE_LOOKS_H_
