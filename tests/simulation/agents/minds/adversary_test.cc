#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// A robot that obeys commands, and a goblin that looks its way.
TestScene RobotAndGoblin(double goblin_x_m) {
  TestScene scene;
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  AgentStart& goblin = scene.AddAgent("goblin", AgentCategory::kGoblin, goblin_x_m, 0.0);
  goblin.state = AgentState::kPursuing;
  goblin.heading_rad = goblin_x_m > 0.0 ? M_PI : 0.0;
  return scene;
}

double GapBetween(const Simulator& simulator, const char* a, const char* b) {
  return (Now(simulator, a).position_m - Now(simulator, b).position_m).norm();
}

TEST(AdversaryTest, PursuesAndAttacksARobotThatItSees) {
  const auto simulator = MakeSimulator(RobotAndGoblin(15.0));
  RunFor(simulator.get(), 1.0);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kPursue);
  RunFor(simulator.get(), 9.0);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kAttack);
  EXPECT_LT(Now(*simulator, "robot").health, 0.9);
  const std::vector<Event> events = simulator->TakeEvents();
  EXPECT_EQ(Count(events, EventKind::kPursued, "goblin"), 1);
  EXPECT_GE(Count(events, EventKind::kAttacked, "goblin"), 2);
  EXPECT_EQ(Count(events, EventKind::kAttacked, "goblin"), Count(events, EventKind::kHit, "robot"));
  for (std::size_t i = 1; i < events.size(); ++i) EXPECT_GE(events[i].step, events[i - 1].step);
}

TEST(AdversaryTest, LeavesAloneARobotBeyondThePursuitDistance) {
  TestScene scene = RobotAndGoblin(15.0);
  scene.agents[1].state = AgentState::kIdle;  // on guard where it stands
  SimulatorOptions options;
  options.pursuit_distance_m = 10.0;
  const auto simulator = MakeSimulator(scene, 1, options);
  RunFor(simulator.get(), 10.0);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kGuard);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kPursued, "goblin"), 0);
}

TEST(AdversaryTest, DoesNotSeeThroughABuilding) {
  TestScene scene = RobotAndGoblin(15.0);
  scene.agents[1].state = AgentState::kIdle;
  scene.AddBuilding(8.0, 0.0, 1.0, 10.0);
  SimulatorOptions options;
  options.pursuit_distance_m = 40.0;
  const auto simulator = MakeSimulator(scene, 1, options);
  RunFor(simulator.get(), 10.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kPursued, "goblin"), 0);
  EXPECT_DOUBLE_EQ(Now(*simulator, "robot").health, 1.0);
}

TEST(AdversaryTest, LeavesNeutralAnimalsAndItsOwnKindAlone) {
  TestScene scene;
  scene.AddAgent("sheep", AgentCategory::kSheep, 5.0, 0.0);
  scene.AddAgent("warrior", AgentCategory::kAncientWarrior, 0.0, 5.0);
  scene.AddAgent("goblin", AgentCategory::kGoblin, 0.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 10.0);
  for (const Event& event : simulator->TakeEvents()) EXPECT_NE(event.kind, EventKind::kPursued);
}

TEST(AdversaryTest, KilledRobotDiesOnceObeysNoMoreAndIsLeftAlone) {
  TestScene scene = RobotAndGoblin(4.0);
  AgentStart& warrior = scene.AddAgent("warrior", AgentCategory::kAncientWarrior, -4.0, 0.0);
  warrior.state = AgentState::kPursuing;
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 20.0);
  const AgentSnapshot robot = Now(*simulator, "robot");
  ASSERT_EQ(robot.behaviour, Behaviour::kDead);
  EXPECT_DOUBLE_EQ(robot.health, 0.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kDied, "robot"), 1);
  EXPECT_EQ(simulator->Strike("robot").code(), StatusCode::kFailedPrecondition);
  RunWith(simulator.get(), 3.0, "robot", Forward(2.0));
  EXPECT_LT((Now(*simulator, "robot").position_m - robot.position_m).norm(), 0.5);
  EXPECT_NE(Now(*simulator, "goblin").behaviour, Behaviour::kAttack);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kAttacked, "goblin"), 0);
}

TEST(AdversaryTest, RemovingItsPreyWhileItStrikesIsHarmless) {
  const auto simulator = MakeSimulator(RobotAndGoblin(2.0));
  RunFor(simulator.get(), 3.0);
  ASSERT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kAttack);
  ASSERT_TRUE(simulator->Remove("robot").ok());
  RunFor(simulator.get(), 2.0);
  EXPECT_EQ(simulator->State()->agents.size(), 1u);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kPatrol);
}

TEST(AdversaryTest, RoundsABuildingToWhereItLastSawTheRobot) {
  TestScene scene = RobotAndGoblin(14.0);
  scene.AddBuilding(7.0, 2.5, 1.5, 2.0);  // beside the line of sight
  const auto simulator = MakeSimulator(scene);
  double nearest_m = 1e9;
  for (int i = 0; i < 100; ++i) {
    RunFor(simulator.get(), 0.1);
    nearest_m = std::min(nearest_m, GapBetween(*simulator, "robot", "goblin"));
    const AgentSnapshot goblin = Now(*simulator, "goblin");
    ASSERT_FALSE(
        SolidContains(scene.assets[0], {goblin.position_m.x(), goblin.position_m.y()}, 0.2));
  }
  EXPECT_LT(nearest_m, 2.0);
}

TEST(AdversaryTest, TheMainAgentStrikesBackOnCommandAlone) {
  TestScene scene = RobotAndGoblin(3.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 4.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kAttacked, "robot"), 0);
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(simulator->Strike("robot").ok());
    RunWith(simulator.get(), 0.1, "robot", Forward(0.3));
  }
  const std::vector<Event> events = simulator->TakeEvents();
  const int blows = Count(events, EventKind::kAttacked, "robot");
  EXPECT_GE(blows, 2);
  EXPECT_LE(blows, 5) << "its blows need a pause as everybody's";
  EXPECT_EQ(Count(events, EventKind::kHit, "goblin"), blows);
  EXPECT_LT(Now(*simulator, "goblin").health, 1.0);
}

TEST(AdversaryTest, AStrikeIntoTheAirHitsNobody) {
  const auto simulator = MakeSimulator(RobotAndGoblin(20.0));
  ASSERT_TRUE(simulator->Strike("robot").ok());
  RunFor(simulator.get(), 1.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kAttacked, "robot"), 0);
}

TEST(AdversaryTest, APolicyCanBeChosenForAnAgentAndForATeam) {
  TestScene scene = RobotAndGoblin(8.0);
  scene.AddAgent("goblin_2", AgentCategory::kGoblin, 10.0, 5.0).state = AgentState::kPursuing;
  const auto simulator = MakeSimulator(scene);
  ASSERT_TRUE(simulator->SetPolicy({"", 2, "idler"}).ok());
  ASSERT_TRUE(simulator->SetPolicy({"goblin", std::nullopt, "pursuer"}).ok());
  RunFor(simulator.get(), 1.0);
  EXPECT_EQ(Now(*simulator, "goblin").policy, "pursuer");
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kPursue);
  EXPECT_EQ(Now(*simulator, "goblin_2").policy, "idler");
  EXPECT_EQ(Now(*simulator, "goblin_2").behaviour, Behaviour::kIdle);
  EXPECT_FALSE(simulator->SetPolicy({"goblin", std::nullopt, "saint"}).ok());
}

TEST(AdversaryTest, AnExternalPolicyDrivesAnAgentFromOutside) {
  TestScene scene = RobotAndGoblin(8.0);
  const auto simulator = MakeSimulator(scene);
  EXPECT_FALSE(simulator->Command("goblin", Forward(1.0)).ok());
  ASSERT_TRUE(simulator->SetPolicy({"goblin", std::nullopt, "external"}).ok());
  const Eigen::Vector3d before = Now(*simulator, "goblin").position_m;
  RunFor(simulator.get(), 1.0);
  EXPECT_LT((Now(*simulator, "goblin").position_m - before).norm(), 0.2) << "stands without";
  RunWith(simulator.get(), 3.0, "goblin", Forward(-1.0));
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kControlled);
  EXPECT_GT(Now(*simulator, "goblin").position_m.x(), before.x() + 1.0);
}

TEST(AdversaryTest, ABlowThrowsBackWhomItHits) {
  TestScene scene;
  AgentStart& warrior = scene.AddAgent("warrior", AgentCategory::kAncientWarrior, 0.0, 0.0);
  warrior.state = AgentState::kPursuing;
  AgentStart& victim = scene.AddAgent("victim", AgentCategory::kHumanoidRobot, 1.9, 0.0);
  victim.controllable = true;
  const auto simulator = MakeSimulator(scene);
  double thrown_mps = 0.0;
  std::vector<Event> events;
  for (int i = 0; i < 300 && Count(events, EventKind::kHit, "victim") == 0; ++i) {
    simulator->Step();
    for (Event& event : simulator->TakeEvents()) events.push_back(event);
    thrown_mps =
        (Now(*simulator, "victim").orientation * Now(*simulator, "victim").linear_velocity_mps).x();
  }
  ASSERT_EQ(Count(events, EventKind::kHit, "victim"), 1);
  EXPECT_GT(thrown_mps, 0.3) << "80 N s on 70 kg";
}

}  // namespace
}  // namespace latticeworld
