#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COLLISIONS_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COLLISIONS_H_

#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// After the physics' step: what agents met faster than they can bear hurts them and knocks them
// over; tells collided, hit and died.
void CollideAgents(RunningWorld* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COLLISIONS_H_
