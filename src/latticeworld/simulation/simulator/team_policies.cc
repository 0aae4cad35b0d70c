#include "latticeworld/simulation/simulator/team_policies.h"

#include <string_view>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/text.h"
#include "latticeworld/simulation/agents/minds/policy.h"

namespace latticeworld {
namespace {

constexpr std::string_view kExternal = "external";

// What the policy before had in mind is over; what was perceived stays.
void BeginAnew(Agent* agent) {
  Mind& mind = agent->mind;
  mind.goal.reset();
  mind.hide.reset();
  mind.path = {};
  mind.target = 0;
  mind.pause_until = mind.searched_until = mind.alarmed_until = mind.closes_at = 0;
  agent->command.reset();
  agent->joint_targets.clear();
  agent->strike_wanted = false;
}

}  // namespace

const std::string& TeamPolicies::PolicyAsTold(const Agent& agent) const {
  if (!agent.policy.empty()) return agent.policy;
  const auto of_team = of_team_.find(agent.team);
  return of_team == of_team_.end() ? agent.policy : of_team->second;
}

bool TeamPolicies::IsExternal(const Agent& agent) const {
  return !agent.controllable && PolicyAsTold(agent) == kExternal;
}

std::string TeamPolicies::PolicyOf(const Agent& agent) const {
  if (agent.controllable) return "";
  const std::string& told = PolicyAsTold(agent);
  return told.empty() ? UsualPolicy(agent.species->category, agent.state) : told;
}

Status TeamPolicies::Set(const PolicyChange& change, AgentRoster* agents) {
  LW_RETURN_IF_ERROR(Status::FromViolations("policy", Validate(change)));
  if (!change.team.has_value()) return SetOfAgent(change, agents);
  SetOfTeam(*change.team, change.policy, agents);
  return Status();
}

Status TeamPolicies::SetOfAgent(const PolicyChange& change, AgentRoster* agents) const {
  const Result<Agent*> found = agents->Find(change.agent);
  if (!found.ok()) return found.status();
  Agent& agent = **found;
  if (agent.controllable && !change.policy.empty()) {
    return FailedPrecondition(Quote(change.agent) +
                              " is controllable: it follows its own commands and no policy");
  }
  if (agent.policy == change.policy) return Status();
  agent.policy = change.policy;
  BeginAnew(&agent);
  return Status();
}

void TeamPolicies::SetOfTeam(int team, const std::string& policy, AgentRoster* agents) {
  const auto before = of_team_.find(team);
  if ((before == of_team_.end() ? "" : before->second) == policy) return;
  if (policy.empty()) {
    of_team_.erase(team);
  } else {
    of_team_[team] = policy;
  }
  for (auto& [id, agent] : agents->all()) {
    if (agent.team == team && agent.policy.empty() && !agent.controllable) BeginAnew(&agent);
  }
}

void TeamPolicies::AddTo(Digest* digest) const {
  digest->Add(static_cast<std::uint64_t>(of_team_.size()));
  for (const auto& [team, policy] : of_team_) {
    digest->Add(team);
    digest->AddText(policy);
  }
}

}  // namespace latticeworld
