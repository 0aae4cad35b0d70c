#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COMMANDS_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COMMANDS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/agent_roster.h"
#include "latticeworld/simulation/simulator/team_policies.h"

namespace latticeworld {

// What somebody outside may tell an agent to do. Nothing changes where the answer is an error.

// The agent of that name. Errors: NOT_FOUND, and FAILED_PRECONDITION for one that nobody outside
// may command.
Result<Agent*> FindCommandable(const std::string& name, const TeamPolicies& policies,
                               AgentRoster* agents);
// The agent moves as the command says, within the limits of its species, until that step of the
// episode. Errors: INVALID_ARGUMENT (not finite).
Status SetVelocity(const VelocityCommand& command, std::uint64_t until, Agent* agent);
// The same for some of its joints. joints: those of its species. Errors: NOT_FOUND (no such joint,
// or none at all), INVALID_ARGUMENT (not exactly one finite value, a joint twice).
Status SetJoints(const std::vector<JointCommand>& commands, const std::vector<JointName>& joints,
                 std::uint64_t until, Agent* agent);
// The agent strikes as soon as it can. Errors: FAILED_PRECONDITION (cannot strike, or dead).
Status OrderStrike(Agent* agent);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_AGENT_COMMANDS_H_
