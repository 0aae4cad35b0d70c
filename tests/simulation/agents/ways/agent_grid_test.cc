#include "latticeworld/simulation/agents/ways/agent_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace latticeworld {
namespace {

std::map<AgentId, Agent> Scattered(double size_m, int count, std::uint64_t seed) {
  RandomStream random(seed, "places");
  std::map<AgentId, Agent> agents;
  for (int i = 1; i <= count; ++i) {
    const auto id = static_cast<AgentId>(i);
    Agent agent(id, RandomStream(seed, "agent"));
    agent.motion.position_m = {random.Uniform(-0.5 * size_m, 0.5 * size_m),
                               random.Uniform(-0.5 * size_m, 0.5 * size_m), 0.0};
    agents.emplace(id, agent);
  }
  return agents;
}

std::vector<AgentId> Near(const AgentGrid& grid, WorldPoint point, double radius_m) {
  std::vector<AgentId> ids;
  grid.ForEachNear(point, radius_m, [&](const Agent& agent) { ids.push_back(agent.id); });
  return ids;
}

TEST(AgentGridTest, FindsExactlyThoseWithinTheRadius) {
  for (const double size_m : {16.0, 300.0, 5000.0}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto agents = Scattered(size_m, 200, seed);
      const AgentGrid grid(size_m, agents);
      RandomStream random(seed, "questions");
      for (int i = 0; i < 20; ++i) {
        const WorldPoint point{random.Uniform(-0.6 * size_m, 0.6 * size_m),
                               random.Uniform(-0.6 * size_m, 0.6 * size_m)};
        const double radius_m = random.Uniform(0.0, 0.4 * size_m);
        std::vector<AgentId> expected;
        for (const auto& [id, agent] : agents) {
          const double dx = agent.place().x_m - point.x_m, dy = agent.place().y_m - point.y_m;
          if (dx * dx + dy * dy <= radius_m * radius_m) expected.push_back(id);
        }
        std::vector<AgentId> found = Near(grid, point, radius_m);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << size_m << " m, seed " << seed;
      }
    }
  }
}

TEST(AgentGridTest, AgentsOfOneCellComeInTheOrderOfTheirIds) {
  const auto agents = Scattered(10.0, 50, 3);
  const std::vector<AgentId> found = Near(AgentGrid(16.0, agents), {0.0, 0.0}, 100.0);
  ASSERT_EQ(found.size(), 50u);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
}

TEST(AgentGridTest, HoldsAgentsBeyondTheWorldAndLostOnes) {
  auto agents = Scattered(64.0, 2, 1);
  agents.at(1).motion.position_m = {500.0, -500.0, 0.0};
  agents.at(2).motion.position_m.x() = std::numeric_limits<double>::quiet_NaN();
  const AgentGrid grid(64.0, agents);
  EXPECT_EQ(Near(grid, {499.0, -499.0}, 5.0), std::vector<AgentId>{1});
}

TEST(AgentGridTest, RebuiltItForgetsWhoLeft) {
  AgentGrid grid(64.0, Scattered(64.0, 30, 1));
  const auto few = Scattered(64.0, 3, 2);
  grid.Rebuild(64.0, few);
  EXPECT_EQ(Near(grid, {0.0, 0.0}, 100.0).size(), 3u);
  grid.Rebuild(64.0, {});
  EXPECT_TRUE(Near(grid, {0.0, 0.0}, 100.0).empty());
  EXPECT_TRUE(Near(AgentGrid(), {0.0, 0.0}, 100.0).empty());
}

}  // namespace
}  // namespace latticeworld
