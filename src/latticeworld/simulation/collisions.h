#ifndef LATTICEWORLD_SIMULATION_COLLISIONS_H_
#define LATTICEWORLD_SIMULATION_COLLISIONS_H_

#include <vector>

#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// Two that met in a step, by where they met fastest.
struct Impact {
  Contact contact;  // of kAsset, kBody or kBoundary
  // What a plastic collision, after which both go on together, exerts on each: m1 m2 / (m1 + m2)
  // times the speed at which they met, or m1 times it against what is held [N s]. From the speeds
  // and not from the contact's force, which a solver spreads over several steps.
  double impulse_ns = 0.0;
};

// The collisions among a step's contacts, one for each two that met, in the order in which they
// were found: those that met at 0.5 m/s or faster and did push each other.
std::vector<Impact> ImpactsOf(const std::vector<Contact>& contacts, const PhysicsWorld& physics);

// Hit points that a change of its speed in a collision takes from a body of the species: none
// below 3 m/s, all of them from 18 m/s on, and a share that grows evenly between. A rule of
// the game, not a measurement: 3 m/s is a fall from half a metre.
double CollisionDamage(const Species& species, double speed_change_mps);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_COLLISIONS_H_
