#ifndef LATTICEWORLD_RENDERING_LOOKS_BODY_LOOKS_H_
#define LATTICEWORLD_RENDERING_LOOKS_BODY_LOOKS_H_

#include <Eigen/Core>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/rendering/ray/picture_light.h"
#include "latticeworld/rendering/ray/ray_materials.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

// A display colour as linear light.
Light LightOf(const Color& bgr);

// Where a ray met a body of that kind.
SurfaceLook LookOfBody(AgentCategory category, ArtisticStyle style, const RayHit& hit);
// Where one met a prop of that kind: boards with grain, or rock. in_prop_m: the place in the
// prop's own frame.
SurfaceLook LookOfProp(PropKind kind, ArtisticStyle style, const RayHit& hit,
                       const Eigen::Vector3f& in_prop_m, float footprint_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_BODY_LOOKS_H_
