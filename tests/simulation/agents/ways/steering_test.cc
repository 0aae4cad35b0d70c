#include "latticeworld/simulation/agents/ways/steering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/simulation/agents/ways/solid_clearance.h"
#include "simulation/kinematic_world.h"

namespace latticeworld {
namespace {

// Goes there, for at most so long; true once it is within 0.6 m of it.
bool Reaches(KinematicWorld* world, Agent* agent, WorldPoint goal, double seconds,
             double speed_mps) {
  for (double t = 0.0; t < seconds; t += 0.5) {
    world->Run(0.5, [&](Agent* one, Surroundings* surroundings) {
      return one == agent ? GoTo(one, surroundings, goal, speed_mps) : one->mind.steering;
    });
    if (DistanceBetween(agent->place(), goal) < 0.6) return true;
  }
  return false;
}

TEST(SteeringTest, CanStandWhereItsSpeciesCan) {
  TestScene made;
  made.height_m = [](double x, double) { return x > 10.0 ? x - 10.0 : 0.0; };  // 45 degrees
  made.water_depth_m = [](double x, double) { return x < -10.0 ? 0.05 * (-10.0 - x) : 0.0; };
  made.AddTree(0.0, 0.0, 0.3);
  KinematicWorld world(made.Build());
  const Agent& dog = world.Add("robotic dog", 5.0, 0.0);
  const Agent& horse = world.Add("horse", 5.0, 5.0);
  const Surroundings surroundings = world.World();
  EXPECT_TRUE(CanStand(surroundings, dog, {5.0, 0.0}));
  EXPECT_FALSE(CanStand(surroundings, dog, {20.0, 0.0}));
  EXPECT_FALSE(CanStand(surroundings, dog, {0.3 + dog.species->radius_m, 0.0}));
  EXPECT_TRUE(CanStand(surroundings, dog, {0.5 + dog.species->radius_m, 0.0}));
  EXPECT_FALSE(CanStand(surroundings, dog, {-18.0, 0.0}));
  EXPECT_TRUE(CanStand(surroundings, horse, {-18.0, 0.0}));
  EXPECT_FALSE(CanStand(surroundings, dog, {0.0, 31.9}));
  EXPECT_FALSE(CanStand(surroundings, dog, {std::nan(""), 0.0}));
  EXPECT_FALSE(CanGo(surroundings, dog, {5.0, 0.0}, {-5.0, 0.0}));
  EXPECT_TRUE(CanGo(surroundings, dog, {5.0, 3.0}, {-5.0, 3.0}));
}

TEST(SteeringTest, AStemThatLiesIsInTheWay) {
  TestScene made;
  made.AddTree(0.0, -4.0, 0.3);
  const auto scene = made.Build();
  KinematicWorld world(scene);
  const Agent& goblin = world.Add("goblin", -5.0, 0.0);
  EXPECT_TRUE(CanGo(world.World(), goblin, {-5.0, 0.0}, {5.0, 0.0}));
  world.changes().fallen = {{0, {0.0, -4.0, 0.3}, {0.0, 4.0, 0.3}}};
  EXPECT_FALSE(CanGo(world.World(), goblin, {-5.0, 0.0}, {5.0, 0.0}));
  EXPECT_TRUE(CanStand(world.World(), goblin, {3.0, -4.0}));
}

TEST(SteeringTest, FindsItsWayOutOfAPocket) {
  // A U of walls, open to the west, between the agent and its goal: greedy steering stays in it.
  for (const char* species : {"goblin", "sheep", "wheeled robot"}) {
    TestScene made;
    made.AddBuilding(5.0, 0.0, 0.5, 8.0);
    made.AddBuilding(-0.5, 8.5, 6.0, 0.5);
    made.AddBuilding(-0.5, -8.5, 6.0, 0.5);
    KinematicWorld world(made.Build());
    Agent& agent = world.Add(species, 2.0, 0.0);
    EXPECT_TRUE(Reaches(&world, &agent, {15.0, 0.0}, 200.0, agent.species->cruise_mps)) << species;
  }
}

TEST(SteeringTest, CrossesForestsWithoutTouchingATree) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    TestScene made;
    RandomStream random(seed, "trees");
    for (int i = 0; i < 120; ++i)
      made.AddTree(random.Uniform(-30.0, 30.0), random.Uniform(-25.0, 25.0),
                   random.Uniform(0.1, 0.4));
    const auto scene = made.Build();
    KinematicWorld world(scene);
    Agent& agent = world.Add("goblin", 0.0, -29.0);
    double least_m = 1e9;
    bool reached = false;
    for (int i = 0; i < 600 && !reached; ++i) {
      world.Run(0.2, [](Agent* one, Surroundings* surroundings) {
        return GoTo(one, surroundings, {0.0, 29.0}, one->species->cruise_mps);
      });
      for (const Asset& tree : scene->assets)
        least_m = std::min(least_m, SolidDistance(tree, agent.place(), agent.place()));
      reached = DistanceBetween(agent.place(), {0.0, 29.0}) < 0.6;
    }
    EXPECT_TRUE(reached) << seed;
    EXPECT_GT(least_m, agent.species->radius_m - 0.05) << seed;
  }
}

TEST(SteeringTest, ATreeThatFallsAcrossAGapMakesItTakeAnotherWay) {
  TestScene made;
  made.AddBuilding(0.0, 8.0, 0.5, 6.0);  // a wall from y = -22 to 14 with a gap of 4 m
  made.AddBuilding(0.0, -12.0, 0.5, 10.0);
  made.AddTree(0.0, -2.0, 0.3);
  KinematicWorld world(made.Build());
  Agent& agent = world.Add("goblin", -12.0, 0.0);
  EXPECT_FALSE(Reaches(&world, &agent, {12.0, 0.0}, 4.0, 1.2));
  EXPECT_LT(std::abs(agent.place().y_m), 3.0);  // on its way through the gap
  world.changes().fallen = {{2, {0.0, -2.0, 0.3}, {0.0, 6.0, 0.3}}};
  EXPECT_EQ(agent.mind.path.points.size(), 1u);
  EXPECT_FALSE(Reaches(&world, &agent, {12.0, 0.0}, 2.0, 1.2));
  EXPECT_GT(agent.mind.path.points.size(), 1u);  // around the wall's end
  EXPECT_TRUE(Reaches(&world, &agent, {12.0, 0.0}, 45.0, 1.2));
}

TEST(SteeringTest, StandsWhenItIsThereAndWhenItIsShutIn) {
  TestScene made;
  for (const double side : {-1.5, 1.5}) {
    made.AddBuilding(20.0 + side, 0.0, 0.5, 2.0);
    made.AddBuilding(20.0, side, 2.0, 0.5);
  }
  KinematicWorld world(made.Build());
  Agent& there = world.Add("goblin", 0.0, 0.0);
  Agent& shut_in = world.Add("goblin", 20.0, 0.0);
  Surroundings surroundings = world.World();
  EXPECT_EQ(GoTo(&there, &surroundings, {0.1, 0.1}, 1.0).speed_mps, 0.0);
  EXPECT_EQ(GoTo(&shut_in, &surroundings, {0.0, 0.0}, 1.0).speed_mps, 0.0);
}

TEST(SteeringTest, AnAckermannCarBacksUpToReachWhatItCannotCurveTo) {
  KinematicWorld world(TestScene().Build());
  Agent& car = world.Add("ackermann car", 0.0, 0.0);
  ASSERT_GT(TurningRadius(*car.species), 0.3);
  // Beside it, inside of its tightest curve; then right behind it.
  EXPECT_TRUE(Reaches(&world, &car, {0.0, TurningRadius(*car.species)}, 60.0, 1.0));
  const WorldPoint behind = Ahead(car.place(), car.motion.yaw_rad() + M_PI, 6.0);
  EXPECT_TRUE(Reaches(&world, &car, behind, 60.0, 1.0));
}

TEST(SteeringTest, AnAckermannCarBeforeAWallBacksOutAndGoesAround) {
  TestScene made;
  made.AddBuilding(3.0, 0.0, 0.5, 6.0);
  KinematicWorld world(made.Build());
  Agent& car = world.Add("ackermann car", 1.2, 0.0);
  EXPECT_TRUE(Reaches(&world, &car, {12.0, 0.0}, 90.0, 1.0));
}

TEST(SteeringTest, FollowTurnsTowardsTheHeadingWithinTheLimits) {
  KinematicWorld world(TestScene().Build());
  const Agent& goblin = world.Add("goblin", 0.0, 0.0);
  Steering steering;
  steering.speed_mps = 1.0;
  EXPECT_NEAR(Follow(steering, goblin).linear_mps.x(), 1.0, 1e-12);
  steering.heading_rad = 3.0;
  EXPECT_EQ(Follow(steering, goblin).yaw_rate_radps, goblin.species->turn_rate_radps);
  EXPECT_EQ(Follow(steering, goblin).linear_mps.x(), 0.0);  // turns first
  steering.speed_mps = 0.0;
  EXPECT_EQ(Follow(steering, goblin).yaw_rate_radps, 0.0);
}

TEST(SteeringTest, FlyersPassAboveWhatStandsAhead) {
  TestScene made;
  made.AddBuilding(0.0, 0.0, 5.0, 5.0);
  KinematicWorld world(made.Build());
  Agent& eagle = world.Add("eagle", -12.0, 0.0);
  Surroundings surroundings = world.World();
  const Steering steering = GoTo(&eagle, &surroundings, {20.0, 0.0}, 9.0);
  EXPECT_NEAR(*steering.base_z_m, 6.0 + eagle.species->altitude_m, 1e-6);
  EXPECT_NEAR(steering.heading_rad, 0.0, 1e-9);
}

TEST(SteeringTest, WhatKeepsToAPlaceTurnsThereWithoutLeavingIt) {
  KinematicWorld world(TestScene().Build());
  const Agent& eagle = world.Add("eagle", 0.0, 0.0);
  Steering steering;
  steering.heading_rad = 1.5;
  steering.hold = WorldPoint{-2.0, 1.0};
  const VelocityCommand still = Follow(steering, eagle);
  steering.speed_mps = 0.05;
  const VelocityCommand turning = Follow(steering, eagle);
  EXPECT_LT(turning.linear_mps.x(), 0.0);
  EXPECT_EQ(turning.linear_mps, still.linear_mps);
  EXPECT_GT(turning.yaw_rate_radps, 0.0);
}

}  // namespace
}  // namespace latticeworld
