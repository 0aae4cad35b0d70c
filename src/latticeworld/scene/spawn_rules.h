#ifndef LATTICEWORLD_SCENE_SPAWN_RULES_H_
#define LATTICEWORLD_SCENE_SPAWN_RULES_H_

#include "latticeworld/common/random.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// OK when an agent of the category with that body radius can live at the place: inside the world,
// not in or within its radius of a solid asset, not under water that it cannot live in (and whales
// only in water deep enough), not on ground too steep to stand on. Else OUT_OF_RANGE or
// FAILED_PRECONDITION that says why.
Status CheckSpawn(const Scene& scene, AgentCategory category, double body_radius_m,
                  WorldPoint position);

// A place for it in the region, at least `clearance_m` away from the `taken` places; prefers ground
// that suits the category (sheep: grass). NOT_FOUND that says why when there is none.
Result<WorldPoint> FindSpawn(const Scene& scene, AgentCategory category, double body_radius_m,
                             Region region, const std::vector<WorldPoint>& taken,
                             RandomStream* random);

// Radius of the vertical cylinder around a body of the category [m].
double BodyRadius(AgentCategory category);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SPAWN_RULES_H_
