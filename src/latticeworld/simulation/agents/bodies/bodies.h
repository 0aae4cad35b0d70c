#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_BODIES_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_BODIES_H_

#include <string>
#include <vector>

#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// The body of a species.
BodySpec BodyOf(const Species& species);

// What users call its joints, in the order of JointId: wheels first (one joint a driven or free
// wheel, and one a steered wheel's steering), then links.
struct JointName {
  std::string name;  // "front_left_wheel", "front_left_steering", "rear_right_knee"
  enum class Kind { kWheel, kSteering, kLink } kind = Kind::kWheel;
  std::size_t index = 0;  // of the wheel or link in the BodySpec
};
std::vector<JointName> JointsOf(const Species& species);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_BODIES_H_
