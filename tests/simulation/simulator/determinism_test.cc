#include <gtest/gtest.h>

#include <cmath>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

TestScene ThirtyAgents() {
  TestScene scene;
  scene.height_m = Hills(1.5, 30.0);
  for (int i = 0; i < 40; ++i) scene.AddTree(-27.0 + 1.4 * i, 7.0 * ((i * 7) % 8) - 25.6);
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 1.0, 0.0);
  const AgentCategory kinds[] = {AgentCategory::kSheep, AgentCategory::kGoblin,
                                 AgentCategory::kHorse, AgentCategory::kEagle,
                                 AgentCategory::kRoboticDog};
  for (int i = 0; i < 29; ++i) {
    AgentStart& start = scene.AddAgent("agent_" + std::to_string(i), kinds[i % 5],
                                       -22.0 + 8.0 * (i % 6), -20.0 + 8.0 * (i / 6) + 2.0);
    if (i % 5 == 4) start.state = AgentState::kPatrolling;
  }
  return scene;
}

// How many agents of the two are at different places.
int ApartOf(const Simulator& a, const Simulator& b) {
  const auto one = a.State(), other = b.State();
  EXPECT_EQ(one->agents.size(), other->agents.size());
  int apart = 0;
  for (std::size_t i = 0; i < one->agents.size(); ++i) {
    apart += one->agents[i].position_m != other->agents[i].position_m;
  }
  return apart;
}

TEST(DeterminismTest, TwoInOneProcessStayTheSameStepByStep) {
  const TestScene scene = ThirtyAgents();
  const auto one = MakeSimulator(scene, 9), two = MakeSimulator(scene, 9);
  const auto other = MakeSimulator(scene, 10);
  ASSERT_EQ(one->StateHash(), two->StateHash());
  for (int i = 0; i < 1000; ++i) {
    const VelocityCommand command = Forward(1.0 + 0.5 * std::sin(0.01 * i), std::sin(0.02 * i));
    ASSERT_TRUE(one->Command("robot", command).ok());
    ASSERT_TRUE(two->Command("robot", command).ok());
    one->Step();
    other->Step();  // stirs ODE's random state
    two->Step();
    if (i % 100 == 0) {
      ASSERT_EQ(one->StateHash(), two->StateHash()) << "step " << i;
    }
  }
  EXPECT_EQ(one->StateHash(), two->StateHash());
  EXPECT_GT(ApartOf(*one, *other), 10);
}

TEST(DeterminismTest, ResetGivesTheStartOfThatSeedAndTheSameRun) {
  const TestScene scene = ThirtyAgents();
  const auto fresh = MakeSimulator(scene, 4);
  const auto used = MakeSimulator(scene, 3);
  RunFor(used.get(), 3.0);
  SpawnRequest request;
  ASSERT_TRUE(used->Spawn(request).ok());
  ASSERT_TRUE(used->Remove("agent_3").ok());
  const std::uint64_t step_before = used->State()->step;
  used->Reset(4);
  EXPECT_EQ(used->State()->step, step_before);
  EXPECT_EQ(used->State()->episode_step, 0u);
  EXPECT_EQ(used->StateHash(), fresh->StateHash());
  RunFor(used.get(), 5.0);
  RunFor(fresh.get(), 5.0);
  EXPECT_EQ(used->StateHash(), fresh->StateHash());
}

TEST(DeterminismTest, SeedsDiffer) {
  // By where the agents go: hashes hold the seed itself.
  const TestScene scene = ThirtyAgents();
  const auto one = MakeSimulator(scene, 1), same = MakeSimulator(scene, 1);
  const auto other = MakeSimulator(scene, 2);
  EXPECT_EQ(ApartOf(*one, *other), 0);  // they begin at the same places
  for (const auto* simulator : {&one, &same, &other}) RunFor(simulator->get(), 5.0);
  EXPECT_EQ(ApartOf(*one, *same), 0);
  EXPECT_GT(ApartOf(*one, *other), 10);
}

TEST(DeterminismTest, LookingChangesNothing) {
  const TestScene scene = ThirtyAgents();
  const auto one = MakeSimulator(scene, 6), two = MakeSimulator(scene, 6);
  for (int i = 0; i < 200; ++i) {
    one->Step();
    two->Step();
    (void)two->State();
    (void)two->TakeEvents();
    (void)two->StateHash();
  }
  EXPECT_EQ(one->StateHash(), two->StateHash());
}

TEST(DeterminismTest, SnapshotsDoNotChangeAndAreSortedByName) {
  const auto simulator = MakeSimulator(ThirtyAgents());
  RunFor(simulator.get(), 1.0);
  const auto state = simulator->State();
  const Eigen::Vector3d before = state->agents.front().position_m;
  EXPECT_EQ(state, simulator->State());
  RunFor(simulator.get(), 2.0);
  EXPECT_EQ(state->agents.front().position_m, before);
  EXPECT_NE(state, simulator->State());
  for (std::size_t i = 1; i < state->agents.size(); ++i) {
    EXPECT_LT(state->agents[i - 1].name, state->agents[i].name);
  }
}

}  // namespace
}  // namespace latticeworld
