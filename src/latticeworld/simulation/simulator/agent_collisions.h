#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COLLISIONS_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COLLISIONS_H_

#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// Hurts and knocks over, after the physics' step, agents that met something faster than they can
// bear; tells collided, hit and died.
void CollideAgents(RunningWorld* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COLLISIONS_H_
