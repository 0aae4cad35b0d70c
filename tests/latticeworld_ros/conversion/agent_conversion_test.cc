#include "latticeworld_ros/conversion/agent_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "latticeworld_ros/publishing/robot_frames.h"

namespace latticeworld {
namespace {

AgentSnapshot Robot() {
  AgentSnapshot agent;
  agent.name = "scout";
  agent.category = AgentCategory::kWheeledRobot;
  agent.species = "tractor";
  agent.policy = "guard";
  agent.team = 1;
  agent.controllable = true;
  agent.behaviour = Behaviour::kControlled;
  agent.health = 0.5;
  agent.position_m = {3.0, 4.0, 5.0};
  agent.orientation = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ());
  agent.linear_velocity_mps = {1.0, 0.0, 0.0};
  agent.angular_velocity_radps = {0.0, 0.0, 0.25};
  return agent;
}

TEST(AgentConversionTest, StatesCarryTheStepAndEveryField) {
  WorldState state;
  state.step = 12;
  state.episode_step = 2;
  state.episode_time_s = 0.02;
  state.agents = {Robot()};
  const auto message = ToAgentStates(state, ros::Time(7, 5), "world-1");
  EXPECT_EQ(message.header.stamp, ros::Time(7, 5));
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.world_id, "world-1");
  EXPECT_EQ(message.step, 12u);
  EXPECT_EQ(message.episode_step, 2u);
  EXPECT_DOUBLE_EQ(message.episode_time, 0.02);
  ASSERT_EQ(message.agents.size(), 1u);
  const auto& agent = message.agents[0];
  EXPECT_EQ(agent.name, "scout");
  EXPECT_EQ(agent.species, "tractor");
  EXPECT_EQ(agent.policy, "guard");
  EXPECT_EQ(agent.behaviour, "controlled");
  EXPECT_EQ(agent.team, 1);
  EXPECT_TRUE(agent.controllable);
  EXPECT_DOUBLE_EQ(agent.health, 0.5);
  EXPECT_DOUBLE_EQ(agent.pose.position.z, 5.0);
  EXPECT_NEAR(agent.pose.orientation.z, std::sqrt(0.5), 1e-12);
  EXPECT_DOUBLE_EQ(agent.twist.linear.x, 1.0);
  EXPECT_DOUBLE_EQ(agent.twist.angular.z, 0.25);
}

TEST(AgentConversionTest, OdometryIsSeenFromItsFrame) {
  const AgentSnapshot robot = Robot();
  // A frame that lies at (3, 0, 5) and looks north, as the robot does: the robot is 4 m ahead.
  Eigen::Isometry3d map_from_odom = Eigen::Isometry3d::Identity();
  map_from_odom.linear() = robot.orientation.toRotationMatrix();
  map_from_odom.translation() = Eigen::Vector3d(3.0, 0.0, 5.0);
  const auto message =
      ToOdometry(robot, ros::Time(1, 0), OdomFrame(robot.name), map_from_odom.inverse());
  EXPECT_EQ(message.header.frame_id, "scout/odom");
  EXPECT_EQ(message.child_frame_id, "scout/base_link");
  EXPECT_NEAR(message.pose.pose.position.x, 4.0, 1e-12);
  EXPECT_NEAR(message.pose.pose.position.y, 0.0, 1e-12);
  EXPECT_NEAR(message.pose.pose.orientation.w, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(message.twist.twist.linear.x, 1.0);
}

// move_base and its kin take the z axis of odom for up: on a slope of 22.6 degrees a tilted frame
// put goals a metre off or out of reach (navigation, noetic).
TEST(AgentConversionTest, OdometryBeginsLevel) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(3.0, -2.0, 7.0);
  pose.linear() = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(0.394, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  const Eigen::Isometry3d level = LevelFrameAt(pose);
  EXPECT_TRUE(level.translation().isApprox(pose.translation()));
  EXPECT_TRUE(level.linear().col(2).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_NEAR(std::atan2(level.linear()(1, 0), level.linear()(0, 0)), 0.7, 1e-12);
  // Standing on its tail it still has a yaw.
  pose.linear() = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitY()))
                      .toRotationMatrix();
  EXPECT_NEAR(std::atan2(LevelFrameAt(pose).linear()(1, 0), LevelFrameAt(pose).linear()(0, 0)), 0.7,
              1e-9);
}

TEST(AgentConversionTest, ExactOdometryHasSmallVariancesThatAreNotZero) {
  const auto odometry = ToOdometry(Robot(), ros::Time(1, 0), "odom", Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_EQ(odometry.pose.covariance[i] > 0.0, i % 7 == 0) << i;
    EXPECT_LT(odometry.twist.covariance[i], 1e-4);
  }
}

TEST(AgentConversionTest, TransformsHaveUnitQuaternionsAndNoLeadingSlash) {
  const auto message =
      ToTransformStamped(PoseOf(Robot()), ros::Time(1, 0), kMapFrame, BaseFrame("scout"));
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.child_frame_id, "scout/base_link");
  const auto& q = message.transform.rotation;
  EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-12);
}

// "map -> scout/odom" and the like, as they are published.
std::vector<std::string> FramesOf(const RobotFrameOptions& options, const std::string& robot) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  AppendRobotFrames(options, robot, ros::Time(1, 0), PoseOf(Robot()), Eigen::Isometry3d::Identity(),
                    &transforms);
  std::vector<std::string> frames;
  for (const auto& transform : transforms) {
    frames.push_back(transform.header.frame_id + " -> " + transform.child_frame_id);
  }
  return frames;
}

TEST(RobotFramesTest, WhatOthersPublishIsLeftOutForAllOrByName) {
  const std::string to_odom = "map -> scout/odom", to_base = "scout/odom -> scout/base_link";
  RobotFrameOptions options;
  EXPECT_EQ(FramesOf(options, "scout"), (std::vector<std::string>{to_odom, to_base}));
  options.localised_elsewhere = {"robot", "scout"};
  EXPECT_EQ(FramesOf(options, "scout"), std::vector<std::string>{to_base});
  EXPECT_EQ(FramesOf(options, "scout_2").size(), 2u);
  options.odometry_elsewhere = {"scout"};
  EXPECT_TRUE(FramesOf(options, "scout").empty());
  options = {};
  options.map_to_odom = false;
  EXPECT_EQ(FramesOf(options, "scout"), std::vector<std::string>{to_base});
  options = {};
  options.odom_to_base = false;
  EXPECT_EQ(FramesOf(options, "scout"), std::vector<std::string>{to_odom});
}

TEST(AgentConversionTest, EmptySpawnRequestIsAWheeledRobotAtTheCentre) {
  const auto request = ToSpawnRequest(latticeworld_msgs::SpawnAgent::Request(), SimulatorOptions());
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_EQ(request->category, AgentCategory::kWheeledRobot);
  EXPECT_EQ(request->species, "wheeled robot");
  EXPECT_FALSE(request->state.has_value());
  EXPECT_FALSE(request->team.has_value());
  ASSERT_TRUE(request->position.has_value());
  EXPECT_EQ(request->position->x_m, 0.0);
}

TEST(AgentConversionTest, PlacesInWordsReplaceThePosition) {
  latticeworld_msgs::SpawnAgent::Request message;
  message.species = "robotic_dog";
  message.state = "patrolling";
  message.place = "upper left";
  message.position.x = std::numeric_limits<double>::quiet_NaN();  // not looked at
  const auto request = ToSpawnRequest(message, SimulatorOptions());
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_EQ(request->category, AgentCategory::kRoboticDog);
  EXPECT_EQ(request->species, "robotic dog");
  EXPECT_EQ(request->state, AgentState::kPatrolling);
  EXPECT_EQ(request->region, Region::kUpperLeft);
  EXPECT_FALSE(request->position.has_value());
}

TEST(AgentConversionTest, ASpawnRequestCarriesWhatIsGivenForTheSimulatorToJudge) {
  latticeworld_msgs::SpawnAgent::Request message;
  message.name = "no name";
  message.species = "dragon";
  message.position.y = std::numeric_limits<double>::infinity();
  message.heading = std::numeric_limits<double>::quiet_NaN();
  message.controllable = true;
  message.policy = "daydreamer";
  const auto request = ToSpawnRequest(message, SimulatorOptions());
  ASSERT_TRUE(request.ok()) << request.status().ToString();
  EXPECT_EQ(request->name, "no name");
  EXPECT_EQ(request->species, "dragon");
  EXPECT_EQ(request->position->y_m, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(request->heading_rad));
  EXPECT_TRUE(request->controllable);
  EXPECT_EQ(request->policy, "daydreamer");
}

TEST(AgentConversionTest, WhatIsNoStateOrPlaceIsRefusedWithAllElseThatIsIllegal) {
  latticeworld_msgs::SpawnAgent::Request message;
  message.species = "dragon";
  message.state = "asleep";
  message.place = "nowhere";
  message.heading = std::numeric_limits<double>::quiet_NaN();
  message.team = 99;
  const auto request = ToSpawnRequest(message, SimulatorOptions());
  ASSERT_FALSE(request.ok());
  EXPECT_EQ(request.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(request.status().violations().size(), 5u) << request.status().ToString();
  for (const char* word : {"dragon", "sheep", "asleep", "grazing", "nowhere", "upper left",
                           "heading", "99", "1 .. 15"}) {
    EXPECT_NE(request.status().message().find(word), std::string::npos) << word;
  }
}

TEST(AgentConversionTest, TeamsOfASpawnRequest) {
  latticeworld_msgs::SpawnAgent::Request message;
  message.team = 3;
  EXPECT_EQ(ToSpawnRequest(message, SimulatorOptions())->team, 3);
  message.team = -1;
  EXPECT_EQ(ToSpawnRequest(message, SimulatorOptions())->team, 0);
  message.team = 0;
  EXPECT_FALSE(ToSpawnRequest(message, SimulatorOptions())->team.has_value());
  // What is no team stays none.
  for (const int team : {-2, 16}) {
    message.team = team;
    EXPECT_EQ(ToSpawnRequest(message, SimulatorOptions())->team, team);
  }
}

TEST(AgentConversionTest, APolicyChangeCarriesAgentTeamAndPolicy) {
  latticeworld_msgs::SetPolicy::Request message;
  EXPECT_FALSE(ToPolicyChange(message).team.has_value());
  message.agent = "goblin_1";
  message.policy = "daydreamer";
  for (const int team : {-1, 2, 16}) {
    message.team = team;
    const PolicyChange change = ToPolicyChange(message);
    EXPECT_EQ(change.agent, "goblin_1");
    EXPECT_EQ(change.team, team);
    EXPECT_EQ(change.policy, "daydreamer");
  }
}

TEST(AgentConversionTest, JointStatesKeepTheJointsInOrder) {
  AgentSnapshot robot = Robot();
  robot.joints = {{"left_wheel", 0.1, 0.2, 0.3}, {"right_wheel", 1.1, 1.2, 1.3}};
  const auto message = ToJointState(robot, ros::Time(3, 0));
  EXPECT_EQ(message.header.stamp, ros::Time(3, 0));
  EXPECT_EQ(message.name, (std::vector<std::string>{"left_wheel", "right_wheel"}));
  EXPECT_EQ(message.position, (std::vector<double>{0.1, 1.1}));
  EXPECT_EQ(message.velocity, (std::vector<double>{0.2, 1.2}));
  EXPECT_EQ(message.effort, (std::vector<double>{0.3, 1.3}));
}

TEST(AgentConversionTest, JointCommandsSayNothingWhereAnArrayIsEmpty) {
  sensor_msgs::JointState message;
  message.name = {"hip", "knee"};
  message.position = {0.25, std::numeric_limits<double>::quiet_NaN()};
  message.effort = {std::numeric_limits<double>::quiet_NaN(), 4.0};
  const auto commands = ToJointCommands(message);
  ASSERT_TRUE(commands.ok()) << commands.status().ToString();
  ASSERT_EQ(commands->size(), 2u);
  EXPECT_EQ((*commands)[0].joint, "hip");
  EXPECT_EQ((*commands)[0].position_rad, 0.25);
  EXPECT_TRUE(std::isnan((*commands)[0].velocity_radps));
  EXPECT_TRUE(std::isnan((*commands)[0].effort_nm));
  EXPECT_TRUE(std::isnan((*commands)[1].position_rad));
  EXPECT_EQ((*commands)[1].effort_nm, 4.0);
}

TEST(AgentConversionTest, JointCommandsWithArraysOfAnotherLengthAreRefused) {
  sensor_msgs::JointState message;
  message.name = {"hip", "knee"};
  message.position = {0.25};
  message.velocity = {0.0, 0.0, 0.0};
  const auto commands = ToJointCommands(message);
  ASSERT_FALSE(commands.ok());
  EXPECT_EQ(commands.status().violations().size(), 2u);
  message = {};
  message.name.assign(kMaxCommandedJoints + 1, "knee");
  EXPECT_FALSE(ToJointCommands(message).ok());
}

}  // namespace
}  // namespace latticeworld
