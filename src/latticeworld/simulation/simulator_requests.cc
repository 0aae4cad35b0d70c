#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/common/request_fields.h"
#include "latticeworld/common/text.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/simulation/agent_names.h"
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
  violations->push_back(
      {"out_of_range", "team",
       given + " is no team; legal is 1 .. " + std::to_string(kMaxTeam) + ", or neutral", given});
}

void CheckPolicy(const std::string& policy, std::vector<Violation>* violations) {
  if (policy.empty() || FindPolicy(policy) != nullptr) return;
  RefuseUnknown("policy", policy, Join(PolicyNames(), ", "), violations);
}

// The species that is asked for, and whether it can be in the state that is asked for.
void CheckKind(const SpawnRequest& request, const SpeciesCatalogue& catalogue,
               std::vector<Violation>* violations) {
  const Species* species =
      request.species.empty() ? &catalogue.Of(request.category) : catalogue.Find(request.species);
  if (species == nullptr) {
    std::vector<std::string> names;
    for (const Species& one : catalogue.all()) names.push_back(one.name);
    return RefuseUnknown("species", request.species, Join(names, ", "), violations);
  }
  if (!request.state.has_value() || CanBe(species->category, *request.state)) return;
  std::vector<std::string> legal;
  for (const auto& [state, name] : EnumNames(AgentState{})) {
    if (CanBe(species->category, state)) legal.emplace_back(name);
  }
  const std::string given(NameOf(*request.state));
  violations->push_back(
      {"wrong_combination", "state",
       "a " + species->name + " cannot be " + given + "; legal are " + Join(legal, ", "), given});
}

}  // namespace

std::vector<Violation> Validate(const SpawnRequest& request, const SpeciesCatalogue& species) {
  std::vector<Violation> violations;
  if (!request.name.empty()) CheckAgentName(request.name, &violations);
  CheckKind(request, species, &violations);
  if (request.position.has_value()) {
    CheckFinite("position.x", request.position->x_m, &violations);
    CheckFinite("position.y", request.position->y_m, &violations);
  }
  CheckFinite("heading", request.heading_rad, &violations);
  CheckTeam(request.team, &violations);
  CheckPolicy(request.policy, &violations);
  if (request.controllable && !request.policy.empty()) {
    violations.push_back({"wrong_combination", "policy",
                          Quote(request.policy) +
                              " is given to a controllable agent; legal is none, for such an agent "
                              "follows its own commands",
                          Quote(request.policy)});
  }
  return violations;
}

std::vector<Violation> ValidateSpawn(const Prop& prop) {
  std::vector<Violation> violations;
  if (!prop.name.empty()) CheckAgentName(prop.name, &violations);
  for (Violation& violation : Validate(prop)) violations.push_back(std::move(violation));
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
