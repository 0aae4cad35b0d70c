#ifndef LATTICEWORLD_ROS_SERVER_LOCKSTEP_REQUEST_H_
#define LATTICEWORLD_ROS_SERVER_LOCKSTEP_REQUEST_H_

#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/conversion/lockstep_messages.h"

namespace latticeworld {

// What a lockstep call tells agents, and whom it observes.
struct LockstepCommands {
  std::vector<std::pair<std::string, VelocityCommand>> velocities;  // as given
  std::vector<std::string> strikes;                                 // as given
  std::vector<std::string> observed;  // everybody who is named, each once, sorted
};
LockstepCommands ToLockstepCommands(const latticeworld_msgs::Lockstep::Request& request);

// Whether the simulator would accept all of it in that state; it is not asked. Every agent that is
// named has to be there. Errors: of one thing that is wrong its own code (NOT_FOUND,
// FAILED_PRECONDITION, INVALID_ARGUMENT), of several INVALID_ARGUMENT, with all of them.
Status CheckCommands(const LockstepCommands& commands, const WorldState& state,
                     const SpeciesCatalogue& catalogue);

// CheckCommands, then the calls of the simulator: all or nothing.
Status ApplyCommands(const LockstepCommands& commands, Simulator* simulator);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_LOCKSTEP_REQUEST_H_
