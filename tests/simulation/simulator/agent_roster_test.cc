#include "latticeworld/simulation/simulator/agent_roster.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

Agent Named(AgentId id, const std::string& name) {
  Agent agent(id, RandomStream(1, name));
  agent.name = name;
  agent.motion.position_m = {static_cast<double>(id), 0.0, 0.0};
  return agent;
}

// How many agents are found near the middle.
int Near(const AgentRoster& roster) {
  int near = 0;
  roster.places().ForEachNear({0.0, 0.0}, 20.0, [&near](const Agent&) { ++near; });
  return near;
}

TEST(AgentRosterTest, FindsAgentsByNameAndBody) {
  AgentRoster roster;
  Agent& sheep = roster.Add(Named(1, "sheep"));
  roster.Add(Named(2, "horse"));
  roster.SetBody(7, &sheep);
  ASSERT_TRUE(roster.Find("sheep").ok());
  EXPECT_EQ(*roster.Find("sheep"), &sheep);
  EXPECT_EQ(roster.Find("goat").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(sheep.body, 7u);
  EXPECT_EQ(roster.IdOfBody(7), 1u);
  roster.SetBody(9, &sheep);
  EXPECT_EQ(roster.IdOfBody(7), 0u);
  EXPECT_EQ(roster.IdOfBody(9), 1u);
}

TEST(AgentRosterTest, WhoIsErasedIsFoundByNothing) {
  AgentRoster roster;
  roster.SetBody(7, &roster.Add(Named(1, "sheep")));
  roster.SetBody(8, &roster.Add(Named(2, "horse")));
  roster.BeginStep(64.0);
  ASSERT_EQ(roster.in_step().size(), 2u);
  ASSERT_EQ(Near(roster), 2);
  roster.Erase(1);
  EXPECT_FALSE(roster.Find("sheep").ok());
  EXPECT_EQ(roster.IdOfBody(7), 0u);
  EXPECT_TRUE(roster.in_step().empty());
  EXPECT_EQ(Near(roster), 0);
  roster.BeginStep(64.0);
  ASSERT_EQ(roster.in_step().size(), 1u);
  EXPECT_EQ(roster.in_step()[0]->name, "horse");
  EXPECT_EQ(Near(roster), 1);
}

TEST(AgentRosterTest, ACopyOfAllAgentsBringsNamesAndBodiesBack) {
  AgentRoster roster;
  roster.SetBody(7, &roster.Add(Named(1, "sheep")));
  const std::map<AgentId, Agent> before = roster.all();
  roster.Erase(1);
  roster.SetBody(8, &roster.Add(Named(2, "horse")));
  roster.Restore(before);
  EXPECT_TRUE(roster.Find("sheep").ok());
  EXPECT_FALSE(roster.Find("horse").ok());
  EXPECT_EQ(roster.IdOfBody(7), 1u);
  EXPECT_EQ(roster.IdOfBody(8), 0u);
}

}  // namespace
}  // namespace latticeworld
