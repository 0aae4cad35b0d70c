#ifndef LATTICEWORLD_SCENE_AGENTS_AGENT_PLACEMENT_H_
#define LATTICEWORLD_SCENE_AGENTS_AGENT_PLACEMENT_H_

#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/scene/scene.h"

namespace latticeworld {

// The agents that scene.environment asks for, by the spawn rules, over the scene's ground,
// waters and assets. Grazing groups stand in herds; flyers start 8 to 15 m above the ground and
// whales in the lower half of the water. Animals are of team 0, robots of 1, goblins and ancient
// warriors of 2. Wheeled robots are controllable; the first is named "robot" and every world has
// it: near the centre where no group asks for one. On ground that they
// would slide from (HoldingSlope_deg) agents stand only where their region has no other, and a
// warning says so. What found no place is a warning with figures and reason.
std::vector<AgentStart> PlaceAgents(const Scene& scene, std::uint64_t seed,
                                    std::vector<std::string>* warnings);

// 0: animals, 1: robots, 2: goblins and ancient warriors.
int TeamOf(AgentCategory category);
// What a category does when nobody says.
AgentState UsualState(AgentCategory category);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_AGENTS_AGENT_PLACEMENT_H_
