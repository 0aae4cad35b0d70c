#include "latticeworld_ros/episode/episode_record_builder.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

latticeworld_msgs::EpisodeStart Start() {
  latticeworld_msgs::EpisodeStart start;
  start.header.stamp = ros::Time(10.0);
  start.name = "e";
  start.world_id = "world-1";
  start.seed = 3;
  start.step = 100;
  return start;
}

latticeworld_msgs::AgentStates States(double stamp_s, std::uint64_t step,
                                      std::uint64_t episode_step, double x_m) {
  latticeworld_msgs::AgentStates message;
  message.header.stamp = ros::Time(stamp_s);
  message.step = step;
  message.episode_step = episode_step;
  latticeworld_msgs::AgentState robot;
  robot.name = "robot";
  robot.species = "wheeled robot";
  robot.pose.position.x = x_m;
  robot.pose.orientation.w = 1.0;
  robot.twist.linear.x = 3.0;
  robot.twist.linear.y = 4.0;
  message.agents.push_back(robot);
  return message;
}

TEST(EpisodeRecordBuilderTest, StatesBecomeATrackThatBeginsWithTheEpisode) {
  EpisodeRecordBuilder builder(Start());
  builder.Add(States(9.0, 90, 90, 5.0));  // of before
  builder.Add(States(10.0, 100, 100, 1.0));
  builder.Add(States(10.5, 150, 150, 2.0));
  builder.Add(States(10.6, 150, 150, 2.0));  // a pause shows it once more
  const EpisodeRecord record = builder.Take();
  const auto& points = record.tracks.at("robot").points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_FALSE(points[0].continues);
  EXPECT_TRUE(points[1].continues);
  EXPECT_DOUBLE_EQ(points[1].time_s, 0.5);
  EXPECT_DOUBLE_EQ(points[1].speed_mps, 5.0);
  EXPECT_EQ(record.steps, 50u);
  EXPECT_EQ(record.seed, 3u);
}

TEST(EpisodeRecordBuilderTest, AResetASnapshotAndARespawnBreakATrack) {
  EpisodeRecordBuilder builder(Start());
  latticeworld_msgs::AgentEvent back;
  back.header.stamp = ros::Time(12.4);
  back.kind = "respawned";
  back.agent = "robot";
  builder.Add(back);
  builder.Add(States(10.0, 100, 100, 1.0));
  builder.Add(States(11.0, 200, 0, 2.0));    // reset
  builder.Add(States(11.5, 250, 50, 3.0));   // goes on
  builder.Add(States(12.0, 300, 500, 4.0));  // restored
  builder.Add(States(12.5, 350, 550, 9.0));  // came back meanwhile
  builder.Add(States(13.0, 400, 600, 9.5));
  const EpisodeRecord record = builder.Take();
  const auto& points = record.tracks.at("robot").points;
  ASSERT_EQ(points.size(), 6u);
  const bool continues[] = {false, false, true, false, false, true};
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i].continues, continues[i]) << i;
}

TEST(EpisodeRecordBuilderTest, WhoWasAwayBeginsAnew) {
  EpisodeRecordBuilder builder(Start());
  builder.Add(States(10.0, 100, 100, 1.0));
  auto without = States(10.5, 150, 150, 0.0);
  without.agents.clear();
  builder.Add(without);
  builder.Add(States(11.0, 200, 200, 50.0));
  EXPECT_FALSE(builder.Take().tracks.at("robot").points.back().continues);
}

TEST(EpisodeRecordBuilderTest, JointsWorkWhileTheyTurnAgainstAnEffort) {
  EpisodeRecordBuilder builder(Start());
  builder.Add(States(10.0, 100, 100, 1.0));
  sensor_msgs::JointState joints;
  joints.velocity = {2.0, -1.0};
  joints.effort = {3.0, 4.0};
  for (const double stamp_s : {10.0, 10.5, 11.0, 20.0}) {  // the last after a gap
    joints.header.stamp = ros::Time(stamp_s);
    builder.Add(joints, "/robot/joint_states");
    builder.Add(joints, "/somebody_else/joint_states");
  }
  const EpisodeRecord record = builder.Take();
  EXPECT_DOUBLE_EQ(record.tracks.at("robot").joint_work_j, 10.0);
  EXPECT_EQ(record.tracks.size(), 1u);
}

TEST(EpisodeRecordBuilderTest, TheEndSaysWhyAndWhen) {
  EpisodeRecordBuilder builder(Start());
  latticeworld_msgs::EpisodeEnd end;
  end.header.stamp = ros::Time(12.5);
  end.reason = "stopped";
  builder.Add(end);
  const EpisodeRecord record = builder.Take();
  EXPECT_EQ(record.ended_by, "stopped");
  EXPECT_DOUBLE_EQ(record.duration_s, 2.5);
}

}  // namespace
}  // namespace latticeworld
