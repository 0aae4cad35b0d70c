#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_H_

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// Distance between the contact points of the left and right wheels, and their radius, of the
// wheeled robot [m].
inline constexpr double kWheelTrack_m = 0.46;
inline constexpr double kWheelRadius_m = 0.12;

// The body of a category, as wide as the scene's spawn rules take it to be.
BodySpec BodyOf(AgentCategory category);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_H_
