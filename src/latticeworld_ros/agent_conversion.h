#ifndef LATTICEWORLD_ROS_AGENT_CONVERSION_H_
#define LATTICEWORLD_ROS_AGENT_CONVERSION_H_

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>

#include <Eigen/Geometry>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld_ros/messages.h"

namespace latticeworld {

inline constexpr char kMapFrame[] = "map";

// Frames of an agent: <name>/base_link, and of a controllable one <name>/odom.
std::string BaseFrame(const std::string& agent);
std::string OdomFrame(const std::string& agent);

// map_from_base of an agent.
Eigen::Isometry3d PoseOf(const AgentSnapshot& agent);

geometry_msgs::Pose ToRos(const Eigen::Isometry3d& pose);
geometry_msgs::Twist TwistOf(const AgentSnapshot& agent);
geometry_msgs::TransformStamped ToRos(const Eigen::Isometry3d& parent_from_child, ros::Time stamp,
                                      const std::string& parent, const std::string& child);
latticeworld_msgs::AgentState ToRos(const AgentSnapshot& agent);
latticeworld_msgs::AgentStates ToRos(const WorldState& state, ros::Time stamp,
                                     const std::string& world_id);
latticeworld_msgs::AgentEvent ToRos(const Event& event, ros::Time stamp,
                                    const std::string& world_id);

// Odometry without noise: pose of base_link in `frame`, twist in base_link. frame_from_map: where
// the map lies in that frame; the identity for ground truth.
nav_msgs::Odometry ToOdometry(const AgentSnapshot& agent, ros::Time stamp, const std::string& frame,
                              const Eigen::Isometry3d& frame_from_map);

// Velocities as they are; Simulator::Command refuses what is not finite.
VelocityCommand FromRos(const geometry_msgs::Twist& twist);

// Errors: INVALID_ARGUMENT with every violation (species, state, place, position).
Result<SpawnRequest> FromRos(const latticeworld_msgs::SpawnAgent::Request& request);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_AGENT_CONVERSION_H_
