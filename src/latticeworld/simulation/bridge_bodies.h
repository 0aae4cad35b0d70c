#ifndef LATTICEWORLD_SIMULATION_BRIDGE_BODIES_H_
#define LATTICEWORLD_SIMULATION_BRIDGE_BODIES_H_

#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

struct Terrain;

// Puts the parts of the bridges of a terrain's roads into the physics, as bodies that nothing
// moves: they are driven on, passed below and run into.
void AddBridgeBodies(const Terrain& terrain, PhysicsWorld* physics);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_BRIDGE_BODIES_H_
