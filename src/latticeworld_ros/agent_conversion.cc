#include "latticeworld_ros/agent_conversion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

geometry_msgs::Point ToPoint(const Eigen::Vector3d& v) {
  geometry_msgs::Point point;
  point.x = v.x();
  point.y = v.y();
  point.z = v.z();
  return point;
}

geometry_msgs::Vector3 ToVector(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 vector;
  vector.x = v.x();
  vector.y = v.y();
  vector.z = v.z();
  return vector;
}

geometry_msgs::Quaternion ToQuaternion(const Eigen::Quaterniond& q) {
  geometry_msgs::Quaternion quaternion;
  quaternion.x = q.x();
  quaternion.y = q.y();
  quaternion.z = q.z();
  quaternion.w = q.w();
  return quaternion;
}

Eigen::Vector3d FromVector(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

// The enum value that a field names, with '_' for ' ' as well; a violation when there is none.
template <typename Enum>
std::optional<Enum> ParseName(const std::string& field, const std::string& given,
                              std::vector<Violation>* violations) {
  std::string name = given;
  std::replace(name.begin(), name.end(), '_', ' ');
  const std::optional<Enum> value = FromName<Enum>(name);
  if (!value) {
    violations->push_back({"unknown_value", field,
                           Quote(given) + " is unknown; legal are " + LegalNames<Enum>(),
                           Quote(given)});
  }
  return value;
}

}  // namespace

std::string BaseFrame(const std::string& agent) { return agent + "/base_link"; }
std::string OdomFrame(const std::string& agent) { return agent + "/odom"; }

Eigen::Isometry3d PoseOf(const AgentSnapshot& agent) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = agent.orientation.toRotationMatrix();
  pose.translation() = agent.position_m;
  return pose;
}

geometry_msgs::Pose ToRos(const Eigen::Isometry3d& pose) {
  geometry_msgs::Pose message;
  message.position = ToPoint(pose.translation());
  message.orientation = ToQuaternion(Eigen::Quaterniond(pose.linear()).normalized());
  return message;
}

geometry_msgs::Twist TwistOf(const AgentSnapshot& agent) {
  geometry_msgs::Twist twist;
  twist.linear = ToVector(agent.linear_velocity_mps);
  twist.angular = ToVector(agent.angular_velocity_radps);
  return twist;
}

geometry_msgs::TransformStamped ToRos(const Eigen::Isometry3d& parent_from_child, ros::Time stamp,
                                      const std::string& parent, const std::string& child) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation = ToVector(parent_from_child.translation());
  message.transform.rotation =
      ToQuaternion(Eigen::Quaterniond(parent_from_child.linear()).normalized());
  return message;
}

latticeworld_msgs::AgentState ToRos(const AgentSnapshot& agent) {
  latticeworld_msgs::AgentState message;
  message.name = agent.name;
  message.species = std::string(NameOf(agent.category));
  message.team = agent.team;
  message.behaviour = std::string(NameOf(agent.behaviour));
  message.health = agent.health;
  message.controllable = agent.controllable;
  message.pose.position = ToPoint(agent.position_m);
  message.pose.orientation = ToQuaternion(agent.orientation);
  message.twist = TwistOf(agent);
  return message;
}

latticeworld_msgs::AgentStates ToRos(const WorldState& state, ros::Time stamp,
                                     const std::string& world_id) {
  latticeworld_msgs::AgentStates message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.step = state.step;
  message.episode_step = state.episode_step;
  message.episode_time = state.episode_time_s;
  message.agents.reserve(state.agents.size());
  for (const AgentSnapshot& agent : state.agents) message.agents.push_back(ToRos(agent));
  return message;
}

latticeworld_msgs::AgentEvent ToRos(const Event& event, ros::Time stamp,
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

nav_msgs::Odometry ToOdometry(const AgentSnapshot& agent, ros::Time stamp, const std::string& frame,
                              const Eigen::Isometry3d& frame_from_map) {
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = frame;
  message.child_frame_id = BaseFrame(agent.name);
  message.pose.pose = ToRos(frame_from_map * PoseOf(agent));
  message.twist.twist = TwistOf(agent);
  return message;
}

VelocityCommand FromRos(const geometry_msgs::Twist& twist) {
  VelocityCommand command;
  command.linear_mps = FromVector(twist.linear);
  command.yaw_rate_radps = twist.angular.z;
  return command;
}

Result<SpawnRequest> FromRos(const latticeworld_msgs::SpawnAgent::Request& request) {
  std::vector<Violation> violations;
  SpawnRequest spawn;
  spawn.name = request.name;
  if (!request.species.empty()) {
    spawn.category = ParseName<AgentCategory>("species", request.species, &violations)
                         .value_or(AgentCategory::kWheeledRobot);
  }
  if (!request.state.empty()) {
    spawn.state = ParseName<AgentState>("state", request.state, &violations);
  }
  if (!request.place.empty()) {
    spawn.region =
        ParseName<Region>("place", request.place, &violations).value_or(Region::kAnywhere);
  } else {
    spawn.position = WorldPoint{request.position.x, request.position.y};
    for (const auto& [field, value] : {std::pair("position.x", request.position.x),
                                       std::pair("position.y", request.position.y)}) {
      if (std::isfinite(value)) continue;
      violations.push_back(
          {"out_of_range", field, FormatDouble(value) + " is not finite", FormatDouble(value)});
    }
  }
  if (!std::isfinite(request.heading)) {
    violations.push_back({"out_of_range", "heading",
                          FormatDouble(request.heading) + " is not finite",
                          FormatDouble(request.heading)});
  }
  spawn.heading_rad = request.heading;
  spawn.controllable = request.controllable;
  if (!violations.empty()) {
    return Status::FromViolations("spawn_agent", std::move(violations));
  }
  return spawn;
}

}  // namespace latticeworld
