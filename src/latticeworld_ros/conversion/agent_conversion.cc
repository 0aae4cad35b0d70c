#include "latticeworld_ros/conversion/agent_conversion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "latticeworld/common/request_fields.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

std::string BaseFrame(const std::string& agent) { return agent + "/base_link"; }
std::string OdomFrame(const std::string& agent) { return agent + "/odom"; }

Eigen::Isometry3d PoseOf(const AgentSnapshot& agent) {
  return ToIsometry(agent.position_m, agent.orientation);
}

geometry_msgs::Twist TwistOf(const AgentSnapshot& agent) {
  geometry_msgs::Twist twist;
  twist.linear = ToVector3(agent.linear_velocity_mps);
  twist.angular = ToVector3(agent.angular_velocity_radps);
  return twist;
}

latticeworld_msgs::AgentState ToAgentStateMessage(const AgentSnapshot& agent) {
  latticeworld_msgs::AgentState message;
  message.name = agent.name;
  message.species = agent.species;
  message.team = agent.team;
  message.behaviour = std::string(NameOf(agent.behaviour));
  message.policy = agent.policy;
  message.health = agent.health;
  message.controllable = agent.controllable;
  message.pose.position = ToPoint(agent.position_m);
  message.pose.orientation = ToQuaternion(agent.orientation);
  message.twist = TwistOf(agent);
  return message;
}

latticeworld_msgs::AgentStates ToAgentStates(const WorldState& state, ros::Time stamp,
                                             const std::string& world_id) {
  latticeworld_msgs::AgentStates message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.step = state.step;
  message.episode_step = state.episode_step;
  message.episode_time = state.episode_time_s;
  message.agents.reserve(state.agents.size());
  for (const AgentSnapshot& agent : state.agents)
    message.agents.push_back(ToAgentStateMessage(agent));
  return message;
}

latticeworld_msgs::AgentEvent ToAgentEvent(const Event& event, ros::Time stamp,
                                           const std::string& world_id) {
  latticeworld_msgs::AgentEvent message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.step = event.step;
  message.kind = std::string(NameOf(event.kind));
  message.agent = event.agent;
  message.other = event.other;
  message.position = ToPoint(event.position_m);
  return message;
}

Eigen::Isometry3d LevelFrameAt(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d forward = pose.linear().col(0);
  const Eigen::Vector3d left = pose.linear().col(1);
  // If the robot looks straight up or down, what is to its left says the yaw.
  const bool steep = forward.head<2>().norm() < 1e-3;
  const double yaw_rad =
      steep ? std::atan2(-left.x(), left.y()) : std::atan2(forward.y(), forward.x());
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = pose.translation();
  frame.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return frame;
}

nav_msgs::Odometry ToOdometry(const AgentSnapshot& agent, ros::Time stamp, const std::string& frame,
                              const Eigen::Isometry3d& frame_from_map) {
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = frame;
  message.child_frame_id = BaseFrame(agent.name);
  message.pose.pose = ToPose(frame_from_map * PoseOf(agent));
  message.twist.twist = TwistOf(agent);
  // True to a millimetre and a milliradian; filters refuse or divide by a variance of 0.
  constexpr double kExact = 1e-6;
  for (std::size_t i = 0; i < 36; i += 7) {
    message.pose.covariance[i] = kExact;
    message.twist.covariance[i] = kExact;
  }
  return message;
}

VelocityCommand ToVelocityCommand(const geometry_msgs::Twist& twist) {
  VelocityCommand command;
  command.linear_mps = FromVector(twist.linear);
  command.yaw_rate_radps = twist.angular.z;
  return command;
}

sensor_msgs::JointState ToJointState(const AgentSnapshot& agent, ros::Time stamp) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  for (const JointSnapshot& joint : agent.joints) {
    message.name.push_back(joint.name);
    message.position.push_back(joint.angle_rad);
    message.velocity.push_back(joint.rate_radps);
    message.effort.push_back(joint.effort_nm);
  }
  return message;
}

Result<std::vector<JointCommand>> ToJointCommands(const sensor_msgs::JointState& message) {
  std::vector<Violation> violations;
  const auto refuse = [&](const char* field, std::size_t given, const std::string& legal) {
    violations.push_back({"wrong_size", field,
                          "has " + std::to_string(given) + " entries; legal are " + legal,
                          std::to_string(given)});
  };
  const std::size_t count = message.name.size();
  if (count > kMaxCommandedJoints) {
    refuse("name", count, "0 .. " + std::to_string(kMaxCommandedJoints));
  }
  for (const auto& [field, given] : {std::pair("position", message.position.size()),
                                     std::pair("velocity", message.velocity.size()),
                                     std::pair("effort", message.effort.size())}) {
    if (given != 0 && given != count) refuse(field, given, "0 or as many as names");
  }
  if (!violations.empty()) return Status::FromViolations("joint_command", std::move(violations));

  const auto at = [](const std::vector<double>& values, std::size_t i) {
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[i];
  };
  std::vector<JointCommand> commands;
  for (std::size_t i = 0; i < count; ++i) {
    commands.push_back(
        {message.name[i], at(message.position, i), at(message.velocity, i), at(message.effort, i)});
  }
  return commands;
}

Result<SpawnRequest> ToSpawnRequest(const latticeworld_msgs::SpawnAgent::Request& request,
                                    const SimulatorOptions& options) {
  std::vector<Violation> violations;
  SpawnRequest spawn;
  spawn.name = request.name;
  spawn.species = request.species.empty() ? options.robot_species : request.species;
  if (const Species* species = options.species->Find(spawn.species)) {
    spawn.species = species->name;
    spawn.category = species->category;
  }
  if (!request.state.empty()) {
    spawn.state = ReadName<AgentState>("state", request.state, &violations);
  }
  if (!request.place.empty()) {
    spawn.region =
        ReadName<Region>("place", request.place, &violations).value_or(Region::kAnywhere);
  } else {
    spawn.position = WorldPoint{request.position.x, request.position.y};
  }
  spawn.heading_rad = request.heading;
  spawn.controllable = request.controllable;
  constexpr int kNeutral = -1, kNeutralOfSimulator = 0;
  if (request.team != 0) {
    spawn.team = request.team == kNeutral ? kNeutralOfSimulator : request.team;
  }
  spawn.policy = request.policy;
  if (violations.empty()) return spawn;
  return RefuseUnread("spawn", std::move(violations), Validate(spawn, *options.species));
}

PolicyChange ToPolicyChange(const latticeworld_msgs::SetPolicy::Request& request) {
  PolicyChange change;
  change.agent = request.agent;
  if (request.team != 0) change.team = request.team;
  change.policy = request.policy;
  return change;
}

std::vector<std::string> SpeciesNames(const SpeciesCatalogue& catalogue) {
  std::vector<std::string> names;
  for (const Species& species : catalogue.all()) names.push_back(species.name);
  return names;
}

}  // namespace latticeworld
