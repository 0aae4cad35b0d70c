#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_

#include <memory>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// A PhysicsWorld on the Open Dynamics Engine: its bodies, joints and solver, with our own contacts
// against the ground grid and the assets near each body (ODE's height field is slower and gets
// stuck on creases).
std::unique_ptr<PhysicsWorld> MakeOdeWorld(std::shared_ptr<const Scene> scene);

// Bodies that gained more energy in the last step than can have been given to them, and were slowed
// down. Of a world that MakeOdeWorld made; none of another, and none right after Restore.
std::vector<BodyId> SlowedDown(const PhysicsWorld& world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_
