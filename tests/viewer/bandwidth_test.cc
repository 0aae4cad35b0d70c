#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>

#include "latticeworld/simulation/simulator.h"
#include "latticeworld/viewer/server/outbox.h"
#include "latticeworld/viewer/viewer_feed.h"
#include "simulation/test_scene.h"
#include "viewer/stream_decoder.h"
#include "viewer/viewer_fixture.h"

namespace latticeworld {
namespace {

constexpr double kFrame_s = 0.05;  // 20 Hz
constexpr int kFrames = 200;
constexpr double kMostBitsPerSecond = 1e6;

// A hundred agents on hills: herds that wander, two teams that fight, birds and robots that drive.
std::unique_ptr<Simulator> Crowd() {
  TestScene scene;
  scene.height_m = Hills(3.0, 30.0);
  const AgentCategory categories[] = {AgentCategory::kSheep,  AgentCategory::kGoblin,
                                      AgentCategory::kHorse,  AgentCategory::kAncientWarrior,
                                      AgentCategory::kEagle,  AgentCategory::kHumanoidRobot,
                                      AgentCategory::kGoblin, AgentCategory::kWheeledRobot};
  for (int i = 0; i < 100; ++i) {
    AgentStart& agent = scene.AddAgent("agent_" + std::to_string(i), categories[i % 8],
                                       -27.0 + 6.0 * (i % 10), -27.0 + 6.0 * (i / 10));
    agent.controllable = agent.category == AgentCategory::kWheeledRobot;
    if (agent.category == AgentCategory::kEagle) {
      agent.height_above_ground_m = 12.0;
      agent.state = AgentState::kFlying;
    }
  }
  return MakeSimulator(scene);
}

TEST(BandwidthTest, AHundredMovingAgentsTakeLessThanAMegabitASecond) {
  const std::unique_ptr<Simulator> simulator = Crowd();
  ASSERT_EQ(simulator->State()->agents.size(), 100u);
  const int steps = static_cast<int>(kFrame_s / simulator->options().step_s + 0.5);
  StateEncoder encoder(StreamKind::kAgents);
  StreamDecoder decoder;
  std::size_t bytes = 0;
  std::uint64_t key = 0;
  int moved = 0;
  StreamedState<AgentRow> before = Streamed(simulator->State()->agents);
  for (int frame = 0; frame < kFrames; ++frame) {
    for (int i = 0; i < steps; ++i) {
      const std::shared_ptr<const WorldState> state = simulator->State();
      for (const AgentSnapshot& agent : state->agents) {
        if (!agent.controllable) continue;
        ASSERT_TRUE(simulator->Command(agent.name, Forward(1.0, 0.4)).ok());
      }
      simulator->Step();
    }
    const StreamedState<AgentRow> now = Streamed(simulator->State()->agents);
    ASSERT_EQ(now.things.size(), 100u);
    for (std::size_t i = 0; i < 100; ++i) moved += now.things[i] == before.things[i] ? 0 : 1;
    before = now;
    const bool key_due = frame % static_cast<int>(kStreamKeyPeriod_s / kFrame_s) == 0;
    const StreamFrame made = encoder.Encode(frame * kFrame_s, 1, now.things, key_due);
    for (const SharedBytes& sent : {key == made.key_number ? nullptr : made.key, made.delta}) {
      if (sent == nullptr) continue;
      bytes += sent->size() + 4;  // with the header of its WebSocket frame
      ASSERT_TRUE(decoder.Read(*sent));
    }
    key = made.key_number;
    ASSERT_EQ(decoder.things(), now.things);
  }
  const double bits_per_second = 8.0 * static_cast<double>(bytes) / (kFrames * kFrame_s);
  RecordProperty("kbit_per_second", static_cast<int>(bits_per_second / 1000.0));
  std::printf("%.0f kbit/s, %.0f of 100 agents move between two frames\n", bits_per_second / 1000.0,
              moved / static_cast<double>(kFrames));
  EXPECT_LT(bits_per_second, kMostBitsPerSecond);
  EXPECT_GT(moved, 60 * kFrames);  // else there is little to tell
}

class ViewerFeedTest : public ViewerServerTest {};

TEST_F(ViewerFeedTest, TellsTablesWhenTheyChangeAndFramesWhenSomethingMoves) {
  Start();
  server().SetWorld(SmallWorld(), "");
  PlainClient client = Connect();
  ASSERT_EQ(client.Upgrade().status, 101);
  client.ReadType("hello");
  ViewerFeed feed(&server());
  AgentSnapshot robot;
  robot.name = "robot";
  robot.species = "wheeled robot";
  robot.behaviour = Behaviour::kControlled;
  robot.health = 0.5;
  feed.ShowAgents(1.0, 1.0, Streamed(std::vector<AgentSnapshot>{robot}));
  EXPECT_EQ(client.ReadType("agents").at("version"), 1);
  StreamDecoder decoder;
  ASSERT_TRUE(decoder.Read(ReadBinary(&client)));
  EXPECT_EQ(decoder.things().at(0).behaviour, static_cast<int>(Behaviour::kControlled));
  EXPECT_EQ(decoder.things().at(0).health, 128);
  feed.ShowAgents(1.1, 1.1, Streamed(std::vector<AgentSnapshot>{robot}));  // nothing moved
  robot.position_m.x() = 0.25;
  feed.ShowAgents(1.2, 1.2, Streamed(std::vector<AgentSnapshot>{robot}));
  ASSERT_TRUE(decoder.Read(ReadBinary(&client)));
  EXPECT_EQ(decoder.time_s(), 1.2);
  EXPECT_FALSE(decoder.is_key());
  robot.position_m.x() = 0.5;
  feed.ShowAgents(4.0, 4.0, Streamed(std::vector<AgentSnapshot>{robot}));
  ASSERT_TRUE(decoder.Read(ReadBinary(&client)));
  EXPECT_TRUE(decoder.is_key());  // the last is old
  AgentSnapshot sheep;
  sheep.name = "sheep";
  feed.ShowAgents(4.1, 4.1, Streamed(std::vector<AgentSnapshot>{robot, sheep}));
  EXPECT_EQ(client.ReadType("agents").at("version"), 2);
  ASSERT_TRUE(decoder.Read(ReadBinary(&client)));
  EXPECT_EQ(decoder.version(), 2u);
  EXPECT_EQ(decoder.things().size(), 2u);
}

}  // namespace
}  // namespace latticeworld
