#ifndef LATTICEWORLD_ROS_CONVERSION_AGENT_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_AGENT_CONVERSION_H_

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/JointState.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// Frames of an agent: <name>/base_link, and of a controllable one <name>/odom.
std::string BaseFrame(const std::string& agent);
std::string OdomFrame(const std::string& agent);

// map_from_base of an agent.
Eigen::Isometry3d PoseOf(const AgentSnapshot& agent);
// A frame at a pose's place with its yaw, whose z axis points up: where odometry begins. Clients
// take the z axis of odom for up, and a frame as tilted as the ground was there would lead them
// astray.
Eigen::Isometry3d LevelFrameAt(const Eigen::Isometry3d& pose);

geometry_msgs::Twist TwistOf(const AgentSnapshot& agent);
latticeworld_msgs::AgentState ToAgentStateMessage(const AgentSnapshot& agent);
latticeworld_msgs::AgentStates ToAgentStates(const WorldState& state, ros::Time stamp,
                                             const std::string& world_id);
latticeworld_msgs::AgentEvent ToAgentEvent(const Event& event, ros::Time stamp,
                                           const std::string& world_id);

// Odometry without noise: pose of base_link in `frame`, twist in base_link. frame_from_map: where
// the map lies in that frame; the identity for ground truth.
nav_msgs::Odometry ToOdometry(const AgentSnapshot& agent, ros::Time stamp, const std::string& frame,
                              const Eigen::Isometry3d& frame_from_map);

// Angles, rates and torques of its joints, in their order.
sensor_msgs::JointState ToJointState(const AgentSnapshot& agent, ros::Time stamp);

// Velocities as they are; Simulator::Command refuses what is not finite.
VelocityCommand ToVelocityCommand(const geometry_msgs::Twist& twist);

// One command a named joint; an array is empty or has a number for each, NaN says nothing. No names
// at all hand every joint back. Errors: INVALID_ARGUMENT with every violation (too many names, an
// array of another length).
Result<std::vector<JointCommand>> ToJointCommands(const sensor_msgs::JointState& message);
inline constexpr std::size_t kMaxCommandedJoints = 256;

// options: of the simulator, whose catalogue knows the species. What it says is for the simulator
// to judge. Errors: INVALID_ARGUMENT where state or place are no names of any; then with everything
// that Validate has against the rest.
Result<SpawnRequest> ToSpawnRequest(const latticeworld_msgs::SpawnAgent::Request& request,
                                    const SimulatorOptions& options);

PolicyChange ToPolicyChange(const latticeworld_msgs::SetPolicy::Request& request);

// "sheep, goblin, ...": what the catalogue has.
std::vector<std::string> SpeciesNames(const SpeciesCatalogue& catalogue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_AGENT_CONVERSION_H_
