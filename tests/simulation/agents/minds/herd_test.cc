#include "latticeworld/simulation/agents/minds/herd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/simulation/agents/ways/steering.h"
#include "simulation/kinematic_world.h"

namespace latticeworld {
namespace {

Steering WithTheHerd(Agent* agent, Surroundings* world) {
  const Eigen::Vector2d drawn = Flocking(*agent, *world);
  Steering stands;
  stands.heading_rad = agent->motion.yaw_rad();
  if (drawn.norm() < 0.2) return stands;
  const WorldPoint place = Ahead(agent->place(), std::atan2(drawn.y(), drawn.x()), 3.0);
  return GoTo(agent, world, place, drawn.norm() * agent->species->cruise_mps);
}

// Mean distance from the middle of all [m].
double Spread(const std::map<AgentId, Agent>& agents) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& [id, agent] : agents) middle += agent.motion.position_m.head<2>();
  middle /= static_cast<double>(agents.size());
  double sum_m = 0.0;
  for (const auto& [id, agent] : agents)
    sum_m += (agent.motion.position_m.head<2>() - middle).norm();
  return sum_m / static_cast<double>(agents.size());
}

TEST(HerdTest, AloneItIsContent) {
  KinematicWorld world(TestScene().Build());
  Agent& sheep = world.Add("sheep", 0.0, 0.0);
  world.Add("horse", 0.5, 0.0);
  world.Add("sheep", 0.0, 0.5).hit_points = 0.0;
  EXPECT_EQ(Flocking(sheep, world.World()), Eigen::Vector2d::Zero());
}

TEST(HerdTest, SeparatesAlignsAndGathers) {
  const auto drawn = [](double x_m, double y_m, Eigen::Vector3d velocity_mps) {
    KinematicWorld world(TestScene().Build());
    Agent& sheep = world.Add("sheep", 0.0, 0.0);
    world.Add("sheep", x_m, y_m).motion.linear_velocity_mps = velocity_mps;
    return Flocking(sheep, world.World());
  };
  EXPECT_LT(drawn(1.3, 0.0, {0.0, 0.0, 0.0}).x(), -0.3);          // too close
  EXPECT_EQ(drawn(4.0, 0.0, {0.0, 0.0, 0.0}).norm(), 0.0);        // well together
  EXPECT_GT(drawn(4.0, 0.0, {0.0, 0.6, 0.0}).y(), 0.3);           // goes along
  EXPECT_NEAR(drawn(20.0, 0.0, {0.0, 0.0, 0.0}).x(), 1.0, 1e-9);  // back to the herd
  // Whatever is wanted at once, its length is at most 1.
  EXPECT_LE(drawn(1.25, 0.0, {3.0, 3.0, 0.0}).norm(), 1.0 + 1e-9);
}

TEST(HerdTest, AScatteredHerdGathersAndNobodyCollides) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    KinematicWorld world(TestScene().Build(), seed);
    RandomStream random(seed, "herd");
    for (int i = 0; i < 12; ++i)
      world.Add("sheep", random.Uniform(-25.0, 25.0), random.Uniform(-25.0, 25.0),
                random.Uniform(-3.0, 3.0));
    if (world.least_gap_m() < 0.0) continue;
    const double before_m = Spread(world.agents());
    world.Run(60.0, WithTheHerd);
    EXPECT_LT(Spread(world.agents()), 0.6 * before_m) << "seed " << seed;
    EXPECT_LT(Spread(world.agents()), 12.0) << "seed " << seed;
    EXPECT_GT(world.least_gap_m(), 0.0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace latticeworld
