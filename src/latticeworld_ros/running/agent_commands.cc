#include "latticeworld_ros/running/agent_commands.h"

#include <ros/console.h>

#include <utility>

namespace latticeworld {
namespace {

// Each kind of command has its own line in the log at most once a second.
void LogVelocity(const std::string& agent, const Status& status) {
  if (status.ok()) return;
  ROS_WARN_STREAM_THROTTLE(1.0, "cmd_vel of " << agent << ": " << status.ToString());
}
void LogJoints(const std::string& agent, const Status& status) {
  if (status.ok()) return;
  ROS_WARN_STREAM_THROTTLE(1.0, "joint_command of " << agent << ": " << status.ToString());
}
void LogStrike(const std::string& agent, const Status& status) {
  if (status.ok()) return;
  ROS_WARN_STREAM_THROTTLE(1.0, "strike of " << agent << ": " << status.ToString());
}

}  // namespace

bool AgentCommands::Velocity(const std::string& agent, const VelocityCommand& command) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool first = waiting_.empty();
  waiting_[agent].velocity = command;
  return first;
}

bool AgentCommands::Joints(const std::string& agent, std::vector<JointCommand> commands) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool first = waiting_.empty();
  waiting_[agent].joints = std::move(commands);
  return first;
}

bool AgentCommands::Strike(const std::string& agent) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool first = waiting_.empty();
  waiting_[agent].strike = true;
  return first;
}

void AgentCommands::Apply(Simulator* simulator) {
  std::map<std::string, Waiting> waiting;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting.swap(waiting_);
  }
  if (simulator == nullptr) return;
  for (const auto& [agent, commands] : waiting) {
    if (commands.velocity) LogVelocity(agent, simulator->Command(agent, *commands.velocity));
    if (commands.joints) LogJoints(agent, simulator->CommandJoints(agent, *commands.joints));
    if (commands.strike) LogStrike(agent, simulator->Strike(agent));
  }
}

}  // namespace latticeworld
