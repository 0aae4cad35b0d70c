#include "latticeworld/simulation/simulator/event_log.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

TEST(EventLogTest, TellsOfTheStepOfTheRunAndOfWhatItWasTold) {
  SimulationClock clock(0.01);
  EventLog log(&clock);
  clock.Advance();
  clock.SetEpisodeStep(0);
  clock.Advance();
  log.Tell(EventKind::kCollided, "sheep", "tree", {1.0, 2.0, 3.0});
  const std::vector<Event> events = log.Take();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].step, 2u);
  EXPECT_EQ(events[0].kind, EventKind::kCollided);
  EXPECT_EQ(events[0].agent, "sheep");
  EXPECT_EQ(events[0].other, "tree");
  EXPECT_EQ(events[0].position_m, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_TRUE(log.Take().empty());
}

TEST(EventLogTest, ForgetsTheOldestWhereNobodyTakesThem) {
  SimulationClock clock(0.01);
  EventLog log(&clock);
  const int told = 100000;
  for (int i = 0; i < told; ++i)
    log.Tell(EventKind::kHit, std::to_string(i), "", Eigen::Vector3d::Zero());
  const std::vector<Event> events = log.Take();
  ASSERT_GE(events.size(), 32768u);
  ASSERT_LE(events.size(), 65536u);
  for (std::size_t i = 0; i < events.size(); ++i) {
    ASSERT_EQ(events[i].agent, std::to_string(told - events.size() + i));
  }
}

}  // namespace
}  // namespace latticeworld
