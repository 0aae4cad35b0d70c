#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "simulation/battle/battle.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// Hashes of a simulator on its way through all kinds of change.
std::vector<std::string> Churn(Simulator* simulator) {
  std::vector<std::string> hashes;
  for (int i = 0; i < 400; ++i) {
    if (i % 40 == 0) {
      SpawnRequest request;
      request.species = i % 80 == 0 ? "goblin" : "robotic dog";
      request.name = "late_" + std::to_string(i);
      EXPECT_TRUE(simulator->Spawn(request).ok());
    }
    if (i % 80 == 60) {
      EXPECT_TRUE(simulator->Remove("late_" + std::to_string(i - 60)).ok());
    }
    if (i == 100) {
      EXPECT_TRUE(simulator->OpenGate("gate", 0.8).ok());
    }
    if (i == 150) {
      EXPECT_TRUE(simulator->RemoveProp("stone").ok());
    }
    if (i == 200) {
      WeatherChange storm;
      storm.weather = Weather::kSandstorm;
      storm.transition_s = 1.0;
      EXPECT_TRUE(simulator->SetWeather(storm).ok());
    }
    EXPECT_TRUE(simulator->Command("tractor", Forward(8.0)).ok());
    simulator->Step();
    if (i % 20 == 0) hashes.push_back(simulator->StateHash());
  }
  return hashes;
}

TEST(SnapshotTest, EveryRestoredFutureIsTheSame) {
  const auto simulator = BeginBattle(BattleScene(), 3);
  std::vector<std::string> ignored;
  RunBattle(simulator.get(), 600, &ignored);
  const std::string hash = simulator->StateHash();
  const auto snapshot = simulator->Save();
  EXPECT_EQ(simulator->StateHash(), hash);  // taking one changes nothing
  const auto first = Churn(simulator.get());
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(simulator->Restore(*snapshot).ok());
    EXPECT_EQ(simulator->StateHash(), hash);
    EXPECT_EQ(Churn(simulator.get()), first);
  }
  // Also after another episode, and taken over by another simulator.
  simulator->Reset(99);
  RunFor(simulator.get(), 0.5);
  ASSERT_TRUE(simulator->Restore(*snapshot).ok());
  EXPECT_EQ(Churn(simulator.get()), first);
}

TEST(SnapshotTest, StepAndTimeGoOnAndTheRestIsWhatItWas) {
  TestScene scene;
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  const auto simulator = MakeSimulator(scene, 5);
  RunWith(simulator.get(), 1.0, "robot", Forward(1.0));
  const auto before = simulator->State();
  const auto snapshot = simulator->Save();
  RunWith(simulator.get(), 1.0, "robot", Forward(-1.0));
  MustSpawn(simulator.get(), RequestFor("sheep", "sheep", 10.0, 10.0));
  ASSERT_TRUE(simulator->Restore(*snapshot).ok());
  const auto after = simulator->State();
  EXPECT_EQ(after->step, 200u);
  EXPECT_EQ(after->episode_step, 100u);
  ASSERT_EQ(after->agents.size(), 1u);
  EXPECT_EQ(after->agents[0].position_m, before->agents[0].position_m);
  EXPECT_EQ(after->agents[0].linear_velocity_mps, before->agents[0].linear_velocity_mps);
  EXPECT_EQ(simulator->seed(), 5u);
}

TEST(SnapshotTest, OfAnotherWorldOrOtherOptionsIsRefusedAndChangesNothing) {
  TestScene scene;
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0);
  const auto here = MakeSimulator(scene), elsewhere = MakeSimulator(scene);
  SimulatorOptions options;
  options.step_s = 0.005;
  const auto shared = scene.Build();
  const auto coarse = Simulator::Create(shared, {}, 1).value();
  const auto fine = Simulator::Create(shared, options, 1).value();
  const std::string hash = here->StateHash();
  EXPECT_EQ(here->Restore(*elsewhere->Save()).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(fine->Restore(*coarse->Save()).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(here->StateHash(), hash);
}

TEST(SnapshotTest, OutlivesItsSimulator) {
  const auto scene = BattleScene();
  std::shared_ptr<const SimulatorSnapshot> snapshot;
  std::string hash;
  {
    const auto simulator = BeginBattle(scene, 2);
    RunFor(simulator.get(), 0.5);
    snapshot = simulator->Save();
    hash = simulator->StateHash();
  }
  const auto other = Simulator::Create(scene, {}, 77).value();
  ASSERT_TRUE(other->Restore(*snapshot).ok());
  EXPECT_EQ(other->StateHash(), hash);
  EXPECT_EQ(other->seed(), 2u);
  RunFor(other.get(), 0.5);
}

}  // namespace
}  // namespace latticeworld
