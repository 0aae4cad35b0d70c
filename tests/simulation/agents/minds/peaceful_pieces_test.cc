#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/pieces_peaceful.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "simulation/agents/minds/mind_world.h"

namespace latticeworld {
namespace {

TestScene Wide() {
  TestScene scene;
  scene.size_m = 128.0;
  return scene;
}

TEST(PeacefulPiecesTest, WanderersGoFromPlaceToPlaceAndRestInBetween) {
  MindWorld world(Wide());
  Agent& robot = world.Add("humanoid robot", 1, 0.0, 0.0);
  std::set<std::pair<int, int>> squares;  // of 5 m, that it has been in
  int moved = 0, stood = 0;
  for (int i = 0; i < 1200; ++i) {
    world.Run(0.1, {{robot.id, "wanderer"}});
    ASSERT_EQ(robot.behaviour, Behaviour::kWander);
    squares.insert({static_cast<int>(std::floor(robot.place().x_m / 5.0)),
                    static_cast<int>(std::floor(robot.place().y_m / 5.0))});
    (robot.motion.linear_velocity_mps.norm() > 0.3 ? moved : stood) += 1;
  }
  EXPECT_GE(squares.size(), 8u);
  EXPECT_GT(moved, 600);
  EXPECT_GT(stood, 60);
}

TEST(PeacefulPiecesTest, IdlersGoBackHomeFromFarAndStayNearIt) {
  MindWorld world(Wide());
  Agent& robot = world.Add("humanoid robot", 1, 0.0, 0.0);
  robot.motion.position_m = {2.0, 0.0, 0.0};
  world.Run(5.0, {{robot.id, "idler"}});
  EXPECT_NEAR(robot.place().x_m, 2.0, 1e-6) << "a step aside is no matter";
  robot.motion.position_m = {12.0, -5.0, 0.0};
  world.Run(20.0, {{robot.id, "idler"}});
  EXPECT_EQ(robot.behaviour, Behaviour::kIdle);
  EXPECT_LT(DistanceBetween(robot.place(), {0.0, 0.0}), 1.1);
}

TEST(PeacefulPiecesTest, PatrollersWalkTheSameLoopAgainAndAgain) {
  MindWorld world(Wide());
  Agent& robot = world.Add("humanoid robot", 1, 0.0, 0.0);
  const std::vector<WorldPoint> route = {
      {10.0, 0.0}, {10.0, 10.0}, {-5.0, 10.0}, {-5.0, -5.0}, {0.0, -8.0}};
  robot.mind.route = route;
  std::vector<std::size_t> visited;  // corners of the route, in order
  for (int i = 0; i < 1500; ++i) {
    world.Run(0.1, {{robot.id, "patroller"}});
    ASSERT_EQ(robot.behaviour, Behaviour::kPatrol);
    for (std::size_t k = 0; k < route.size(); ++k) {
      const bool again = !visited.empty() && visited.back() == k;
      if (!again && DistanceBetween(robot.place(), route[k]) < 1.3) visited.push_back(k);
    }
  }
  ASSERT_GE(visited.size(), 2 * route.size());
  for (std::size_t i = 0; i < visited.size(); ++i) EXPECT_EQ(visited[i], i % route.size());
  EXPECT_EQ(robot.mind.route.size(), route.size()) << "a whole route stays as it is";
}

TEST(PeacefulPiecesTest, WingsFinsAndFeetDoWhatTheyCan) {
  MindWorld world(Wide());
  Agent& eagle = world.Add("eagle", 0, 0.0, 0.0);
  Agent& sheep = world.Add("sheep", 0, 10.0, 0.0);
  EXPECT_TRUE(Soar(&eagle, &world.Now()).has_value());
  EXPECT_FALSE(Graze(&eagle, &world.Now()).has_value());
  EXPECT_FALSE(Swim(&eagle, &world.Now()).has_value());
  EXPECT_FALSE(Soar(&sheep, &world.Now()).has_value());
  EXPECT_FALSE(Swim(&sheep, &world.Now()).has_value());
  EXPECT_TRUE(Graze(&sheep, &world.Now()).has_value());
}

TEST(HuntPiecesTest, PursuersLookIntoANoiseBehindThem) {
  MindWorld world(Wide());
  Agent& goblin = world.Add("goblin", 2, 0.0, 0.0);
  Agent& robot = world.Add("humanoid robot", 1, -14.0, 0.0);
  robot.controllable = true;
  // It runs on the spot behind the goblin's back.
  bool searched = false;
  for (int i = 0; i < 20 && !searched; ++i) {
    robot.motion.linear_velocity_mps = {2.0, 0.0, 0.0};
    world.Run(0.1, {{goblin.id, "pursuer"}});
    robot.motion.position_m = {-14.0, 0.0, 0.0};
    searched = goblin.behaviour == Behaviour::kSearch;
  }
  EXPECT_TRUE(searched);
  for (int i = 0; i < 60 && goblin.behaviour != Behaviour::kPursue; ++i) {
    robot.motion.linear_velocity_mps = {2.0, 0.0, 0.0};
    world.Run(0.1, {{goblin.id, "pursuer"}});
    robot.motion.position_m = {-14.0, 0.0, 0.0};
  }
  EXPECT_EQ(goblin.behaviour, Behaviour::kPursue) << "it turned round and saw";
}

}  // namespace
}  // namespace latticeworld
