#include "latticeworld_ros/server/lockstep_request.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/conversion/agent_conversion.h"

namespace latticeworld {
namespace {

constexpr char kExternalPolicy[] = "external";

const AgentSnapshot* FindAgent(const WorldState& state, const std::string& name) {
  const auto found = std::lower_bound(
      state.agents.begin(), state.agents.end(), name,
      [](const AgentSnapshot& agent, const std::string& wanted) { return agent.name < wanted; });
  return found != state.agents.end() && found->name == name ? &*found : nullptr;
}

// Gathers what is wrong.
class Complaints {
 public:
  Complaints(const WorldState& state, const SpeciesCatalogue& catalogue)
      : state_(state), catalogue_(catalogue) {}

  const AgentSnapshot* CheckAgent(const std::string& where, const std::string& name) {
    const AgentSnapshot* agent = FindAgent(state_, name);
    if (agent == nullptr) Add(where, StatusCode::kNotFound, "there is no agent " + Quote(name));
    return agent;
  }
  const AgentSnapshot* CheckCommandable(const std::string& where, const std::string& name) {
    const AgentSnapshot* agent = CheckAgent(where, name);
    if (agent == nullptr || agent->controllable || agent->policy == kExternalPolicy) return agent;
    Add(where, StatusCode::kFailedPrecondition,
        Quote(name) +
            " acts by itself: legal are controllable agents and those of the "
            "policy " +
            Quote(kExternalPolicy) + ", not " + Quote(agent->policy));
    return nullptr;
  }
  void CheckVelocity(const std::string& where, const VelocityCommand& velocity) {
    if (velocity.linear_mps.allFinite() && std::isfinite(velocity.yaw_rate_radps)) return;
    Add(where, StatusCode::kInvalidArgument,
        "a velocity must be finite, not (" + FormatDouble(velocity.linear_mps.x()) + ", " +
            FormatDouble(velocity.linear_mps.y()) + ", " + FormatDouble(velocity.linear_mps.z()) +
            ") m/s and " + FormatDouble(velocity.yaw_rate_radps) + " rad/s");
  }
  void CheckStrike(const std::string& where, const std::string& name) {
    const AgentSnapshot* agent = CheckCommandable(where, name);
    if (agent == nullptr) return;
    const Species* species = catalogue_.Find(agent->species);
    if (species == nullptr || species->attack_reach_m <= 0.0) {
      Add(where, StatusCode::kFailedPrecondition, "a " + agent->species + " cannot strike");
    } else if (agent->behaviour == Behaviour::kDead) {
      Add(where, StatusCode::kFailedPrecondition, Quote(name) + " is dead");
    }
  }
  void CheckOnce(const std::string& where, const std::string& name, std::set<std::string>* names) {
    if (names->insert(name).second) return;
    Add(where, StatusCode::kInvalidArgument, Quote(name) + " is named twice");
  }

  Status Take() const {
    if (found_.empty()) return Status();
    if (found_.size() == 1) return found_.front();
    std::string all = std::to_string(found_.size()) + " things are wrong";
    for (std::size_t i = 0; i < std::min(found_.size(), kMostTold); ++i) {
      all += "; " + found_[i].message();
    }
    if (found_.size() > kMostTold) all += "; ...";
    return InvalidArgument(all);
  }

 private:
  static constexpr std::size_t kMostTold = 20;

  void Add(const std::string& where, StatusCode code, const std::string& what) {
    found_.push_back(Status(code, where + ": " + what));
  }

  const WorldState& state_;
  const SpeciesCatalogue& catalogue_;
  std::vector<Status> found_;
};

std::string At(std::string_view list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

}  // namespace

LockstepCommands ToLockstepCommands(const latticeworld_msgs::Lockstep::Request& request) {
  LockstepCommands commands;
  std::set<std::string> named(request.observe.begin(), request.observe.end());
  for (const latticeworld_msgs::AgentCommand& command : request.commands) {
    commands.velocities.emplace_back(command.agent, ToVelocityCommand(command.velocity));
    named.insert(command.agent);
  }
  commands.strikes = {request.strikes.begin(), request.strikes.end()};
  named.insert(request.strikes.begin(), request.strikes.end());
  commands.observed = {named.begin(), named.end()};
  return commands;
}

Status CheckCommands(const LockstepCommands& commands, const WorldState& state,
                     const SpeciesCatalogue& catalogue) {
  Complaints complaints(state, catalogue);
  std::set<std::string> commanded, striking;
  for (std::size_t i = 0; i < commands.velocities.size(); ++i) {
    const auto& [agent, velocity] = commands.velocities[i];
    const std::string where = At("commands", i);
    complaints.CheckOnce(where, agent, &commanded);
    (void)complaints.CheckCommandable(where, agent);
    complaints.CheckVelocity(where, velocity);
  }
  for (std::size_t i = 0; i < commands.strikes.size(); ++i) {
    complaints.CheckOnce(At("strikes", i), commands.strikes[i], &striking);
    complaints.CheckStrike(At("strikes", i), commands.strikes[i]);
  }
  for (const std::string& agent : commands.observed) {
    if (commanded.count(agent) == 0 && striking.count(agent) == 0) {
      (void)complaints.CheckAgent("observe", agent);
    }
  }
  return complaints.Take();
}

Status ApplyCommands(const LockstepCommands& commands, Simulator* simulator) {
  LW_RETURN_IF_ERROR(CheckCommands(commands, *simulator->State(), *simulator->options().species));
  for (const auto& [agent, velocity] : commands.velocities) {
    LW_RETURN_IF_ERROR(simulator->Command(agent, velocity));
  }
  for (const std::string& agent : commands.strikes) {
    LW_RETURN_IF_ERROR(simulator->Strike(agent));
  }
  return Status();
}

}  // namespace latticeworld
