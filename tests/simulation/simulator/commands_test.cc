#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TestScene WithRobotAndGoblin() {
  TestScene scene;
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  scene.AddAgent("goblin", AgentCategory::kGoblin, 28.0, 28.0).state = AgentState::kIdle;
  return scene;
}

JointCommand Velocity(const std::string& joint, double rate_radps) {
  return {joint, kNan, rate_radps, kNan};
}
JointCommand Position(const std::string& joint, double angle_rad) {
  return {joint, angle_rad, kNan, kNan};
}

TEST(CommandsTest, WhatIsNotFiniteIsRefusedAndWhatIsHugeIsClamped) {
  const auto simulator = MakeSimulator(WithRobotAndGoblin());
  const std::string before = simulator->StateHash();
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 4; ++i) {
      VelocityCommand command;
      (i < 3 ? command.linear_mps[i] : command.yaw_rate_radps) = bad;
      EXPECT_EQ(simulator->Command("robot", command).code(), StatusCode::kInvalidArgument);
    }
  }
  EXPECT_EQ(simulator->StateHash(), before);
  RunWith(simulator.get(), 3.0, "robot", Forward(1e300));
  const AgentSnapshot robot = Now(*simulator, "robot");
  const Species& species = SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kWheeledRobot);
  EXPECT_LT(robot.linear_velocity_mps.norm(), 1.1 * species.top_speed_mps);
  RunWith(simulator.get(), 3.0, "robot", Forward(0.0, -1e300));
  EXPECT_LT(std::abs(Now(*simulator, "robot").angular_velocity_radps.z()),
            1.2 * species.turn_rate_radps);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kFrozen, "robot"), 0);
}

TEST(CommandsTest, TheWatchdogStopsARobotWhoseCommandIsOld) {
  SimulatorOptions options;
  options.command_timeout_s = 0.3;
  const auto simulator = MakeSimulator(WithRobotAndGoblin(), 1, options);
  RunWith(simulator.get(), 2.0, "robot", Forward(1.0));
  EXPECT_GT(Now(*simulator, "robot").linear_velocity_mps.x(), 0.8);
  RunFor(simulator.get(), 0.25);
  EXPECT_GT(Now(*simulator, "robot").linear_velocity_mps.x(), 0.8);  // still holds
  RunFor(simulator.get(), 2.0);
  EXPECT_LT(Now(*simulator, "robot").linear_velocity_mps.norm(), 0.02);
}

TEST(CommandsTest, OnlyWhoIsForItTakesCommands) {
  const auto simulator = MakeSimulator(WithRobotAndGoblin());
  EXPECT_EQ(simulator->Command("nobody", Forward(1.0)).code(), StatusCode::kNotFound);
  EXPECT_NE(simulator->Command("nobody", Forward(1.0)).message().find("goblin, robot"),
            std::string::npos);
  EXPECT_EQ(simulator->Command("goblin", Forward(1.0)).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(simulator->Strike("goblin").code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(simulator->CommandJoints("goblin", {}).code(), StatusCode::kFailedPrecondition);
  ASSERT_TRUE(simulator->SetPolicy({"goblin", std::nullopt, "external"}).ok());
  EXPECT_TRUE(simulator->Command("goblin", Forward(1.0)).ok());
  EXPECT_EQ(Now(*simulator, "goblin").policy, "external");
  const double begin_m = Now(*simulator, "goblin").position_m.x();
  RunWith(simulator.get(), 2.0, "goblin", Forward(-1.0));
  EXPECT_LT(Now(*simulator, "goblin").position_m.x(), begin_m - 1.0);
  // Without commands it stands.
  RunFor(simulator.get(), 2.0);
  EXPECT_LT(Now(*simulator, "goblin").linear_velocity_mps.norm(), 0.05);
  ASSERT_TRUE(simulator->SetPolicy({"goblin", std::nullopt, ""}).ok());
  EXPECT_EQ(simulator->Command("goblin", Forward(1.0)).code(), StatusCode::kFailedPrecondition);
}

TEST(CommandsTest, ATeamsPolicyHoldsForThoseWithoutOneOfTheirOwnAndForThoseThatCome) {
  TestScene scene = WithRobotAndGoblin();
  scene.AddAgent("chief", AgentCategory::kGoblin, -28.0, 28.0).state = AgentState::kIdle;
  const auto simulator = MakeSimulator(scene);
  const std::string usual = Now(*simulator, "goblin").policy;
  EXPECT_FALSE(usual.empty());
  EXPECT_EQ(Now(*simulator, "robot").policy, "");
  const int team = Now(*simulator, "goblin").team;
  ASSERT_TRUE(simulator->SetPolicy({"chief", std::nullopt, "guard"}).ok());
  ASSERT_TRUE(simulator->SetPolicy({"", team, "ambusher"}).ok());
  MustSpawn(simulator.get(), RequestFor("goblin", "late", -28.0, -28.0));
  EXPECT_EQ(Now(*simulator, "goblin").policy, "ambusher");
  EXPECT_EQ(Now(*simulator, "late").policy, "ambusher");
  EXPECT_EQ(Now(*simulator, "chief").policy, "guard");
  ASSERT_TRUE(simulator->SetPolicy({"", team, ""}).ok());
  EXPECT_EQ(Now(*simulator, "goblin").policy, usual);
  // A team's policy is over with the episode.
  ASSERT_TRUE(simulator->SetPolicy({"", team, "raider"}).ok());
  simulator->Reset(1);
  EXPECT_EQ(Now(*simulator, "goblin").policy, usual);
}

TEST(CommandsTest, IllegalPoliciesAreRefusedAndTheLegalOnesNamed) {
  const auto simulator = MakeSimulator(WithRobotAndGoblin());
  const std::string before = simulator->StateHash();
  const PolicyChange bad[] = {{"goblin", std::nullopt, "pacifist"},
                              {"", std::nullopt, "pursuer"},
                              {"goblin", 2, "pursuer"},
                              {"", 16, "pursuer"},
                              {"", -1, "pursuer"}};
  for (const PolicyChange& change : bad) {
    EXPECT_EQ(simulator->SetPolicy(change).code(), StatusCode::kInvalidArgument);
  }
  EXPECT_EQ(simulator->SetPolicy({"nobody", std::nullopt, "pursuer"}).code(),
            StatusCode::kNotFound);
  EXPECT_NE(simulator->SetPolicy(bad[0]).message().find("ambusher"), std::string::npos);
  EXPECT_EQ(simulator->StateHash(), before);
}

TEST(CommandsTest, JointsFollowTheirCommandsUntilTheseAreOld) {
  const auto simulator = MakeSimulator(WithRobotAndGoblin());
  const AgentSnapshot start = Now(*simulator, "robot");
  ASSERT_EQ(start.joints.size(), 4u);
  EXPECT_TRUE(Now(*simulator, "goblin").joints.empty());
  const auto rate = [&](std::size_t joint) {
    return Now(*simulator, "robot").joints[joint].rate_radps;
  };
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(simulator
                    ->CommandJoints("robot", {Velocity("front_left_wheel", 3.0),
                                              Velocity("rear_left_wheel", 3.0)})
                    .ok());
    simulator->Step();
  }
  EXPECT_EQ(Now(*simulator, "robot").joints[0].name, "front_left_wheel");
  EXPECT_NEAR(rate(0), 3.0, 0.3);
  RunFor(simulator.get(), 2.0);
  EXPECT_NEAR(rate(0), 0.0, 0.05);
}

TEST(CommandsTest, IllegalJointCommandsAreRefusedWhole) {
  const auto simulator = MakeSimulator(WithRobotAndGoblin());
  const std::string before = simulator->StateHash();
  const JointCommand good = Velocity("front_left_wheel", 1.0);
  const struct {
    std::vector<JointCommand> commands;
    StatusCode code;
  } cases[] = {
      {{good, Velocity("seventh_wheel", 1.0)}, StatusCode::kNotFound},
      {{good, Velocity("front_right_wheel", kNan)}, StatusCode::kInvalidArgument},
      {{good, Velocity("front_right_wheel", kInfinity)}, StatusCode::kInvalidArgument},
      {{good, {"front_right_wheel", 1.0, 1.0, kNan}}, StatusCode::kInvalidArgument},
      {{good, {"front_right_wheel", kInfinity, 1.0, kNan}}, StatusCode::kInvalidArgument},
      {{good, Position("front_right_wheel", 1.0)}, StatusCode::kInvalidArgument},
      {{good, good}, StatusCode::kInvalidArgument},
  };
  for (const auto& one : cases) {
    const Status status = simulator->CommandJoints("robot", one.commands);
    EXPECT_EQ(status.code(), one.code) << status.ToString();
    EXPECT_EQ(simulator->StateHash(), before);
  }
  EXPECT_NE(simulator->CommandJoints("robot", cases[0].commands).message().find("rear_left_wheel"),
            std::string::npos);
}

TEST(CommandsTest, EveryIllegalJointCommandIsNamed) {
  const auto simulator = MakeSimulator(WithRobotAndGoblin());
  const Status status = simulator->CommandJoints(
      "robot", {Velocity("front_left_wheel", 1.0), Velocity("front_left_wheel", 2.0),
                Velocity("front_right_wheel", kNan), Position("rear_left_wheel", 1.0)});
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(status.violations().size(), 3u) << status.ToString();
  for (const char* word : {"front_left_wheel\": is commanded twice", "front_right_wheel", "nan",
                           "rear_left_wheel", "velocity only"}) {
    EXPECT_NE(status.message().find(word), std::string::npos) << word;
  }
}

TEST(CommandsTest, ALeggedRobotsJointTakesPositions) {
  TestScene scene;
  scene.AddAgent("dog", AgentCategory::kRoboticDog, 0.0, 0.0).controllable = true;
  const auto simulator = MakeSimulator(scene);
  ASSERT_EQ(Now(*simulator, "dog").joints.size(), 12u);
  RunFor(simulator.get(), 1.0);
  const JointSnapshot before = Now(*simulator, "dog").joints[0];
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(
        simulator->CommandJoints("dog", {Position(before.name, before.angle_rad + 0.2)}).ok());
    simulator->Step();
  }
  EXPECT_NEAR(Now(*simulator, "dog").joints[0].angle_rad, before.angle_rad + 0.2, 0.08);
}

TEST(CommandsTest, AMainAgentStrikesBack) {
  TestScene scene;
  AgentStart& hero = scene.AddAgent("hero", AgentCategory::kAncientWarrior, 0.0, 0.0);
  hero.controllable = true;
  hero.team = 1;
  scene.AddAgent("goblin", AgentCategory::kGoblin, 1.3, 0.0).state = AgentState::kIdle;
  scene.AddAgent("sheep", AgentCategory::kSheep, -20.0, 0.0).controllable = true;
  const auto simulator = MakeSimulator(scene);
  EXPECT_EQ(simulator->Strike("nobody").code(), StatusCode::kNotFound);
  EXPECT_EQ(simulator->Strike("sheep").code(), StatusCode::kFailedPrecondition);
  RunFor(simulator.get(), 0.1);
  EXPECT_EQ(Now(*simulator, "goblin").health, 1.0);
  ASSERT_TRUE(simulator->Strike("hero").ok());
  RunFor(simulator.get(), 0.2);
  EXPECT_LT(Now(*simulator, "goblin").health, 1.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kAttacked, "hero"), 1);
}

TEST(CommandsTest, WhoFollowsCommandsFollowsNoPolicy) {
  TestScene scene;
  AgentStart& hero = scene.AddAgent("hero", AgentCategory::kAncientWarrior, 0.0, 0.0);
  hero.controllable = true;
  scene.AddAgent("warrior", AgentCategory::kAncientWarrior, 10.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  const std::string before = simulator->StateHash();
  PolicyChange change;
  change.agent = "hero";
  change.policy = "pursuer";
  const Status refused = simulator->SetPolicy(change);
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(refused.message().find("hero"), std::string::npos) << refused.message();
  EXPECT_NE(refused.message().find("controllable"), std::string::npos) << refused.message();
  change.policy.clear();  // that it has none is true already
  EXPECT_TRUE(simulator->SetPolicy(change).ok());
  EXPECT_EQ(simulator->StateHash(), before);
  change = {};
  change.team = Now(*simulator, "hero").team;
  change.policy = "ambusher";
  EXPECT_TRUE(simulator->SetPolicy(change).ok());
  EXPECT_EQ(Now(*simulator, "hero").policy, "");
  EXPECT_EQ(Now(*simulator, "warrior").policy, "ambusher");
  EXPECT_TRUE(simulator->Command("hero", Forward(1.0)).ok());
}

TEST(CommandsTest, GatesTurnAsTold) {
  TestScene scene;
  scene.AddProp("gate", PropKind::kGate, 0.0, 0.0);
  scene.AddProp("crate", PropKind::kCrate, 10.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  const std::string before = simulator->StateHash();
  EXPECT_EQ(simulator->OpenGate("nothing", 1.0).code(), StatusCode::kNotFound);
  EXPECT_EQ(simulator->OpenGate("crate", 1.0).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(simulator->OpenGate("gate", 9.0).code(), StatusCode::kOutOfRange);
  EXPECT_FALSE(simulator->OpenGate("gate", kNan).ok());
  EXPECT_EQ(simulator->StateHash(), before);
  ASSERT_TRUE(simulator->OpenGate("gate", 1.2).ok());
  RunFor(simulator.get(), 8.0);
  EXPECT_NEAR(PropNow(*simulator, "gate").opening_rad, 1.2, 0.15);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kOpened, "gate"), 1);
}

}  // namespace
}  // namespace latticeworld
