#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_STATE_MAKING_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_STATE_MAKING_H_

#include <memory>

#include "latticeworld/simulation/simulator/joint_names.h"
#include "latticeworld/simulation/simulator/running_world.h"
#include "latticeworld/simulation/simulator/team_policies.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

// The state of a world as callers see it.
std::shared_ptr<const WorldState> StateOf(const RunningWorld& world, const TeamPolicies& policies,
                                          const JointNames& joints);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_STATE_MAKING_H_
