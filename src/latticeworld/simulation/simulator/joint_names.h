#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_JOINT_NAMES_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_JOINT_NAMES_H_

#include <map>
#include <vector>

#include "latticeworld/simulation/agents/bodies/bodies.h"

namespace latticeworld {

// The joints of every species that was asked for so far. Not thread safe, const or not.
class JointNames {
 public:
  // species: outlives this.
  const std::vector<JointName>& Of(const Species& species) const {
    const auto found = of_.find(&species);
    if (found != of_.end()) return found->second;
    return of_.emplace(&species, JointsOf(species)).first->second;
  }

 private:
  mutable std::map<const Species*, std::vector<JointName>> of_;  // never walked
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_JOINT_NAMES_H_
