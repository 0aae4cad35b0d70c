#include "latticeworld/simulation/simulator/agent_commands.h"

#include <cmath>
#include <map>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/simulation/agents/bodies/locomotion.h"

namespace latticeworld {
namespace {

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
  std::map<std::size_t, JointTarget> targets;
  for (const JointCommand& command : commands) {
    const auto target = TargetOf(command, joints);
    if (!target.ok()) return target.status().WithContext(agent->name);
    if (!targets.insert(*target).second) {
      return InvalidArgument("joint " + Quote(command.joint) + " is commanded twice");
    }
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
