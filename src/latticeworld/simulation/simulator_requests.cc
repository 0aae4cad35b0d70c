#include <cmath>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/simulation/agents/minds/policy.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {
namespace {

void CheckFinite(const char* pointer, double value, std::vector<Violation>* violations) {
  if (std::isfinite(value)) return;
  const std::string given = FormatDouble(value);
  violations->push_back({"out_of_range", pointer, given + " is not finite", given});
}

void CheckTeam(const std::optional<int>& team, std::vector<Violation>* violations) {
  if (!team.has_value() || (*team >= 0 && *team <= kMaxTeam)) return;
  const std::string given = std::to_string(*team);
  violations->push_back({"out_of_range", "team",
                         given + " is not legal; legal is 0 .. " + std::to_string(kMaxTeam),
                         given});
}

}  // namespace

void CheckPolicy(const std::string& policy, std::vector<Violation>* violations) {
  if (policy.empty() || FindPolicy(policy) != nullptr) return;
  violations->push_back({"unknown_value", "policy",
                         Quote(policy) + " is unknown; legal are " + Join(PolicyNames(), ", "),
                         Quote(policy)});
}

std::vector<Violation> Validate(const SpawnRequest& request) {
  std::vector<Violation> violations;
  if (request.position.has_value()) {
    CheckFinite("position.x", request.position->x_m, &violations);
    CheckFinite("position.y", request.position->y_m, &violations);
  }
  CheckFinite("heading", request.heading_rad, &violations);
  CheckTeam(request.team, &violations);
  CheckPolicy(request.policy, &violations);
  return violations;
}

std::vector<Violation> Validate(const PolicyChange& change) {
  std::vector<Violation> violations;
  if (change.agent.empty() != change.team.has_value()) {
    violations.push_back({"wrong_combination", "agent",
                          change.agent.empty() ? "neither agent nor team is given; give one"
                                               : "agent and team are given; give one",
                          Quote(change.agent)});
  }
  CheckTeam(change.team, &violations);
  CheckPolicy(change.policy, &violations);
  return violations;
}

}  // namespace latticeworld
