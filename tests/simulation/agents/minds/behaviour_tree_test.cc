#include "latticeworld/simulation/agents/minds/behaviour_tree.h"

#include <gtest/gtest.h>

#include "simulation/agents/minds/mind_world.h"

namespace latticeworld {
namespace {

std::optional<Steering> Slow(Agent*, Surroundings*) {
  Steering steering;
  steering.speed_mps = 1.0;
  return steering;
}
std::optional<Steering> Fast(Agent*, Surroundings*) {
  Steering steering;
  steering.speed_mps = 2.0;
  return steering;
}
std::optional<Steering> NotNow(Agent*, Surroundings*) { return std::nullopt; }
bool IsOfTeamOne(const Agent& agent, const Surroundings&) { return agent.team == 1; }

// first of {when of team one -> fast, not now, slow}
Piece SmallTree() {
  std::vector<Piece> pieces;
  pieces.push_back(When("when of team one", IsOfTeamOne, Do("fast", Fast)));
  pieces.push_back(Do("not now", NotNow));
  pieces.push_back(Do("slow", Slow));
  return FirstOf(std::move(pieces));
}

TEST(BehaviourTreeTest, TheFirstPieceThatDecidesDecides) {
  MindWorld world({});
  Agent& agent = world.Add("sheep", 0, 0.0, 0.0);
  const Piece tree = SmallTree();
  ASSERT_TRUE(tree->Try(&agent, &world.Now()).has_value());
  EXPECT_DOUBLE_EQ(tree->Try(&agent, &world.Now())->speed_mps, 1.0);
  agent.team = 1;
  EXPECT_DOUBLE_EQ(tree->Try(&agent, &world.Now())->speed_mps, 2.0)
      << "a tree is asked anew from its root at every thought";
}

TEST(BehaviourTreeTest, DecidesNothingWhenNoPieceDoes) {
  MindWorld world({});
  Agent& agent = world.Add("sheep", 0, 0.0, 0.0);
  std::vector<Piece> pieces;
  pieces.push_back(Do("not now", NotNow));
  pieces.push_back(When("when of team one", IsOfTeamOne, Do("fast", Fast)));
  EXPECT_FALSE(FirstOf(std::move(pieces))->Try(&agent, &world.Now()).has_value());
  EXPECT_FALSE(FirstOf({})->Try(&agent, &world.Now()).has_value());
}

TEST(BehaviourTreeTest, DrawsItself) {
  EXPECT_EQ(DrawTree(*SmallTree()),
            "flowchart LR\n"
            "  n0[\"first of\"]\n"
            "  n1{{\"when of team one\"}}\n"
            "  n2([\"fast\"])\n"
            "  n1 --> n2\n"
            "  n0 --> n1\n"
            "  n3([\"not now\"])\n"
            "  n0 --> n3\n"
            "  n4([\"slow\"])\n"
            "  n0 --> n4\n");
}

}  // namespace
}  // namespace latticeworld
