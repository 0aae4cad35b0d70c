#ifndef LATTICEWORLD_SIMULATION_PROPS_BUMPS_H_
#define LATTICEWORLD_SIMULATION_PROPS_BUMPS_H_

#include <Eigen/Core>
#include <map>
#include <vector>

#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// What presses hardest on a body from the side or from above.
struct Bump {
  double force_n = 0.0;                               // across the surfaces that meet, > 0
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  // middle of where they meet, map frame
};

// The hardest bump of each body that has one. All contacts of a body with the same thing are one
// bump; the ground, the world's edge (whose forces are not measured) and what a body stands on are
// none.
std::map<BodyId, Bump> HardestBumps(const std::vector<Contact>& contacts);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PROPS_BUMPS_H_
