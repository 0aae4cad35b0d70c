#include "latticeworld/simulation/simulator/agent_commands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/simulation/agents/bodies/locomotion.h"

namespace latticeworld {
namespace {

constexpr char kNoSuchJoint[] = "not_found";

// What a command asks of a joint of that kind; none: a violation was added.
std::optional<JointTarget> TargetOf(const JointCommand& command, JointName::Kind kind,
                                    std::vector<Violation>* violations) {
  const auto refuse = [&](const std::string& legal) {
    const std::string given = "(" + FormatDouble(command.position_rad) + ", " +
                              FormatDouble(command.velocity_radps) + ", " +
                              FormatDouble(command.effort_nm) + ")";
    violations->push_back({"illegal_value", "joint " + Quote(command.joint),
                           "takes " + legal + ", not " + given, given});
    return std::nullopt;
  };
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
    return refuse(
        "exactly one finite value of position, velocity and effort and NaN for the others");
  }
  if (kind == JointName::Kind::kWheel && target.mode != JointMode::kVelocity) {
    return refuse("a velocity only, for it is a wheel");
  }
  if (kind == JointName::Kind::kSteering && target.mode != JointMode::kPosition) {
    return refuse("a position only, for it steers");
  }
  return target;
}

// The joints that are commanded, by index; those of illegal commands are left out.
std::map<std::size_t, JointTarget> TargetsOf(const std::vector<JointCommand>& commands,
                                             const std::vector<JointName>& joints,
                                             std::vector<Violation>* violations) {
  std::map<std::size_t, JointTarget> targets;
  std::set<std::string> commanded;
  for (const JointCommand& command : commands) {
    const auto refuse = [&](const char* code, const std::string& message) {
      violations->push_back({code, "joint " + Quote(command.joint), message, Quote(command.joint)});
    };
    const auto joint = std::find_if(joints.begin(), joints.end(), [&](const JointName& one) {
      return one.name == command.joint;
    });
    if (joint == joints.end()) {
      std::vector<std::string> names;
      for (const JointName& one : joints) names.push_back(one.name);
      refuse(kNoSuchJoint, "is not there; there are " + Join(names, ", "));
      continue;
    }
    if (!commanded.insert(command.joint).second) {
      refuse("duplicate", "is commanded twice; legal is once");
      continue;
    }
    const std::optional<JointTarget> target = TargetOf(command, joint->kind, violations);
    if (target) targets.emplace(static_cast<std::size_t>(joint - joints.begin()), *target);
  }
  return targets;
}

}  // namespace

Result<Agent*> FindCommandable(const std::string& name, const TeamPolicies& policies,
                               AgentRoster* agents) {
  Result<Agent*> agent = agents->Find(name);
  if (!agent.ok() || (*agent)->controllable || policies.IsExternal(**agent)) return agent;
  return FailedPrecondition(Quote(name) +
                            " acts by itself: commands are for controllable agents and those of "
                            "the policy \"external\", not \"" +
                            policies.PolicyOf(**agent) + "\"");
}

Status SetVelocity(const VelocityCommand& command, std::uint64_t until, Agent* agent) {
  if (!command.linear_mps.allFinite() || !std::isfinite(command.yaw_rate_radps)) {
    return InvalidArgument(
        "a velocity command must be finite, not (" + FormatDouble(command.linear_mps.x()) + ", " +
        FormatDouble(command.linear_mps.y()) + ", " + FormatDouble(command.linear_mps.z()) +
        ") m/s and " + FormatDouble(command.yaw_rate_radps) + " rad/s");
  }
  agent->command = ClampToLimits(*agent->species, command);
  agent->command_until = until;
  return Status();
}

Status SetJoints(const std::vector<JointCommand>& commands, const std::vector<JointName>& joints,
                 std::uint64_t until, Agent* agent) {
  if (joints.empty()) {
    return NotFound(Quote(agent->name) + " has no joints: a " + agent->species->name + " has none");
  }
  std::vector<Violation> violations;
  std::map<std::size_t, JointTarget> targets = TargetsOf(commands, joints, &violations);
  if (!violations.empty()) {
    const bool absent = std::any_of(violations.begin(), violations.end(),
                                    [](const Violation& one) { return one.code == kNoSuchJoint; });
    const Status refused = Status::FromViolations(agent->name, std::move(violations));
    return Status(absent ? StatusCode::kNotFound : refused.code(), refused.message(),
                  refused.violations());
  }
  agent->joint_targets = std::move(targets);
  agent->joints_until = until;
  return Status();
}

Status OrderStrike(Agent* agent) {
  if (agent->species->attack_reach_m <= 0.0) {
    return FailedPrecondition("a " + agent->species->name + " cannot strike");
  }
  if (!agent->alive()) return FailedPrecondition(Quote(agent->name) + " is dead");
  agent->strike_wanted = true;
  return Status();
}

}  // namespace latticeworld
