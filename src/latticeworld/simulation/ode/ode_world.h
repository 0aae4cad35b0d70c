#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_

#include <memory>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// A PhysicsWorld on the Open Dynamics Engine: its bodies, joints and solver, with our own contacts
// against the ground grid and the assets near each body (ODE's height field is slower and gets
// stuck on creases).
std::unique_ptr<PhysicsWorld> MakeOdeWorld(std::shared_ptr<const Scene> scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_
