#ifndef LATTICEWORLD_SIMULATION_WATER_FORCES_H_
#define LATTICEWORLD_SIMULATION_WATER_FORCES_H_

#include "latticeworld/scene/weather/atmosphere.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

struct Terrain;

// What water does to a body.
struct Buoyancy {
  double volume_m3 = 0.0;     // of the whole body, shared among its shapes by their volume
  double drag_area_m2 = 0.0;  // drag coefficient times area when all of it is under water
};

// Applies buoyancy (at eight points of each shape, so that what floats finds its balance) and drag
// of still water for the next step. True: some of it is in water. A body that rests is left alone
// where the water does not move it.
bool ActOfWater(const Terrain& terrain, const Atmosphere& atmosphere, const Buoyancy& buoyancy,
                BodyId body, PhysicsWorld* physics);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_WATER_FORCES_H_
