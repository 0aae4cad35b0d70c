#include "latticeworld_ros/server/lockstep_request.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace latticeworld {
namespace {

using Commands = LockstepCommands;

// A robot, a goblin that is decided for from outside, one that decides for itself, and sheep, one
// of them dead.
WorldState Farm() {
  WorldState state;
  const auto add = [&](const std::string& name, const std::string& species) -> AgentSnapshot& {
    AgentSnapshot agent;
    agent.name = name;
    agent.species = species;
    state.agents.push_back(agent);
    return state.agents.back();
  };
  add("dead_goblin", "goblin").behaviour = Behaviour::kDead;
  state.agents.back().policy = "external";
  add("goblin", "goblin").policy = "pursuer";
  add("led_goblin", "goblin").policy = "external";
  add("robot", "wheeled robot").controllable = true;
  add("sheep", "sheep").policy = "external";
  return state;
}

Status Check(const Commands& commands) {
  return CheckCommands(commands, Farm(), *SpeciesCatalogue::BuiltIn());
}

VelocityCommand Forward(double speed_mps) {
  VelocityCommand command;
  command.linear_mps.x() = speed_mps;
  return command;
}

TEST(LockstepRequestTest, EverybodyWhoIsNamedIsObservedOnce) {
  latticeworld_msgs::Lockstep::Request request;
  request.commands.resize(1);
  request.commands[0].agent = "robot";
  request.commands[0].velocity.linear.x = 0.5;
  request.strikes = {"led_goblin"};
  request.observe = {"sheep", "robot", "sheep"};
  const Commands commands = ToLockstepCommands(request);
  EXPECT_EQ(commands.observed, (std::vector<std::string>{"led_goblin", "robot", "sheep"}));
  ASSERT_EQ(commands.velocities.size(), 1u);
  EXPECT_EQ(commands.velocities[0].second.linear_mps.x(), 0.5);
  EXPECT_TRUE(Check(commands).ok());
}

TEST(LockstepRequestTest, ACommandIsForThoseWhoObey) {
  EXPECT_TRUE(Check({{{"robot", Forward(1.0)}, {"led_goblin", Forward(1.0)}}, {}, {}}).ok());
  const Status status = Check({{{"goblin", Forward(1.0)}}, {}, {}});
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(status.message().find("commands[0]"), std::string::npos) << status.message();
  EXPECT_NE(status.message().find("\"pursuer\""), std::string::npos) << status.message();
}

TEST(LockstepRequestTest, WhoIsNotThereIsNamed) {
  const Status status = Check({{}, {}, {"nobody", "robot"}});
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_NE(status.message().find("\"nobody\""), std::string::npos) << status.message();
}

TEST(LockstepRequestTest, VelocitiesAreFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Check({{{"robot", Forward(nan)}}, {}, {}}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(Check({{{"robot", Forward(std::numeric_limits<double>::infinity())}}, {}, {}}).code(),
            StatusCode::kInvalidArgument);
}

TEST(LockstepRequestTest, NobodyIsToldTwice) {
  EXPECT_EQ(Check({{{"robot", Forward(1.0)}, {"robot", Forward(0.5)}}, {}, {}}).code(),
            StatusCode::kInvalidArgument);
  EXPECT_EQ(Check({{}, {"led_goblin", "led_goblin"}, {}}).code(), StatusCode::kInvalidArgument);
}

TEST(LockstepRequestTest, StrikesAreForThoseWhoCanAndLive) {
  EXPECT_TRUE(Check({{}, {"led_goblin"}, {}}).ok());
  EXPECT_EQ(Check({{}, {"dead_goblin"}, {}}).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(Check({{}, {"sheep"}, {}}).code(), StatusCode::kFailedPrecondition);
}

TEST(LockstepRequestTest, AllThatIsWrongIsTold) {
  const Status status = Check({{{"nobody", Forward(1.0)}}, {"goblin"}, {"ghost"}});
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  for (const char* word : {"3 things", "\"nobody\"", "\"goblin\"", "\"ghost\""}) {
    EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
  }
}

}  // namespace
}  // namespace latticeworld
