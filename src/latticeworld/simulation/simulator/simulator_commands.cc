#include <cmath>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/simulation/agents/minds/policy.h"
#include "latticeworld/simulation/simulator/simulator_impl.h"

namespace latticeworld {
namespace {

constexpr std::string_view kExternal = "external";

// The joint that a command is for, and what it asks of it.
Result<std::pair<std::size_t, JointTarget>> TargetOf(const JointCommand& command,
                                                     const std::vector<JointName>& joints) {
  std::size_t joint = 0;
  while (joint < joints.size() && joints[joint].name != command.joint) ++joint;
  if (joint == joints.size()) {
    std::vector<std::string> names;
    for (const JointName& one : joints) names.push_back(one.name);
    return NotFound("there is no joint " + Quote(command.joint) + ": there are " +
                    Join(names, ", "));
  }
  const std::pair<JointMode, double> given[] = {{JointMode::kPosition, command.position_rad},
                                                {JointMode::kVelocity, command.velocity_radps},
                                                {JointMode::kEffort, command.effort_nm}};
  JointTarget target;
  int finite = 0, missing = 0;
  for (const auto& [mode, value] : given) {
    if (std::isnan(value)) ++missing;
    if (!std::isfinite(value)) continue;
    ++finite;
    target = {mode, value};
  }
  if (finite != 1 || missing != 2) {
    return InvalidArgument("joint " + Quote(command.joint) +
                           " takes exactly one finite value of position, velocity and effort and "
                           "NaN for the others, not (" +
                           FormatDouble(command.position_rad) + ", " +
                           FormatDouble(command.velocity_radps) + ", " +
                           FormatDouble(command.effort_nm) + ")");
  }
  const JointName::Kind kind = joints[joint].kind;
  if (kind == JointName::Kind::kWheel && target.mode != JointMode::kVelocity) {
    return InvalidArgument("the wheel " + Quote(command.joint) + " takes a velocity only");
  }
  if (kind == JointName::Kind::kSteering && target.mode != JointMode::kPosition) {
    return InvalidArgument("the steering " + Quote(command.joint) + " takes a position only");
  }
  return std::make_pair(joint, target);
}

}  // namespace

Result<Agent*> SimulatorImpl::FindAgent(const std::string& name) {
  const auto found = ids_.find(name);
  if (found != ids_.end()) return &agents_.at(found->second);
  return NoneNamed("agent", name, ids_);
}

Result<Agent*> SimulatorImpl::FindCommandable(const std::string& name) {
  Result<Agent*> agent = FindAgent(name);
  if (!agent.ok() || (*agent)->controllable || IsExternal(**agent)) return agent;
  return FailedPrecondition(Quote(name) +
                            " acts by itself: commands are for controllable agents and those of "
                            "the policy \"external\", not \"" +
                            PolicyOf(**agent) + "\"");
}

const std::string& SimulatorImpl::PolicyAsTold(const Agent& agent) const {
  if (!agent.policy.empty()) return agent.policy;
  const auto of_team = team_policies_.find(agent.team);
  return of_team == team_policies_.end() ? agent.policy : of_team->second;
}

bool SimulatorImpl::IsExternal(const Agent& agent) const {
  return !agent.controllable && PolicyAsTold(agent) == kExternal;
}

std::string SimulatorImpl::PolicyOf(const Agent& agent) const {
  if (agent.controllable) return "";
  const std::string& told = PolicyAsTold(agent);
  return told.empty() ? UsualPolicy(agent.species->category, agent.state) : told;
}

Status SimulatorImpl::Command(const std::string& name, const VelocityCommand& command) {
  const Result<Agent*> found = FindCommandable(name);
  if (!found.ok()) return found.status();
  if (!command.linear_mps.allFinite() || !std::isfinite(command.yaw_rate_radps)) {
    return InvalidArgument(
        "a velocity command must be finite, not (" + FormatDouble(command.linear_mps.x()) + ", " +
        FormatDouble(command.linear_mps.y()) + ", " + FormatDouble(command.linear_mps.z()) +
        ") m/s and " + FormatDouble(command.yaw_rate_radps) + " rad/s");
  }
  Agent& agent = **found;
  agent.command = ClampToLimits(*agent.species, command);
  agent.command_until = World().In(options_.command_timeout_s) + 1;
  return Status();
}

Status SimulatorImpl::CommandJoints(const std::string& name,
                                    const std::vector<JointCommand>& commands) {
  const Result<Agent*> found = FindCommandable(name);
  if (!found.ok()) return found.status();
  Agent& agent = **found;
  const std::vector<JointName>& joints = JointsOfSpecies(*agent.species);
  if (joints.empty()) {
    return NotFound(Quote(name) + " has no joints: a " + agent.species->name + " has none");
  }
  std::map<std::size_t, JointTarget> targets;
  for (const JointCommand& command : commands) {
    const auto target = TargetOf(command, joints);
    if (!target.ok()) return target.status().WithContext(name);
    if (!targets.insert(*target).second) {
      return InvalidArgument("joint " + Quote(command.joint) + " is commanded twice");
    }
  }
  agent.joint_targets = std::move(targets);
  agent.joints_until = World().In(options_.command_timeout_s) + 1;
  return Status();
}

Status SimulatorImpl::Strike(const std::string& name) {
  const Result<Agent*> found = FindCommandable(name);
  if (!found.ok()) return found.status();
  Agent& agent = **found;
  if (agent.species->attack_reach_m <= 0.0) {
    return FailedPrecondition("a " + agent.species->name + " cannot strike");
  }
  if (!agent.alive()) return FailedPrecondition(Quote(name) + " is dead");
  agent.strike_wanted = true;
  return Status();
}

Status SimulatorImpl::SetPolicy(const PolicyChange& change) {
  LW_RETURN_IF_ERROR(Status::FromViolations("policy", Validate(change)));
  // What the policy before had in mind is over; what was perceived stays.
  const auto begin_anew = [](Agent* agent) {
    Mind& mind = agent->mind;
    mind.goal.reset();
    mind.hide.reset();
    mind.path = {};
    mind.target = 0;
    mind.pause_until = mind.searched_until = mind.alarmed_until = mind.closes_at = 0;
    agent->command.reset();
    agent->joint_targets.clear();
    agent->strike_wanted = false;
  };
  if (!change.team.has_value()) {
    const Result<Agent*> found = FindAgent(change.agent);
    if (!found.ok()) return found.status();
    Agent& agent = **found;
    if (agent.controllable && !change.policy.empty()) {
      return FailedPrecondition(Quote(change.agent) +
                                " is controllable: it follows its own commands and no policy");
    }
    if (agent.policy == change.policy) return Status();
    agent.policy = change.policy;
    begin_anew(&agent);
  } else {
    const auto before = team_policies_.find(*change.team);
    if ((before == team_policies_.end() ? "" : before->second) == change.policy) return Status();
    if (change.policy.empty()) {
      team_policies_.erase(*change.team);
    } else {
      team_policies_[*change.team] = change.policy;
    }
    for (auto& [id, agent] : agents_) {
      if (agent.team == *change.team && agent.policy.empty() && !agent.controllable) {
        begin_anew(&agent);
      }
    }
  }
  state_.reset();
  return Status();
}

Status SimulatorImpl::SetWeather(const WeatherChange& change) {
  LW_RETURN_IF_ERROR(Status::FromViolations("weather", Validate(change)));
  if (IsEmpty(change)) return Status();
  weather_->Change(change);
  const std::string name(NameOf(weather_->target().weather));
  TellWeather(weather_->moving() ? name + " begins" : name);
  WeatherGround();
  state_.reset();
  return Status();
}

}  // namespace latticeworld
