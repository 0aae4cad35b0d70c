#ifndef LATTICEWORLD_SCENE_AGENTS_SPAWN_RULES_H_
#define LATTICEWORLD_SCENE_AGENTS_SPAWN_RULES_H_

#include "latticeworld/common/random.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

struct SceneChanges;

// OK when an agent of the category with that body radius can live at the place: wholly inside the
// world, not in or within its radius of a solid asset, in water of at most 0.2 m for legs and
// wheels and of at least 2 m for fins, on slopes of at most 35 degrees for legs and 30 for wheels.
// Depth and slope are those of the centre and the rim of the body. Else OUT_OF_RANGE (place
// outside, or a radius that is not positive or larger than half the world) or FAILED_PRECONDITION
// that says why, with the figures found and allowed. atmosphere: of the moment, whose waters count.
// changes: assets that do not stand are in nobody's way; null: all stand.
Status CheckSpawn(const Scene& scene, const Atmosphere& atmosphere, AgentCategory category,
                  double body_radius_m, WorldPoint position, const SceneChanges* changes = nullptr);

// A place for it in the region that passes CheckSpawn, at least 2 m and two radii away from the
// `taken` places; prefers ground that suits the category (sheep: grass), and takes ground that it
// does not stand still on (HoldingSlope_deg) only where the region has no other. Random tries, then
// a scan whose step is the radius, 0.5 m or 1/256 of the region, whichever is largest. NOT_FOUND
// that counts why when neither finds one.
Result<WorldPoint> FindSpawn(const Scene& scene, const Atmosphere& atmosphere,
                             AgentCategory category, double body_radius_m, Region region,
                             const std::vector<WorldPoint>& taken, RandomStream* random,
                             const SceneChanges* changes = nullptr);
Result<WorldPoint> FindSpawn(const Scene& scene, AgentCategory category, double body_radius_m,
                             Region region, const std::vector<WorldPoint>& taken,
                             RandomStream* random);

// Radius of the vertical cylinder around a body of the category's built-in species [m].
double BodyRadius(AgentCategory category);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_AGENTS_SPAWN_RULES_H_
