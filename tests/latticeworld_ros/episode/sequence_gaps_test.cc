#include "latticeworld_ros/episode/sequence_gaps.h"

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "latticeworld_ros/episode/bag_message.h"

namespace latticeworld {
namespace {

std::uint64_t Missing(SequenceGaps* gaps, const std::string& topic, std::uint32_t sequence) {
  nav_msgs::Odometry odometry;
  odometry.header.seq = sequence;
  const BagMessage message = ToBag(topic, ros::Time(1.0), odometry);
  return gaps->MissingBefore(message, StampOf(message));
}

TEST(SequenceGapsTest, NumbersThatAreLeftOutAreMessagesThatWereLost) {
  SequenceGaps gaps;
  EXPECT_EQ(Missing(&gaps, "/robot/odom", 70), 0u) << "what came before the first is not ours";
  EXPECT_EQ(Missing(&gaps, "/robot/odom", 71), 0u);
  EXPECT_EQ(Missing(&gaps, "/robot/odom", 75), 3u);
  EXPECT_EQ(Missing(&gaps, "/scout/odom", 9), 0u) << "each topic counts by itself";
  EXPECT_EQ(Missing(&gaps, "/robot/odom", 76), 0u);
}

TEST(SequenceGapsTest, APublisherThatBeginsAnewHasLostNothing) {
  SequenceGaps gaps;
  EXPECT_EQ(Missing(&gaps, "/robot/odom", 70), 0u);
  EXPECT_EQ(Missing(&gaps, "/robot/odom", 0), 0u);
  EXPECT_EQ(Missing(&gaps, "/robot/odom", 2), 1u);
}

std::uint64_t MissingTf(SequenceGaps* gaps, std::uint32_t sequence, std::size_t transforms = 2) {
  tf2_msgs::TFMessage tf;
  tf.transforms.resize(transforms);
  if (transforms > 0) tf.transforms[0].header.seq = sequence;
  const BagMessage message = ToBag("/tf", ros::Time(1.0), tf);
  return gaps->MissingBefore(message, StampOf(message));
}

TEST(SequenceGapsTest, TfIsNumberedInItsFirstTransform) {
  SequenceGaps gaps;
  EXPECT_EQ(MissingTf(&gaps, 41), 0u);
  EXPECT_EQ(MissingTf(&gaps, 42), 0u);
  EXPECT_EQ(MissingTf(&gaps, 0, 0), 0u) << "an empty one has no number";
  EXPECT_EQ(MissingTf(&gaps, 47), 4u);
  EXPECT_EQ(MissingTf(&gaps, 0), 0u) << "other broadcasters number nothing";
  EXPECT_EQ(MissingTf(&gaps, 48), 0u);
}

TEST(SequenceGapsTest, WhatHasNoNumberIsNotCounted) {
  SequenceGaps gaps;
  rosgraph_msgs::Clock clock;
  for (const double time_s : {1.0, 5.0, 2.0}) {
    clock.clock = ros::Time(time_s);
    const BagMessage message = ToBag("/clock", clock.clock, clock);
    EXPECT_EQ(gaps.MissingBefore(message, StampOf(message)), 0u);
  }
}

}  // namespace
}  // namespace latticeworld
