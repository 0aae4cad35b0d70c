#include "latticeworld/episode/replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/episode/journal_json.h"
#include "latticeworld/episode/world_files.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld/simulation/journaled_simulator.h"

namespace latticeworld {
namespace {

constexpr std::uint64_t kSeed = 5;

// A generated world with agents that act, trees and water.
const World& TheWorld() {
  static const std::shared_ptr<const World> world = [] {
    GenerationRequest request;
    request.layout_instruction = "A lake in the lower left, forest in the upper left.";
    request.environment_instruction =
        "Rain. Three sheep graze in the upper right, two goblins patrol near the center, and a "
        "wheeled robot waits in the lower right.";
    request.seed = 11;
    request.size_m = 64.0;
    request.resolution_m = 0.5;
    auto generated = MakeDefaultWorldGenerator().Generate(request, Progress());
    EXPECT_TRUE(generated.ok()) << generated.status().ToString();
    return *generated;
  }();
  return *world;
}

// A simulation that is recorded as world_server does it.
class Recording {
 public:
  explicit Recording(std::uint64_t seed = kSeed)
      : simulator_(*Simulator::Create(TheWorld().scene, SimulatorOptions(), seed)) {
    Hash();
  }

  void Steps(int count) {
    for (int i = 0; i < count; ++i) simulator_.Step();
    Hash();
  }
  void Hash() {
    plan_.hashes.push_back({simulator_.steps(), simulator_.last_number(), simulator_.StateHash()});
  }
  void Drive(double forward_mps, int steps) {
    for (int i = 0; i < steps; ++i) {
      if (i % 10 == 0) {
        EXPECT_TRUE(simulator_.Command("robot", {{forward_mps, 0.0, 0.0}, 0.2}).ok());
      }
      simulator_.Step();
    }
    Hash();
  }
  ReplayPlan Plan() {
    plan_.beginning = simulator_.beginning();
    plan_.calls = simulator_.entries();
    return plan_;
  }
  JournaledSimulator& simulator() { return simulator_; }

 private:
  JournaledSimulator simulator_;
  ReplayPlan plan_;
};

// Commands, agents and props that come and go, a gate, weather, a policy, a strike, a snapshot.
void ActEverything(Recording* recording) {
  JournaledSimulator& simulator = recording->simulator();
  recording->Drive(0.7, 60);
  SpawnRequest warrior;
  warrior.category = AgentCategory::kAncientWarrior;
  warrior.team = 3;
  warrior.policy = "pursuer";
  ASSERT_TRUE(simulator.Spawn(warrior).ok());
  SpawnRequest rover;
  rover.name = "rover";
  rover.category = AgentCategory::kWheeledRobot;
  rover.controllable = true;
  ASSERT_TRUE(simulator.Spawn(rover).ok());
  Prop gate;
  gate.kind = PropKind::kGate;
  gate.size_m = {2.0, 0.1, 1.0};
  gate.mass_kg = 20.0;
  bool placed = false;
  for (double x_m = -24.0; x_m < 28.0 && !placed; x_m += 3.0) {
    gate.position = {x_m, 10.0};
    placed = simulator.SpawnProp(gate).ok();
  }
  ASSERT_TRUE(placed);
  recording->Steps(20);
  ASSERT_TRUE(simulator.OpenGate("gate_1", 1.0).ok());
  ASSERT_TRUE(simulator.CommandJoints("rover", {{"front_left_wheel", NAN, 2.0, NAN}}).ok());
  WeatherChange storm;
  storm.weather = Weather::kSandstorm;
  storm.transition_s = 0.5;
  ASSERT_TRUE(simulator.SetWeather(storm).ok());
  recording->Drive(-0.4, 40);
  const auto snapshot = simulator.Save();
  recording->Steps(30);
  ASSERT_TRUE(simulator.Remove("rover").ok());
  ASSERT_TRUE(simulator.SetPolicy({"", 2, "pursuer"}).ok());
  recording->Steps(30);
  ASSERT_TRUE(simulator.Restore(*snapshot).ok());
  recording->Hash();
  recording->Steps(30);
  ASSERT_TRUE(simulator.RemoveProp("gate_1").ok());
  recording->Drive(0.3, 30);
}

Result<ReplayReport> ReplayHere(const ReplayPlan& plan) {
  return Replay(TheWorld().scene, SimulatorOptions(), plan, Progress());
}

// As it comes out of a bag: every call by way of its text.
ReplayPlan ThroughText(ReplayPlan plan) {
  for (JournalEntry& entry : plan.calls) {
    auto call = DecodeCall(EncodeCall(entry.call));
    EXPECT_TRUE(call.ok()) << call.status().ToString();
    if (call.ok()) entry.call = *std::move(call);
  }
  return plan;
}

TEST(ReplayTest, AWorldOfItsFilesGoesTheWayThatTheGeneratedOneWent) {
  Recording recording;
  ActEverything(&recording);
  const ReplayPlan plan = ThroughText(recording.Plan());
  const auto files = PackWorld(TheWorld());
  ASSERT_TRUE(files.ok()) << files.status().ToString();
  const auto world = UnpackWorld(*files);
  ASSERT_TRUE(world.ok()) << world.status().ToString();
  const auto report = Replay((*world)->scene, SimulatorOptions(), plan, Progress());
  ASSERT_TRUE(report.ok()) << report.status().ToString();
  EXPECT_FALSE(report->divergence)
      << report->divergence->failure << " at step " << report->divergence->recorded.step;
  EXPECT_EQ(report->hashes, plan.hashes.size());
  EXPECT_EQ(report->calls, plan.calls.size());
  EXPECT_EQ(report->skipped, 0u);
  EXPECT_EQ(report->steps, plan.hashes.back().step);
}

TEST(ReplayTest, AResetIsABeginningOfItsOwn) {
  Recording recording;
  recording.Drive(0.7, 30);
  recording.simulator().Reset(9);
  recording.Hash();
  recording.Drive(0.7, 30);
  const ReplayPlan plan = recording.Plan();
  EXPECT_EQ(plan.beginning.seed, 9u);
  EXPECT_EQ(plan.beginning.step, 30u);
  const auto report = ReplayHere(plan);
  ASSERT_TRUE(report.ok()) << report.status().ToString();
  EXPECT_FALSE(report->divergence);
  EXPECT_EQ(report->skipped, 2u);  // of before the reset
  EXPECT_EQ(report->hashes, 2u);
}

TEST(ReplayTest, TheLeastChangeOfACommandIsFound) {
  Recording recording;
  recording.Drive(0.7, 30);
  recording.Drive(0.7, 30);
  ReplayPlan plan = recording.Plan();
  auto& command = std::get<CommandCall>(plan.calls[4].call);
  ASSERT_EQ(plan.calls[4].step, 40u);
  command.command.linear_mps.x() = std::nextafter(command.command.linear_mps.x(), 1.0);
  const auto report = ReplayHere(plan);
  ASSERT_TRUE(report.ok()) << report.status().ToString();
  ASSERT_TRUE(report->divergence);
  EXPECT_EQ(report->divergence->recorded.step, 60u);
  ASSERT_TRUE(report->divergence->last_agreed);
  EXPECT_EQ(report->divergence->last_agreed->step, 30u);
  EXPECT_EQ(report->divergence->state_hash.size(), 64u);
}

TEST(ReplayTest, AnotherSeedIsFoundAtOnce) {
  Recording recording;
  recording.Steps(10);
  ReplayPlan plan = recording.Plan();
  plan.beginning.seed = kSeed + 1;
  const auto report = ReplayHere(plan);
  ASSERT_TRUE(report.ok());
  ASSERT_TRUE(report->divergence);
  EXPECT_EQ(report->divergence->recorded.step, 0u);
  EXPECT_FALSE(report->divergence->last_agreed);
}

TEST(ReplayTest, ACallThatFailsIsWhereTheWaysPart) {
  Recording recording;
  recording.Drive(0.7, 20);
  ReplayPlan plan = recording.Plan();
  std::get<CommandCall>(plan.calls[1].call).agent = "nobody";
  const auto report = ReplayHere(plan);
  ASSERT_TRUE(report.ok());
  ASSERT_TRUE(report->divergence);
  EXPECT_NE(report->divergence->failure.find("call 2"), std::string::npos);
  EXPECT_NE(report->divergence->failure.find("nobody"), std::string::npos);
}

TEST(ReplayTest, WhatIsMissingIsNamed) {
  Recording recording;
  recording.Drive(0.7, 40);
  ReplayPlan gap = recording.Plan();
  gap.calls.erase(gap.calls.begin() + 1);
  EXPECT_EQ(ReplayHere(gap).status().code(), StatusCode::kDataLoss);
  EXPECT_NE(ReplayHere(gap).status().message().find("call 2 is missing"), std::string::npos);
  ReplayPlan end = recording.Plan();
  end.calls.pop_back();
  EXPECT_NE(ReplayHere(end).status().message().find("call 4 is missing"), std::string::npos);
  ReplayPlan mixed = recording.Plan();
  std::swap(mixed.hashes[0], mixed.hashes[1]);
  EXPECT_EQ(ReplayHere(mixed).status().code(), StatusCode::kDataLoss);
}

TEST(ReplayTest, ASnapshotOfBeforeTheBeginningCannotBeRestored) {
  Recording recording;
  recording.Steps(5);
  ReplayPlan plan = recording.Plan();
  plan.calls.push_back({1, 5, RestoreCall{1}});
  plan.hashes.push_back({5, 1, plan.hashes.back().state_hash});
  const auto report = ReplayHere(plan);
  ASSERT_TRUE(report.ok());
  ASSERT_TRUE(report->divergence);
  EXPECT_NE(report->divergence->failure.find("snapshot 1"), std::string::npos);
}

TEST(ReplayTest, WhatIsProvenReachesToTheLastHash) {
  Recording recording;
  recording.Drive(0.7, 30);
  ReplayPlan plan = recording.Plan();
  plan.steps = {0, 0, 50};
  const auto report = ReplayHere(plan);
  ASSERT_TRUE(report.ok()) << report.status().ToString();
  EXPECT_TRUE(IsProven(*report, plan.steps));
  EXPECT_EQ(ProofText(*report, plan.steps),
            "PROVEN: 2 of 2 recorded states are the same, bit for bit; the last of them is after "
            "30 of 50 recorded steps");
  plan.calls.push_back({plan.calls.back().number + 1, 40, plan.calls.back().call});
  const std::string text = ProofText(*ReplayHere(plan), plan.steps);
  EXPECT_NE(text.find("; calls after it: 1"), std::string::npos) << text;
}

TEST(ReplayTest, TheHashOfTheBeginningAloneProvesNothing) {
  Recording recording;
  recording.Steps(30);
  ReplayPlan plan = recording.Plan();
  plan.hashes.resize(1);
  plan.steps = {0, 0, 30};
  const auto report = ReplayHere(plan);
  ASSERT_TRUE(report.ok()) << report.status().ToString();
  EXPECT_FALSE(IsProven(*report, plan.steps));
  const std::string text = ProofText(*report, plan.steps);
  EXPECT_EQ(text.rfind("NO PROOF", 0), 0u) << text;
  EXPECT_NE(text.find("the 30 recorded steps"), std::string::npos) << text;
}

TEST(ReplayTest, TheHashOfTheBeginningProvesAnEpisodeOfNoSteps) {
  const RecordedSteps none;
  const auto report = ReplayHere(Recording().Plan());
  ASSERT_TRUE(report.ok()) << report.status().ToString();
  EXPECT_TRUE(IsProven(*report, none));
}

TEST(ReplayTest, ACancelEndsIt) {
  Recording recording;
  recording.Steps(1000);
  Progress progress;
  progress.Cancel();
  const auto report = Replay(TheWorld().scene, SimulatorOptions(), recording.Plan(), progress);
  EXPECT_EQ(report.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
