#include "latticeworld/simulation/agents/ways/avoidance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "simulation/kinematic_world.h"

namespace latticeworld {
namespace {

using Eigen::Vector2d;

AvoidedBody Standing(double x_m, double y_m, double distance_m = 1.0) {
  AvoidedBody body;
  body.offset_m = {x_m, y_m};
  body.distance_m = distance_m;
  body.share = 1.0;
  return body;
}

// Least distance to a body when both go on as they do, within the horizon [m].
double Closest(const AvoidedBody& body, const Vector2d& velocity_mps, double horizon_s) {
  double closest_m = 1e9;
  for (double t = 0.0; t <= horizon_s; t += 0.01)
    closest_m =
        std::min(closest_m, (body.offset_m + t * (body.velocity_mps - velocity_mps)).norm());
  return closest_m;
}

TEST(AvoidanceTest, WithNobodyInTheWayItIsThePreferredVelocity) {
  AvoidanceOptions options;
  options.top_speed_mps = 2.0;
  EXPECT_EQ(AvoidingVelocity({1.0, 0.0}, {0.5, 1.0}, {}, options), Vector2d(0.5, 1.0));
  EXPECT_NEAR(AvoidingVelocity({1.0, 0.0}, {3.0, 4.0}, {}, options).norm(), 2.0, 1e-12);
  // Behind, or far enough away.
  const Vector2d ahead =
      AvoidingVelocity({1.0, 0.0}, {1.0, 0.0}, {Standing(-1.5, 0.0), Standing(20.0, 0.0)}, options);
  EXPECT_LT((ahead - Vector2d(1.0, 0.0)).norm(), 1e-12);
}

TEST(AvoidanceTest, MissesWhatStandsForTheWholeHorizonAndDeviatesNoMoreThanNeeded) {
  AvoidanceOptions options;
  options.horizon_s = 4.0;
  options.top_speed_mps = 1.5;
  int touched = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomStream random(seed, "one");
    const AvoidedBody body = Standing(random.Uniform(1.5, 5.0), random.Uniform(-2.0, 2.0));
    const Vector2d preferred{random.Uniform(0.5, 1.5), 0.0};
    const Vector2d chosen = AvoidingVelocity(preferred, preferred, {body}, options);
    EXPECT_GT(Closest(body, chosen, options.horizon_s), body.distance_m - 1e-3) << seed;
    EXPECT_LE(chosen.norm(), options.top_speed_mps + 1e-9);
    // No velocity that is free of collisions and nearer to the preferred one, by trial.
    if (Closest(body, preferred, options.horizon_s) >= body.distance_m) {
      EXPECT_LT((chosen - preferred).norm(), 1e-9) << seed;
      continue;
    }
    ++touched;
    // The change of velocity that the paper takes, to the nearest point of the obstacle's rim.
    for (int i = 0; i < 200; ++i) {
      const double angle = random.Uniform(-M_PI, M_PI);
      const Vector2d trial = preferred + 0.8 * (chosen - preferred).norm() *
                                             Vector2d(std::cos(angle), std::sin(angle));
      EXPECT_LT(Closest(body, trial, options.horizon_s), body.distance_m + 0.02) << seed;
    }
  }
  EXPECT_GT(touched, 50);
}

TEST(AvoidanceTest, TwoThatEachDoTheirHalfMissEachOther) {
  AvoidanceOptions options;
  options.horizon_s = 3.0;
  options.top_speed_mps = 2.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomStream random(seed, "two");
    const Vector2d offset{random.Uniform(1.2, 6.0), random.Uniform(-1.0, 1.0)};
    const Vector2d mine{random.Uniform(0.2, 2.0), random.Uniform(-0.5, 0.5)};
    const Vector2d his{-random.Uniform(0.2, 1.9), random.Uniform(-0.5, 0.5)};
    AvoidedBody him, me;
    him.offset_m = offset;
    me.offset_m = -offset;
    him.velocity_mps = his;
    me.velocity_mps = mine;
    him.distance_m = me.distance_m = 1.0;
    const Vector2d my_choice = AvoidingVelocity(mine, mine, {him}, options);
    him.velocity_mps = AvoidingVelocity(his, his, {me}, options);
    EXPECT_GT(Closest(him, my_choice, options.horizon_s), 1.0 - 1e-3) << seed;
  }
}

TEST(AvoidanceTest, InACrowdTheLeastBadIsTakenAndStaysFinite) {
  AvoidanceOptions options;
  options.top_speed_mps = 1.0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    RandomStream random(seed, "crowd");
    std::vector<AvoidedBody> bodies;
    for (int i = 0; i < 10; ++i) {
      // Some overlap, one or the other stands exactly in its place.
      AvoidedBody body = Standing(random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5));
      if (random.Chance(0.05)) body.offset_m.setZero();
      body.velocity_mps = {random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0)};
      bodies.push_back(body);
    }
    const Vector2d chosen = AvoidingVelocity({0.5, 0.0}, {1.0, 0.0}, bodies, options);
    ASSERT_TRUE(chosen.allFinite()) << seed;
    EXPECT_LE(chosen.norm(), 1.0 + 1e-6) << seed;
  }
  // Walled in on all sides by those that close in: no way out is better than standing.
  std::vector<AvoidedBody> ring;
  for (int i = 0; i < 8; ++i) {
    const Vector2d at{std::cos(M_PI / 4 * i), std::sin(M_PI / 4 * i)};
    ring.push_back(Standing(1.2 * at.x(), 1.2 * at.y()));
    ring.back().velocity_mps = -0.5 * at;
  }
  EXPECT_LT(AvoidingVelocity({0.0, 0.0}, {1.0, 0.0}, ring, options).norm(), 0.2);
}

TEST(AvoidanceTest, WhoOverlapsMovesApart) {
  AvoidanceOptions options;
  const Vector2d chosen = AvoidingVelocity({0.0, 0.0}, {1.0, 0.0}, {Standing(0.5, 0.0)}, options);
  EXPECT_LT(chosen.x(), -0.9);
}

Agent& AddWithGoal(KinematicWorld* world, const std::string& species, WorldPoint from,
                   WorldPoint to) {
  Agent& agent = world->Add(species, from.x_m, from.y_m, HeadingTo(from, to));
  agent.mind.goal = to;
  return agent;
}

Steering ToGoal(Agent* agent, Surroundings* world) {
  return GoTo(agent, world, *agent->mind.goal, agent->species->cruise_mps);
}

TEST(AvoidanceTest, TwoHeadOnPassEachOtherOnTheRight) {
  for (const char* species : {"goblin", "sheep", "robotic dog", "wheeled robot"}) {
    KinematicWorld world(TestScene().Build());
    Agent& a = AddWithGoal(&world, species, {-10.0, 0.0}, {10.0, 0.0});
    Agent& b = AddWithGoal(&world, species, {10.0, 0.0}, {-10.0, 0.0});
    double passed_y_m = 0.0;
    for (int i = 0; i < 400 && a.place().x_m < 9.0; ++i) {
      world.Run(0.2, ToGoal);
      if (passed_y_m == 0.0 && a.place().x_m > b.place().x_m)
        passed_y_m = b.place().y_m - a.place().y_m;
    }
    EXPECT_GT(a.place().x_m, 9.0) << species;
    EXPECT_LT(b.place().x_m, -8.0) << species;
    EXPECT_GT(passed_y_m, 0.5) << species;
    EXPECT_GT(world.least_gap_m(), 0.0) << species;
  }
}

TEST(AvoidanceTest, TwentyOnACircleSwapPlaces) {
  KinematicWorld world(TestScene().Build());
  constexpr int kCount = 20;
  constexpr double kRadius_m = 14.0;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2.0 * M_PI * i / kCount;
    const WorldPoint from = Ahead({0.0, 0.0}, angle, kRadius_m);
    AddWithGoal(&world, "goblin", from, {-from.x_m, -from.y_m});
  }
  world.Run(90.0, ToGoal);
  EXPECT_GT(world.least_gap_m(), -0.05);
  for (const auto& [id, agent] : world.agents())
    EXPECT_LT(DistanceBetween(agent.place(), *agent.mind.goal), 1.5) << agent.name;
}

TEST(AvoidanceTest, TheDeadAndTheStandingAreGoneAround) {
  KinematicWorld world(TestScene().Build());
  Agent& goblin = AddWithGoal(&world, "goblin", {-10.0, 0.0}, {10.0, 0.0});
  world.Add("sheep", -4.0, 0.0).hit_points = 0.0;
  AddWithGoal(&world, "horse", {3.0, 0.2}, {3.0, 0.2});
  world.Run(40.0, ToGoal);
  EXPECT_LT(DistanceBetween(goblin.place(), {10.0, 0.0}), 0.5);
  EXPECT_GT(world.least_gap_m(), 0.0);
}

TEST(AvoidanceTest, WhomItIsAfterItDoesNotAvoid) {
  KinematicWorld world(TestScene().Build());
  Agent& goblin = world.Add("goblin", -5.0, 0.0);
  Agent& victim = world.Add("sheep", 5.0, 0.0);
  goblin.mind.target = victim.id;
  world.Run(15.0, [&](Agent* agent, Surroundings* surroundings) {
    return agent == &goblin ? GoTo(agent, surroundings, victim.place(), 1.2) : Steering();
  });
  EXPECT_LT(world.least_gap_m(), 0.0);
}

}  // namespace
}  // namespace latticeworld
