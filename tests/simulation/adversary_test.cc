#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test_scene.h"

namespace latticeworld {
namespace {

TestScene RobotAndGoblin(double goblin_x_m) {
  TestScene scene;
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  scene.AddAgent("goblin", AgentCategory::kGoblin, goblin_x_m, 0.0).state = AgentState::kIdle;
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
  SimulatorOptions options;
  options.pursuit_distance_m = 10.0;
  const auto simulator = MakeSimulator(RobotAndGoblin(15.0), 1, options);
  RunFor(simulator.get(), 10.0);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kIdle);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kPursued, "goblin"), 0);
}

TEST(AdversaryTest, DoesNotSeeThroughABuilding) {
  TestScene scene = RobotAndGoblin(15.0);
  scene.AddBuilding(8.0, 0.0, 1.0, 10.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 10.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kPursued, "goblin"), 0);
  EXPECT_DOUBLE_EQ(Now(*simulator, "robot").health, 1.0);
}

TEST(AdversaryTest, FogHidesTheRobot) {
  TestScene scene = RobotAndGoblin(15.0);
  scene.atmosphere.visibility_m = 8.0;
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 5.0);
  EXPECT_EQ(Count(simulator->TakeEvents(), EventKind::kPursued, "goblin"), 0);
}

TEST(AdversaryTest, LeavesNeutralAnimalsAndItsOwnKindAlone) {
  TestScene scene;
  scene.AddAgent("sheep", AgentCategory::kSheep, 5.0, 0.0);
  scene.AddAgent("warrior", AgentCategory::kAncientWarrior, 0.0, 5.0);
  scene.AddAgent("goblin", AgentCategory::kGoblin, 0.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 20.0);
  for (const Event& event : simulator->TakeEvents()) EXPECT_NE(event.kind, EventKind::kPursued);
}

TEST(AdversaryTest, KilledRobotDiesOnceObeysNoMoreAndStays) {
  TestScene scene = RobotAndGoblin(4.0);
  scene.AddAgent("warrior", AgentCategory::kAncientWarrior, -4.0, 0.0);
  const auto simulator = MakeSimulator(scene);
  RunFor(simulator.get(), 25.0);
  const AgentSnapshot robot = Now(*simulator, "robot");
  EXPECT_EQ(robot.behaviour, Behaviour::kDead);
  EXPECT_DOUBLE_EQ(robot.health, 0.0);
  const std::vector<Event> events = simulator->TakeEvents();
  EXPECT_EQ(Count(events, EventKind::kDied, "robot"), 1);
  EXPECT_EQ(events.back().kind, EventKind::kDied) << "the dead are left alone";
  RunWith(simulator.get(), 3.0, "robot", Forward(2.0));
  EXPECT_LT((Now(*simulator, "robot").position_m - robot.position_m).norm(), 0.3);
  EXPECT_NE(Now(*simulator, "goblin").behaviour, Behaviour::kAttack);
}

TEST(AdversaryTest, GivesUpWhenTheRobotIsOutOfSightForLong) {
  TestScene scene = RobotAndGoblin(12.0);
  scene.AddBuilding(-10.0, 0.0, 2.0, 8.0);
  SimulatorOptions options;
  options.pursuit_distance_m = 14.0;
  const auto simulator = MakeSimulator(scene, 1, options);
  RunFor(simulator.get(), 0.3);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kPursue);
  ASSERT_TRUE(simulator->Remove("robot").ok());
  RunFor(simulator.get(), 0.3);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kIdle);
}

TEST(AdversaryTest, RemovingItsPreyWhileItStrikesIsHarmless) {
  const auto simulator = MakeSimulator(RobotAndGoblin(2.0));
  RunFor(simulator.get(), 3.0);
  ASSERT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kAttack);
  ASSERT_TRUE(simulator->Remove("robot").ok());
  RunFor(simulator.get(), 5.0);
  EXPECT_EQ(simulator->State()->agents.size(), 1u);
  EXPECT_EQ(Now(*simulator, "goblin").behaviour, Behaviour::kIdle);
}

TEST(AdversaryTest, RoundsABuildingToWhereItLastSawTheRobot) {
  TestScene scene = RobotAndGoblin(14.0);
  scene.AddBuilding(7.0, 2.5, 1.5, 2.0);  // beside the line of sight
  const auto simulator = MakeSimulator(scene);
  double nearest_m = 1e9;
  for (int i = 0; i < 150; ++i) {
    RunFor(simulator.get(), 0.1);
    nearest_m = std::min(nearest_m, GapBetween(*simulator, "robot", "goblin"));
    const AgentSnapshot goblin = Now(*simulator, "goblin");
    ASSERT_FALSE(
        SolidContains(scene.assets[0], {goblin.position_m.x(), goblin.position_m.y()}, 0.3));
  }
  EXPECT_LT(nearest_m, 2.0);
}

}  // namespace
}  // namespace latticeworld
