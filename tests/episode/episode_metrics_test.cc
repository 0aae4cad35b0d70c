#include "latticeworld/episode/episode_metrics.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TrackPoint At(double time_s, double x_m, double y_m, double z_m, bool continues = true) {
  TrackPoint point;
  point.time_s = time_s;
  point.position_m = {x_m, y_m, z_m};
  point.continues = continues;
  return point;
}

EpisodeRecord RecordOf(std::vector<TrackPoint> points) {
  EpisodeRecord record;
  record.tracks["robot"] = {"robot", "wheeled robot", 1, true, std::move(points)};
  record.tracks["goblin_1"] = {"goblin_1", "goblin", 2, false, {At(0.0, 9.0, 9.0, 0.0, false)}};
  return record;
}

AgentMetrics Robot(const EpisodeRecord& record) {
  const std::vector<AgentMetrics> all = MetricsOf(record);
  EXPECT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "goblin_1");
  return all.at(1);
}

TEST(EpisodeMetricsTest, TheWayIsMeasuredInSpaceAndClimbsAreAdded) {
  const AgentMetrics robot = Robot(RecordOf({At(0.0, 0.0, 0.0, 0.0, false), At(1.0, 3.0, 4.0, 0.0),
                                             At(2.0, 3.0, 4.0, 12.0), At(4.0, 3.0, 9.0, 0.0)}));
  EXPECT_DOUBLE_EQ(robot.distance_m, 5.0 + 12.0 + 13.0);
  EXPECT_DOUBLE_EQ(robot.climb_m, 12.0);
  EXPECT_DOUBLE_EQ(robot.mean_speed_mps, 30.0 / 4.0);
  EXPECT_DOUBLE_EQ(robot.present_s, 4.0);
  EXPECT_DOUBLE_EQ(robot.survived_s, 4.0);
}

TEST(EpisodeMetricsTest, WhereItWasPutItDidNotGo) {
  const AgentMetrics robot =
      Robot(RecordOf({At(0.0, 0.0, 0.0, 0.0, false), At(1.0, 1.0, 0.0, 0.0),
                      At(1.5, 100.0, 0.0, 50.0, false), At(2.5, 101.0, 0.0, 50.0)}));
  EXPECT_DOUBLE_EQ(robot.distance_m, 2.0);
  EXPECT_DOUBLE_EQ(robot.climb_m, 0.0);
  EXPECT_DOUBLE_EQ(robot.mean_speed_mps, 1.0);
}

TEST(EpisodeMetricsTest, EventsAreCountedForTheSideThatTheyTellOf) {
  EpisodeRecord record = RecordOf({At(1.0, 0.0, 0.0, 0.0, false), At(9.0, 0.0, 0.0, 0.0)});
  record.events = {
      {2.0, "pursued", "goblin_1", "robot", {}}, {3.0, "hit", "robot", "goblin_1", {}},
      {3.5, "hit", "robot", "goblin_1", {}},     {4.0, "collided", "robot", "tree_1", {}},
      {4.5, "knocked_over", "robot", "", {}},    {5.0, "died", "robot", "goblin_1", {}},
      {8.0, "died", "robot", "goblin_1", {}},    {8.0, "spawned", "crate_1", "", {}}};
  const std::vector<AgentMetrics> all = MetricsOf(record);
  const AgentMetrics &goblin = all.at(0), &robot = all.at(1);
  EXPECT_EQ(goblin.blows_given, 2);
  EXPECT_EQ(goblin.blows_taken, 0);
  EXPECT_EQ(goblin.pursued, 0);
  EXPECT_EQ(robot.pursued, 1);
  EXPECT_EQ(robot.blows_taken, 2);
  EXPECT_EQ(robot.collisions, 1);
  EXPECT_EQ(robot.falls, 1);
  EXPECT_EQ(robot.deaths, 2);
  EXPECT_DOUBLE_EQ(robot.survived_s, 4.0);  // from 1 s to the first death
}

TEST(EpisodeMetricsTest, AnAgentWithoutATrackHasNoFigures) {
  EpisodeRecord record;
  record.tracks["a"].name = "a";
  const AgentMetrics metrics = MetricsOf(record).at(0);
  EXPECT_EQ(metrics.distance_m, 0.0);
  EXPECT_EQ(metrics.mean_speed_mps, 0.0);
  EXPECT_LT(metrics.joint_work_j, 0.0);
}

}  // namespace
}  // namespace latticeworld
