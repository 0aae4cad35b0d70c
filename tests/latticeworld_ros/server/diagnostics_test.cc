#include "latticeworld_ros/server/diagnostics.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>

#include "language/chat/misbehaving_server.h"
#include "latticeworld_ros/running/fake_simulator.h"

namespace latticeworld {
namespace {

using diagnostic_msgs::DiagnosticStatus;

std::string ValueOf(const DiagnosticStatus& status, const std::string& key) {
  for (const auto& entry : status.values) {
    if (entry.key == key) return entry.value;
  }
  return "";
}

TEST(DiagnosticsTest, SayWhetherTheSimulationRuns) {
  LoopStatistics statistics;
  DiagnosticStatus status = ToDiagnosticArray(statistics, SensorStatistics(), nullptr).status[0];
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "no world is running");

  FakeSimulator* fake = nullptr;
  const LaunchedWorld world = FakeWorld("meadow", 3, &fake);
  statistics.world = world.world;
  statistics.simulator = fake;
  statistics.real_time_factor = 2.5;
  status = ToDiagnosticArray(statistics, SensorStatistics(), nullptr).status[0];
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "running");
  EXPECT_EQ(ValueOf(status, "world"), "meadow");
  EXPECT_EQ(ValueOf(status, "agents"), "0");
  EXPECT_EQ(ValueOf(status, "real-time factor"), "2.5");

  statistics.simulator = nullptr;
  statistics.failure = "numbers ran away";
  status = ToDiagnosticArray(statistics, SensorStatistics(), nullptr).status[0];
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("numbers ran away"), std::string::npos);
  EXPECT_EQ(ValueOf(status, "world"), "meadow");
}

TEST(DiagnosticsTest, SayHowTheLanguageServerDoesAndNeverItsKey) {
  constexpr char kVariable[] = "LATTICEWORLD_TEST_DIAGNOSTICS_KEY";
  constexpr char kKey[] = "sk-test-0123456789";
  ASSERT_EQ(setenv(kVariable, kKey, 1), 0);
  const MisbehavingServer server;
  OpenAiOptions options;
  options.url = server.Url("busy_then_good_then_401");
  options.model = "tiny";
  options.api_key_variable = kVariable;
  options.backoff_s = 0.01;
  const auto client = MakeOpenAiClient(options);
  ASSERT_TRUE(client.ok()) << client.status().ToString();
  const auto report = [&] {
    return ToDiagnosticArray(LoopStatistics(), SensorStatistics(), client->get());
  };
  const auto ask = [&] {
    ChatRequest request;
    request.messages = {{ChatRole::kUser, "Say hello.", ""}};
    return (*client)->Complete(request, nullptr, Progress()).status();
  };
  DiagnosticStatus status = report().status[2];
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "not asked yet");

  // Busy at first, then it answers.
  ASSERT_TRUE(ask().ok());
  status = report().status[2];
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "the last request went well");
  EXPECT_EQ(ValueOf(status, "requests"), "1");
  EXPECT_EQ(ValueOf(status, "failures"), "0");
  EXPECT_EQ(ValueOf(status, "retries"), "1");
  EXPECT_EQ(ValueOf(status, "prompt tokens"), "11");
  EXPECT_EQ(ValueOf(status, "completion tokens"), "4");
  const std::string first_token_s = ValueOf(status, "last time to first token [s]");
  const std::string total_s = ValueOf(status, "last time of an answer [s]");
  EXPECT_GT(std::stod(first_token_s), 0.0);
  EXPECT_GT(std::stod(total_s), std::stod(first_token_s)) << "with the try that failed";

  // It refuses the key, and repeats it.
  const Status refused = ask();
  ASSERT_EQ(refused.code(), StatusCode::kUnauthenticated);
  const diagnostic_msgs::DiagnosticArray array = report();
  status = array.status[2];
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, refused.ToString());
  EXPECT_NE(status.message.find("Incorrect API key provided: Bearer [key]"), std::string::npos);
  EXPECT_EQ(ValueOf(status, "requests"), "2");
  EXPECT_EQ(ValueOf(status, "failures"), "1");
  EXPECT_EQ(ValueOf(status, "retries"), "1");
  EXPECT_EQ(ValueOf(status, "prompt tokens"), "11");
  EXPECT_EQ(ValueOf(status, "last time to first token [s]"), first_token_s);
  EXPECT_NE(ValueOf(status, "last time of an answer [s]"), total_s);
  std::ostringstream all;
  all << array;
  EXPECT_NE(all.str().find("Bearer [key]"), std::string::npos);
  EXPECT_EQ(all.str().find(kKey), std::string::npos) << all.str();
}

TEST(DiagnosticsTest, SayThatThereIsNoLanguageServer) {
  const DiagnosticStatus status =
      ToDiagnosticArray(LoopStatistics(), SensorStatistics(), nullptr).status[2];
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "embedded only; remote_url is not set");
}

TEST(DiagnosticsTest, WarnOfServicesThatAnotherNodeHas) {
  const auto report = [](const MasterReport& master) {
    return ToDiagnosticArray(LoopStatistics(), SensorStatistics(), nullptr, master).status[4];
  };
  EXPECT_EQ(report({}).name, "world_server: services");
  EXPECT_EQ(report({}).level, DiagnosticStatus::OK);
  MasterReport master;
  master.services = {{"/static_map", "/map_server"}};
  EXPECT_EQ(report(master).level, DiagnosticStatus::WARN);
  EXPECT_NE(report(master).message.find("/map_server has taken /static_map"), std::string::npos);
}

TEST(DiagnosticsTest, NameTopicsThatAreNotDelivered) {
  const auto report = [](const MasterReport& master) {
    return ToDiagnosticArray(LoopStatistics(), SensorStatistics(), nullptr, master).status[3];
  };
  MasterReport master;
  master.descriptors = {100, 1024};
  master.topics = 900;
  EXPECT_EQ(report(master).name, "world_server: connections");
  EXPECT_EQ(report(master).level, DiagnosticStatus::OK);
  master.topics = 1100;
  EXPECT_EQ(report(master).level, DiagnosticStatus::WARN);
  EXPECT_NE(report(master).message.find("1024 file descriptors"), std::string::npos);
  master.descriptors.open = 1000;
  master.not_delivered = {"/robot_7/odom"};
  EXPECT_EQ(report(master).level, DiagnosticStatus::WARN);
  EXPECT_NE(report(master).message.find("1000 of 1024"), std::string::npos);
  EXPECT_EQ(ValueOf(report(master), "not delivered"), "/robot_7/odom");
}

}  // namespace
}  // namespace latticeworld
