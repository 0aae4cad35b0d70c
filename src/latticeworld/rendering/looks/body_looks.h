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

// Returns the look of a body of that kind where a ray met it.
SurfaceLook LookOfBody(AgentCategory category, ArtisticStyle style, const RayHit& hit);
// Returns the look of a prop of that kind where a ray met it: boards with grain, or rock.
// in_prop_m: the place in the prop's own frame. footprint_m: the extent of a sample of the picture
// there.
SurfaceLook LookOfProp(PropKind kind, ArtisticStyle style, const RayHit& hit,
                       const Eigen::Vector3f& in_prop_m, float footprint_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_BODY_LOOKS_H_
