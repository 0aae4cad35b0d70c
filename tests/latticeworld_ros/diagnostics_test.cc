#include "latticeworld_ros/diagnostics.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "fake_simulator.h"

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
  DiagnosticStatus status = ToDiagnostics(statistics, SensorStatistics(), nullptr).status[0];
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "no world is running");

  FakeSimulator* fake = nullptr;
  const RunningWorld world = FakeWorld("meadow", 3, &fake);
  statistics.world = world.world;
  statistics.simulator = fake;
  statistics.real_time_factor = 2.5;
  status = ToDiagnostics(statistics, SensorStatistics(), nullptr).status[0];
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "running");
  EXPECT_EQ(ValueOf(status, "world"), "meadow");
  EXPECT_EQ(ValueOf(status, "agents"), "0");
  EXPECT_EQ(ValueOf(status, "real-time factor"), "2.5");

  statistics.simulator = nullptr;
  statistics.failure = "numbers ran away";
  status = ToDiagnostics(statistics, SensorStatistics(), nullptr).status[0];
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("numbers ran away"), std::string::npos);
  EXPECT_EQ(ValueOf(status, "world"), "meadow");
}

}  // namespace
}  // namespace latticeworld
