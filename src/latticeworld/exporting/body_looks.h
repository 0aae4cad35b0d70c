#ifndef LATTICEWORLD_EXPORTING_BODY_LOOKS_H_
#define LATTICEWORLD_EXPORTING_BODY_LOOKS_H_

#include <Eigen/Core>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/exporting/picture_light.h"
#include "latticeworld/exporting/ray_materials.h"
#include "latticeworld/scene/element.h"
#include "latticeworld/sensing/ray_scene.h"

namespace latticeworld {

// A display colour as linear light.
Light LightOf(const Color& bgr);

// Where a ray met a body of that kind.
SurfaceLook LookOfBody(AgentCategory category, ArtisticStyle style, const RayHit& hit);
// Where one met an element of that kind: boards with grain, or rock. in_element_m: the place in the
// element's own frame.
SurfaceLook LookOfElement(ElementKind kind, ArtisticStyle style, const RayHit& hit,
                          const Eigen::Vector3f& in_element_m, float footprint_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_BODY_LOOKS_H_
