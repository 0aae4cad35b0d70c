#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_

#include <chrono>
#include <memory>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// A PhysicsWorld on the Open Dynamics Engine: its bodies, joints and solver, with our own contacts
// against the ground grid and the assets near each body (ODE's height field is slower and gets
// stuck on creases).
// threads: that step it where enough bodies move, 0: as many as cores; motions do not depend on it.
std::unique_ptr<PhysicsWorld> MakeOdeWorld(std::shared_ptr<const Scene> scene, int threads = 1);

// How long the last step of a world that MakeOdeWorld made looked for contacts, all threads taken
// together; 0 for another. Steps are timed from the first time on that this is asked.
std::chrono::nanoseconds CollisionTime(const PhysicsWorld& world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_WORLD_H_
