#include "latticeworld/scene/agents/agent_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>

#include "geometry/in_region.h"
#include "latticeworld/geometry/region.h"
#include "latticeworld/scene/agents/spawn_rules.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

std::shared_ptr<const Terrain> Meadow() {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'G'; };
  return MakeTerrain(ground);
}

SceneAnswer BuildWith(std::shared_ptr<const Terrain> terrain, std::vector<AgentGroup> groups,
                      std::uint64_t seed = 1) {
  EnvironmentConfig environment = MakeEnvironment(0.5);
  environment.agents = std::move(groups);
  return Build(std::move(terrain), environment, seed);
}

bool IsRosName(const std::string& name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

TEST(AgentPlacementTest, EveryGroupStandsLegallyInItsRegionWithLegalNames) {
  const std::vector<AgentGroup> groups = {
      {AgentCategory::kSheep, 9, AgentState::kGrazing, Region::kLowerLeft},
      {AgentCategory::kSheep, 4, AgentState::kIdle, Region::kUpper},
      {AgentCategory::kAncientWarrior, 3, AgentState::kPatrolling, Region::kCenter},
      {AgentCategory::kAerialRobot, 2, AgentState::kFlying, Region::kAnywhere},
      {AgentCategory::kEagle, 2, AgentState::kFlying, Region::kUpperRight}};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SceneAnswer answer = BuildWith(Meadow(), groups, seed);
    const Scene& scene = *answer.scene;
    EXPECT_TRUE(answer.warnings.empty());
    ASSERT_EQ(scene.agents.size(), 21u);  // with the robot
    std::set<std::string> names;
    std::size_t next = 0;
    for (const AgentGroup& group : groups) {
      for (int i = 0; i < group.quantity; ++i) {
        const AgentStart& agent = scene.agents[next++];
        EXPECT_EQ(agent.category, group.category);
        EXPECT_EQ(agent.state, group.state);
        EXPECT_TRUE(IsIn(group.position, scene.geometry(), agent.position));
      }
    }
    for (const AgentStart& agent : scene.agents) {
      EXPECT_TRUE(IsRosName(agent.name)) << agent.name;
      EXPECT_TRUE(names.insert(agent.name).second) << agent.name;
      EXPECT_TRUE(CheckSpawn(scene, scene.atmosphere, agent.category, BodyRadius(agent.category),
                             agent.position)
                      .ok());
      const bool flies = LocomotionOf(agent.category) == Locomotion::kWings;
      EXPECT_EQ(agent.height_above_ground_m > 0.0, flies);
      if (flies) {
        EXPECT_GE(agent.height_above_ground_m, 8.0);
        EXPECT_LE(agent.height_above_ground_m, 15.0);
      }
    }
    EXPECT_EQ(scene.agents[0].name, "sheep_1");
    EXPECT_EQ(scene.agents[9].name, "sheep_10");
    EXPECT_EQ(scene.agents[13].name, "ancient_warrior_1");
  }
}

TEST(AgentPlacementTest, NobodyStandsInWatersThatTheWeatherHasRaised) {
  // All of it can be forded at the mean level, and nothing of it in the rain.
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'G'; };
  ground.water_at_m = [](WorldPoint point) { return point.x_m > -100.0 ? 0.18 : NAN; };
  EnvironmentConfig environment = MakeEnvironment(0.0);
  environment.coarse.weather = Weather::kRain;
  environment.agents = {{AgentCategory::kHorse, 20, AgentState::kIdle, Region::kAnywhere}};
  const SceneAnswer answer = Build(MakeTerrain(ground), environment, 1);
  ASSERT_GT(0.18 + answer.scene->atmosphere.water_rise_m, 0.2);
  ASSERT_EQ(answer.scene->agents.size(), 21u);
  for (const AgentStart& agent : answer.scene->agents) EXPECT_LT(agent.position.x_m, -99.0);
}

TEST(AgentPlacementTest, EveryWorldHasARobotNearItsCentre) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SceneAnswer answer = BuildWith(Meadow(), {}, seed);
    ASSERT_EQ(answer.scene->agents.size(), 1u);
    const AgentStart& robot = answer.scene->agents[0];
    EXPECT_EQ(robot.name, "robot");
    EXPECT_EQ(robot.category, AgentCategory::kWheeledRobot);
    EXPECT_TRUE(robot.controllable);
    EXPECT_EQ(robot.team, 1);
    EXPECT_TRUE(IsIn(Region::kCenter, answer.scene->geometry(), robot.position));
  }
}

TEST(AgentPlacementTest, TheFirstWheeledRobotIsCalledRobot) {
  const SceneAnswer answer =
      BuildWith(Meadow(), {{AgentCategory::kWheeledRobot, 3, AgentState::kIdle, Region::kUpper}});
  ASSERT_EQ(answer.scene->agents.size(), 3u);
  EXPECT_EQ(answer.scene->agents[0].name, "robot");
  EXPECT_EQ(answer.scene->agents[1].name, "wheeled_robot_2");
  EXPECT_EQ(answer.scene->agents[2].name, "wheeled_robot_3");
  for (const AgentStart& agent : answer.scene->agents) EXPECT_TRUE(agent.controllable);
}

TEST(AgentPlacementTest, TeamsSetAnimalsRobotsAndAdversariesApart) {
  EXPECT_EQ(TeamOf(AgentCategory::kSheep), 0);
  EXPECT_EQ(TeamOf(AgentCategory::kWhale), 0);
  EXPECT_EQ(TeamOf(AgentCategory::kRoboticDog), 1);
  EXPECT_EQ(TeamOf(AgentCategory::kWheeledRobot), 1);
  EXPECT_EQ(TeamOf(AgentCategory::kGoblin), 2);
  EXPECT_EQ(TeamOf(AgentCategory::kAncientWarrior), 2);
}

TEST(AgentPlacementTest, GrazingAnimalsStandInAHerd) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto spread_of = [seed](AgentState state) {
      const SceneAnswer answer =
          BuildWith(Meadow(), {{AgentCategory::kSheep, 9, state, Region::kAnywhere}}, seed);
      double sum_m = 0.0;
      for (int i = 0; i < 9; ++i) {
        for (int j = 0; j < i; ++j) {
          const WorldPoint a = answer.scene->agents[i].position;
          const WorldPoint b = answer.scene->agents[j].position;
          sum_m += std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
        }
      }
      return sum_m / 36.0;
    };
    EXPECT_LT(spread_of(AgentState::kGrazing), 25.0);
    EXPECT_GT(spread_of(AgentState::kIdle), 50.0);
  }
}

TEST(AgentPlacementTest, AWhaleWithoutWaterIsAWarningThatSaysWhy) {
  const SceneAnswer answer =
      BuildWith(Meadow(), {{AgentCategory::kWhale, 2, AgentState::kSwimming, Region::kLowerRight}});
  ASSERT_EQ(answer.warnings.size(), 1u);
  EXPECT_NE(answer.warnings[0].find("placed 0 of 2 whale"), std::string::npos);
  EXPECT_NE(answer.warnings[0].find("no water deep enough"), std::string::npos);
  ASSERT_EQ(answer.scene->agents.size(), 1u);
  EXPECT_EQ(answer.scene->agents[0].name, "robot");
}

// A slope of 25 degrees with a level strip in the west: legal for wheels, which slide there.
std::shared_ptr<const Terrain> Slope() {
  TestGround ground;
  ground.letter_at = [](WorldPoint) { return 'G'; };
  ground.height_at_m = [](WorldPoint point) {
    return std::max(0.0, point.x_m + 100.0) * std::tan(25.0 * M_PI / 180.0);
  };
  return MakeTerrain(ground);
}

TEST(AgentPlacementTest, RobotsOnWheelsStandWhereTheyHold) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const SceneAnswer bare = BuildWith(Slope(), {}, seed);
    ASSERT_EQ(bare.scene->agents.size(), 1u);
    EXPECT_LT(bare.scene->agents[0].position.x_m, -99.0) << "the robot that nobody asked for";
    const SceneAnswer asked = BuildWith(
        Slope(), {{AgentCategory::kWheeledRobot, 3, AgentState::kIdle, Region::kAnywhere}}, seed);
    ASSERT_EQ(asked.scene->agents.size(), 3u);
    for (const AgentStart& agent : asked.scene->agents) EXPECT_LT(agent.position.x_m, -99.0);
    EXPECT_TRUE(bare.warnings.empty());
    EXPECT_TRUE(asked.warnings.empty());
  }
}

TEST(AgentPlacementTest, RobotsThatAreAskedForWhereTheySlideAreAWarning) {
  const SceneAnswer answer = BuildWith(
      Slope(), {{AgentCategory::kWheeledRobot, 2, AgentState::kIdle, Region::kMiddleRight}});
  ASSERT_EQ(answer.scene->agents.size(), 2u);
  for (const AgentStart& agent : answer.scene->agents) EXPECT_GT(agent.position.x_m, 0.0);
  ASSERT_EQ(answer.warnings.size(), 1u);
  EXPECT_NE(answer.warnings[0].find("2 wheeled robot agents stand on ground that is steeper than"),
            std::string::npos)
      << answer.warnings[0];
}

TEST(AgentPlacementTest, AWhaleSwimsClearOfTheBed) {
  TestGround ground;
  ground.letter_at = [](WorldPoint point) { return point.x_m < 0.0 ? 'W' : 'G'; };
  ground.height_at_m = [](WorldPoint point) { return point.x_m < 0.0 ? -8.0 : 2.0; };
  ground.water_at_m = [](WorldPoint point) { return point.x_m < 0.0 ? 0.0 : double{NAN}; };
  const SceneAnswer answer = BuildWith(
      MakeTerrain(ground), {{AgentCategory::kWhale, 1, AgentState::kSwimming, Region::kAnywhere}});
  ASSERT_EQ(answer.scene->agents.size(), 2u);
  EXPECT_LT(answer.scene->agents[0].position.x_m, 0.0);
  EXPECT_NEAR(answer.scene->agents[0].height_above_ground_m, 2.0, 1e-6);
  EXPECT_GT(answer.scene->agents[1].position.x_m, 0.0) << "the robot stands on land";
}

TEST(AgentPlacementTest, WhatDoesNotFitIsCounted) {
  // 500 horses need 2.4 m of clearance each; 16 m a side hold far fewer.
  TestGround ground;
  ground.size_m = 16.0;
  ground.cells = 32;
  ground.letter_at = [](WorldPoint) { return 'D'; };
  const SceneAnswer answer = BuildWith(
      MakeTerrain(ground), {{AgentCategory::kHorse, 500, AgentState::kIdle, Region::kAnywhere}});
  ASSERT_FALSE(answer.warnings.empty());
  EXPECT_NE(answer.warnings[0].find("of 500 horse"), std::string::npos) << answer.warnings[0];
  EXPECT_NE(answer.warnings[0].find("another agent is nearer"), std::string::npos);
  EXPECT_GT(answer.scene->agents.size(), 10u);
}

// A pond of 24 m in a meadow, and twenty groups of 500 whales that all want into it.
TEST(AgentPlacementTest, TenThousandInAPondAreCountedGroupByGroup) {
  TestGround ground;
  ground.size_m = 128.0;
  ground.cells = 128;
  const auto is_pond = [](WorldPoint point) { return std::hypot(point.x_m, point.y_m) < 12.0; };
  ground.letter_at = [=](WorldPoint point) { return is_pond(point) ? 'W' : 'G'; };
  ground.height_at_m = [=](WorldPoint point) { return is_pond(point) ? -6.0 : 1.0; };
  ground.water_at_m = [=](WorldPoint point) { return is_pond(point) ? 0.0 : double{NAN}; };
  const SceneAnswer answer = BuildWith(
      MakeTerrain(ground), std::vector<AgentGroup>(20, {AgentCategory::kWhale, 500,
                                                        AgentState::kSwimming, Region::kAnywhere}));
  std::size_t whales = 0;
  for (const AgentStart& agent : answer.scene->agents) {
    if (agent.category != AgentCategory::kWhale) continue;
    ++whales;
    EXPECT_TRUE(is_pond(agent.position));
  }
  EXPECT_GT(whales, 0u);
  EXPECT_LT(whales, 100u);
  ASSERT_EQ(std::count_if(answer.warnings.begin(), answer.warnings.end(),
                          [](const std::string& warning) {
                            return warning.find(" of 500 whale agents: no place") !=
                                   std::string::npos;
                          }),
            20);
  EXPECT_NE(answer.warnings[0].find("there is no water deep enough"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
