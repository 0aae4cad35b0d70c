#include "latticeworld/simulation/journaled_simulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

TestScene Scenery() {
  TestScene scene;
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0).controllable = true;
  scene.AddAgent("goblin_1", AgentCategory::kGoblin, 12.0, 0.0);
  scene.AddProp("gate", PropKind::kGate, 0.0, 15.0);
  return scene;
}

std::unique_ptr<JournaledSimulator> Journaled(std::size_t max_bytes = kMaxJournalBytes) {
  return std::make_unique<JournaledSimulator>(MakeSimulator(Scenery(), 3), 7, max_bytes);
}

TEST(JournaledSimulatorTest, EveryCallThatSucceedsIsWrittenDownWithItsMoment) {
  const auto simulator = Journaled();
  EXPECT_TRUE(simulator->Command("robot", Forward(1.0)).ok());
  simulator->Step();
  simulator->Step();
  EXPECT_TRUE(simulator->CommandJoints("robot", {{"front_left_wheel", NAN, 1.0, NAN}}).ok());
  EXPECT_TRUE(simulator->SetPolicy({"goblin_1", std::nullopt, "ambusher"}).ok());
  const auto name = simulator->Spawn(RequestFor("goblin", "", -8.0, 8.0));
  ASSERT_TRUE(name.ok()) << name.status().ToString();
  EXPECT_TRUE(simulator->Remove(*name).ok());
  Prop crate;
  crate.position = {8.0, -8.0};
  crate.mass_kg = 20.0;
  const auto crate_name = simulator->SpawnProp(crate);
  ASSERT_TRUE(crate_name.ok()) << crate_name.status().ToString();
  EXPECT_TRUE(simulator->RemoveProp(*crate_name).ok());
  EXPECT_TRUE(simulator->OpenGate("gate", 0.5).ok());
  WeatherChange rain;
  rain.weather = Weather::kRain;
  EXPECT_TRUE(simulator->SetWeather(rain).ok());

  const std::vector<JournalEntry>& entries = simulator->entries();
  ASSERT_EQ(entries.size(), 9u);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].number, i + 1);
    EXPECT_EQ(entries[i].step, i == 0 ? 0u : 2u);
  }
  EXPECT_EQ(std::get<CommandCall>(entries[0].call).agent, "robot");
  EXPECT_EQ(std::get<SpawnCall>(entries[3].call).answer, *name);
  EXPECT_EQ(std::get<SpawnPropCall>(entries[5].call).answer, *crate_name);
  EXPECT_EQ(std::get<OpenGateCall>(entries[7].call).opening_rad, 0.5);
  EXPECT_EQ(simulator->last_number(), 9u);
  EXPECT_EQ(simulator->run(), 7u);
}

TEST(JournaledSimulatorTest, WhatIsRefusedChangesNothingAndIsNotTold) {
  const auto simulator = Journaled();
  const std::string before = simulator->StateHash();
  EXPECT_FALSE(simulator->Command("nobody", Forward(1.0)).ok());
  EXPECT_FALSE(simulator->Command("robot", Forward(NAN)).ok());
  EXPECT_FALSE(simulator->CommandJoints("robot", {{"tail", 0.0, NAN, NAN}}).ok());
  EXPECT_FALSE(simulator->Strike("nobody").ok());
  EXPECT_FALSE(simulator->SetPolicy({"goblin_1", 2, "pursuer"}).ok());
  EXPECT_FALSE(simulator->Spawn(RequestFor("goblin", "robot", 5.0, 5.0)).ok());
  EXPECT_FALSE(simulator->Remove("nobody").ok());
  EXPECT_FALSE(simulator->RemoveProp("nothing").ok());
  EXPECT_FALSE(simulator->OpenGate("gate", 99.0).ok());
  WeatherChange wrong;
  wrong.visibility_m = -1.0;
  EXPECT_FALSE(simulator->SetWeather(wrong).ok());
  EXPECT_FALSE(simulator->Restore(*MakeSimulator(Scenery(), 3)->Save()).ok());
  EXPECT_TRUE(simulator->entries().empty());
  EXPECT_FALSE(simulator->has_new());
  EXPECT_EQ(simulator->StateHash(), before);
}

TEST(JournaledSimulatorTest, WhatIsNewIsHandedOutOnce) {
  const auto simulator = Journaled();
  EXPECT_TRUE(simulator->Command("robot", Forward(1.0)).ok());
  EXPECT_TRUE(simulator->Command("robot", Forward(2.0)).ok());
  EXPECT_TRUE(simulator->has_new());
  EXPECT_EQ(simulator->TakeNew().size(), 2u);
  EXPECT_FALSE(simulator->has_new());
  EXPECT_TRUE(simulator->Command("robot", Forward(3.0)).ok());
  const std::vector<JournalEntry> entries = simulator->TakeNew();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].number, 3u);
  EXPECT_EQ(simulator->entries().size(), 3u);
}

TEST(JournaledSimulatorTest, AResetIsWhereTheJournalBeginsAnew) {
  const auto simulator = Journaled();
  EXPECT_EQ(simulator->beginning().seed, 3u);
  EXPECT_TRUE(simulator->Command("robot", Forward(1.0)).ok());
  simulator->Step();
  simulator->Reset(11);
  EXPECT_TRUE(simulator->entries().empty());
  EXPECT_EQ(simulator->beginning().seed, 11u);
  EXPECT_EQ(simulator->beginning().number, 2u);
  EXPECT_EQ(simulator->beginning().step, 1u);
  // Whoever listens hears both.
  EXPECT_EQ(simulator->TakeNew().size(), 2u);
}

TEST(JournaledSimulatorTest, CallsStayAsLongAsASnapshotOfThemMayBeRestored) {
  const auto simulator = Journaled();
  EXPECT_TRUE(simulator->Command("robot", Forward(1.0)).ok());
  auto snapshot = simulator->Save();
  simulator->Reset(11);
  EXPECT_EQ(simulator->beginning().number, 0u);
  EXPECT_EQ(simulator->entries().size(), 3u);  // the command, the snapshot, the reset
  EXPECT_TRUE(simulator->Restore(*snapshot).ok());
  EXPECT_EQ(simulator->entries().size(), 4u);
  EXPECT_TRUE(simulator->complete());
  snapshot.reset();
  simulator->Reset(12);
  EXPECT_TRUE(simulator->entries().empty());
  EXPECT_EQ(simulator->beginning().number, 5u);
}

TEST(JournaledSimulatorTest, TooManyCallsAreForgottenUntilTheNextReset) {
  const auto simulator = Journaled(/*max_bytes=*/4000);
  const auto snapshot = simulator->Save();
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(simulator->Command("robot", Forward(1.0)).ok());
  EXPECT_FALSE(simulator->complete());
  EXPECT_TRUE(simulator->entries().empty());
  EXPECT_LT(simulator->TakeNew().size(), 100u);
  simulator->Reset(4);
  EXPECT_TRUE(simulator->complete());
  EXPECT_EQ(simulator->beginning().number, 102u);
  // Of before what the journal begins with.
  EXPECT_TRUE(simulator->Restore(*snapshot).ok());
  EXPECT_FALSE(simulator->complete());
}

TEST(JournaledSimulatorTest, ThePlayerReachesTheSameStateByWayOfASnapshot) {
  const auto simulator = Journaled();
  EXPECT_TRUE(simulator->Command("robot", Forward(1.0)).ok());
  const auto snapshot = simulator->Save();
  EXPECT_TRUE(simulator->SetPolicy({"", 2, "ambusher"}).ok());
  EXPECT_TRUE(simulator->Restore(*snapshot).ok());
  const auto other = MakeSimulator(Scenery(), 3);
  JournalPlayer player(other.get(), RestoredSnapshots(simulator->entries()));
  for (const JournalEntry& entry : simulator->entries()) {
    EXPECT_TRUE(player.Apply(entry.call).ok());
  }
  EXPECT_EQ(other->StateHash(), simulator->StateHash());
  // A snapshot that nobody said would be restored is not kept.
  EXPECT_EQ(player.Apply(RestoreCall{2}).code(), StatusCode::kNotFound);
}

TEST(JournaledSimulatorTest, ThePlayerSeesWhenANameIsAnother) {
  const auto simulator = MakeSimulator(Scenery(), 3);
  JournalPlayer player(simulator.get(), {});
  const Status status = player.Apply(SpawnCall{RequestFor("goblin", "a", -8.0, 8.0), "b"});
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace latticeworld
