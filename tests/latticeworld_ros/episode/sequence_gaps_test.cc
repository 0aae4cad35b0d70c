#include "latticeworld_ros/episode/sequence_gaps.h"

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>

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

TEST(SequenceGapsTest, WhatHasNoHeaderIsNotCounted) {
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
