#include "latticeworld_ros/episode/episode_recording.h"

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/String.h>
#include <stdlib.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/refused_threads.h"
#include "latticeworld_ros/episode/bag_message.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;
using latticeworld_msgs::EpisodeEnd;
using latticeworld_msgs::EpisodeStart;
using latticeworld_msgs::StateHash;
using latticeworld_msgs::WorldFiles;

constexpr double kStart_s = 100.0;

class EpisodeRecordingTest : public testing::Test {
 protected:
  explicit EpisodeRecordingTest(EpisodeRecordingOptions options = {}) {
    std::string name = (fs::temp_directory_path() / "episode-recording-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    options.directory = folder_;
    options.name = "a";
    recording_ = std::make_unique<EpisodeRecording>(options);
    EpisodeStart start;
    start.header.stamp = ros::Time(kStart_s);
    start.world_id = "meadow";
    start.run = 2;
    EXPECT_TRUE(recording_->Begin(start, WorldFiles()).ok());
  }
  ~EpisodeRecordingTest() override { fs::remove_all(folder_); }

  void AddClock(double time_s) {
    rosgraph_msgs::Clock clock;
    clock.clock = ros::Time(time_s);
    recording_->Add(ToBag("/clock", clock.clock, clock));
  }
  void AddText(const std::string& text, double time_s) {
    std_msgs::String message;
    message.data = text;
    recording_->Add(ToBag("/text", ros::Time(time_s), message, /*latched=*/true));
  }
  void AddOdometry(double stamp_s, double heard_s, bool latched = false) {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time(stamp_s);
    recording_->Add(ToBag("/robot/odom", ros::Time(heard_s), odometry, latched));
  }
  void AddHash(std::uint64_t run, std::uint64_t step, double time_s) {
    StateHash hash;
    hash.world_id = "meadow";
    hash.run = run;
    hash.step = step;
    recording_->Add(ToBag("/world/state_hash", ros::Time(time_s), hash));
  }
  // Every message of a type; the recording has ended.
  template <typename Message>
  std::vector<Message> Recorded(const std::string& file = "a.bag") const {
    rosbag::Bag bag((folder_ / file).string());
    rosbag::View view(bag);
    std::vector<Message> messages;
    for (const rosbag::MessageInstance& one : view) {
      if (const auto message = one.instantiate<Message>()) messages.push_back(*message);
    }
    return messages;
  }
  // Under which times those of a type are kept [s].
  template <typename Message>
  std::vector<double> Times(const std::string& file = "a.bag") const {
    rosbag::Bag bag((folder_ / file).string());
    rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::DataType<Message>::value()));
    std::vector<double> times_s;
    for (const rosbag::MessageInstance& one : view) times_s.push_back(one.getTime().toSec());
    return times_s;
  }
  std::string Reason() const { return Recorded<EpisodeEnd>().at(0).reason; }

  fs::path folder_;
  std::unique_ptr<EpisodeRecording> recording_;
};

TEST_F(EpisodeRecordingTest, TimeThatRunsBackwardEndsTheEpisodeWithItsReason) {
  AddClock(kStart_s);
  AddText("of the first", kStart_s);
  AddClock(kStart_s + 0.1);
  AddClock(0.1);
  AddText("of the second", 0.1);
  AddClock(0.2);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_NE(Reason().find("another world_server"), std::string::npos) << Reason();
  ASSERT_EQ(Recorded<std_msgs::String>().size(), 1u);
  EXPECT_EQ(Recorded<std_msgs::String>()[0].data, "of the first");
  EXPECT_EQ(Recorded<rosgraph_msgs::Clock>().size(), 2u);
}

TEST_F(EpisodeRecordingTest, WhatNoThreadCanBeHadForIsRefusedAndLeavesNothing) {
  EpisodeRecordingOptions options;
  options.directory = folder_;
  options.name = "b";
  EpisodeRecording other(options);
  EpisodeStart start;
  start.header.stamp = ros::Time(kStart_s);
  {
    const RefusedThreads refused;
    EXPECT_EQ(other.Begin(start, WorldFiles()).code(), StatusCode::kResourceExhausted);
  }
  for (const char* name : {"b.bag", "b.bag.active"}) EXPECT_FALSE(fs::exists(folder_ / name));
}

TEST_F(EpisodeRecordingTest, TheHeaderOfAConnectionThatNamesNoNodeStaysAsItIs) {
  BagMessage message = ToBag("/text", ros::Time(kStart_s), std_msgs::String(), /*latched=*/true);
  message.header->erase("callerid");
  const ros::M_string before = *message.header;
  const boost::shared_ptr<ros::M_string> header = message.header;
  recording_->Add(std::move(message));
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_EQ(*header, before);
  EXPECT_EQ(Recorded<std_msgs::String>().size(), 1u);
}

TEST_F(EpisodeRecordingTest, TimeThatStandsStillDoesNot) {
  for (int i = 0; i < 3; ++i) AddClock(kStart_s);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_EQ(Reason(), "stopped");
  EXPECT_EQ(Recorded<rosgraph_msgs::Clock>().size(), 3u);
}

TEST_F(EpisodeRecordingTest, StepsThatFallAreAnotherServers) {
  AddHash(2, 300, kStart_s);
  AddHash(2, 400, kStart_s + 1.0);
  AddHash(2, 0, kStart_s + 1.0);
  AddText("of the second", kStart_s + 1.0);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_NE(Reason().find("another world_server"), std::string::npos) << Reason();
  EXPECT_EQ(Recorded<StateHash>().size(), 2u);
  EXPECT_TRUE(Recorded<std_msgs::String>().empty());
}

TEST_F(EpisodeRecordingTest, RunsThatFallAreAnotherServers) {
  AddHash(1, 50, kStart_s);  // of the world before
  AddHash(2, 300, kStart_s);
  AddHash(1, 500, kStart_s + 1.0);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_NE(Reason().find("another world_server"), std::string::npos) << Reason();
  EXPECT_EQ(Recorded<StateHash>().size(), 1u);
}

using Seconds = std::vector<double>;

TEST_F(EpisodeRecordingTest, TheTimeOfAMessageIsItsStampWheneverItIsHeard) {
  AddOdometry(kStart_s + 0.5, kStart_s + 3.7);   // it waited in a queue
  AddOdometry(kStart_s + 9.0, kStart_s + 3.75);  // the clock waited
  AddClock(kStart_s + 3.5);
  tf2_msgs::TFMessage tf;
  tf.transforms.resize(2);
  tf.transforms[0].header.stamp = ros::Time(kStart_s + 0.25);
  tf.transforms[1].header.stamp = ros::Time(kStart_s + 0.75);
  recording_->Add(ToBag("/tf", ros::Time(kStart_s + 4.0), tf));
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_EQ(Times<nav_msgs::Odometry>(), (Seconds{kStart_s + 0.5, kStart_s + 9.0}));
  EXPECT_EQ(Times<tf2_msgs::TFMessage>(), Seconds{kStart_s + 0.25});
  EXPECT_EQ(Times<rosgraph_msgs::Clock>(), Seconds{kStart_s + 3.5});
  EXPECT_EQ(Times<EpisodeEnd>(), Seconds{kStart_s + 9.0}) << "the end is the last";
}

TEST_F(EpisodeRecordingTest, TheTimeOfWhatHasNoStampOrOneOfAnotherClockIsThatOfHearing) {
  AddText("no header", kStart_s + 1.0);
  AddOdometry(0.0, kStart_s + 2.0);
  AddOdometry(1.8e9, kStart_s + 3.0);  // of the wall
  recording_->Add(ToBag("/tf", ros::Time(kStart_s + 4.0), tf2_msgs::TFMessage()));
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_EQ(Times<std_msgs::String>(), Seconds{kStart_s + 1.0});
  EXPECT_EQ(Times<nav_msgs::Odometry>(), (Seconds{kStart_s + 2.0, kStart_s + 3.0}));
  EXPECT_EQ(Times<tf2_msgs::TFMessage>(), Seconds{kStart_s + 4.0});
}

TEST_F(EpisodeRecordingTest, WhatIsOlderThanTheEpisodeIsAtItsBeginningWithItsStamp) {
  AddOdometry(kStart_s - 60.0, kStart_s + 2.0, /*latched=*/true);
  AddOdometry(kStart_s - 60.0, kStart_s + 2.0);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_EQ(Times<nav_msgs::Odometry>(), (Seconds{kStart_s, kStart_s}));
  EXPECT_EQ(Recorded<nav_msgs::Odometry>().at(0).header.stamp, ros::Time(kStart_s - 60.0));
}

TEST_F(EpisodeRecordingTest, WhatWasLostOnTheWayIsCounted) {
  ros::Time::init();  // a loss is told, now and then
  for (const std::uint32_t number : {1, 2, 6}) {
    nav_msgs::Odometry odometry;
    odometry.header.seq = number;
    odometry.header.stamp = ros::Time(kStart_s + number);
    recording_->Add(ToBag("/robot/odom", odometry.header.stamp, odometry));
  }
  EXPECT_EQ(recording_->progress().dropped, 3u);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_EQ(Recorded<nav_msgs::Odometry>().size(), 3u);
  EXPECT_EQ(Recorded<EpisodeEnd>().at(0).dropped, 3u);
}

class ShortRecordingTest : public EpisodeRecordingTest {
 protected:
  static EpisodeRecordingOptions Short() {
    EpisodeRecordingOptions options;
    options.max_duration_s = 5.0;
    return options;
  }
  ShortRecordingTest() : EpisodeRecordingTest(Short()) {}
};

TEST_F(ShortRecordingTest, EndsByTheClockAndByNoStampAhead) {
  AddClock(kStart_s + 4.9);
  AddOdometry(kStart_s + 20.0, kStart_s + 20.0);  // a plan, say
  AddText("before the end", kStart_s + 4.9);
  AddClock(kStart_s + 5.0);
  AddText("after it", kStart_s + 5.1);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_NE(Reason().find("max_duration"), std::string::npos) << Reason();
  ASSERT_EQ(Recorded<std_msgs::String>().size(), 1u);
  EXPECT_EQ(Recorded<std_msgs::String>()[0].data, "before the end");
}

class SplitRecordingTest : public EpisodeRecordingTest {
 protected:
  static EpisodeRecordingOptions Split() {
    EpisodeRecordingOptions options;
    options.compression = BagCompression::kNone;
    options.split_bytes = 1u << 20;
    return options;
  }
  SplitRecordingTest() : EpisodeRecordingTest(Split()) {}
};

TEST_F(SplitRecordingTest, WhatIsOlderThanItsPartIsAtThePartsBeginning) {
  AddClock(kStart_s + 5.0);
  nav_msgs::Odometry large;
  large.header.stamp = ros::Time(kStart_s + 30.0);  // no reason for the next part to begin then
  large.child_frame_id = std::string(2u << 20, 'x');
  recording_->Add(ToBag("/large", ros::Time(kStart_s + 5.0), large));
  AddText("with which rosbag counts what is before it", kStart_s + 5.0);
  AddOdometry(kStart_s + 4.0, kStart_s + 5.0);
  AddOdometry(kStart_s + 6.0, kStart_s + 6.0);
  ASSERT_TRUE(recording_->End("stopped", nullptr).ok());
  EXPECT_EQ(Times<nav_msgs::Odometry>("a.part0.bag"), Seconds{kStart_s + 30.0});
  EXPECT_EQ(Times<EpisodeStart>("a.part1.bag"), Seconds{kStart_s + 5.0});
  EXPECT_EQ(Times<nav_msgs::Odometry>("a.part1.bag"), (Seconds{kStart_s + 5.0, kStart_s + 6.0}));
}

TEST_F(EpisodeRecordingTest, TheLastCallsOfAnotherWorldAreNoneOfTheEpisodes) {
  latticeworld_msgs::GetWorldBundle::Response last;
  last.world_id = "desert";
  last.run = 2;
  last.calls = 1;
  last.journal.resize(1);
  last.journal[0].number = 1;
  ASSERT_TRUE(recording_->End("stopped", &last).ok());
  EXPECT_TRUE(Recorded<latticeworld_msgs::JournalEntry>().empty());
  EXPECT_TRUE(Recorded<StateHash>().empty());
}

}  // namespace
}  // namespace latticeworld
