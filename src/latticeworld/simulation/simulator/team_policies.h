#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_TEAM_POLICIES_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_TEAM_POLICIES_H_

#include <map>
#include <string>

#include "latticeworld/common/status.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/agent_roster.h"

namespace latticeworld {

// Which policy each agent follows: its own, else its team's, else what is usual for its category.
// Plain data, to copy into a snapshot.
class TeamPolicies {
 public:
  // The one that it follows; "": it obeys commands.
  std::string PolicyOf(const Agent& agent) const;
  // Whether somebody outside decides for it: it is told to follow "external".
  bool IsExternal(const Agent& agent) const;

  // An agent or a team follows another policy from now on, and forgets what it had in mind. Errors:
  // see Simulator::SetPolicy; nothing changes then.
  Status Set(const PolicyChange& change, AgentRoster* agents);
  void AddTo(Digest* digest) const;

 private:
  Status SetOfAgent(const PolicyChange& change, AgentRoster* agents) const;
  void SetOfTeam(int team, const std::string& policy, AgentRoster* agents);
  // Its own policy or its team's; "": neither.
  const std::string& PolicyAsTold(const Agent& agent) const;

  std::map<int, std::string> of_team_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_TEAM_POLICIES_H_
