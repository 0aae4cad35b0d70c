#include "latticeworld_ros/episode_recording.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/String.h>
#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld_ros/bag_message.h"

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
  EpisodeRecordingTest() {
    std::string name = (fs::temp_directory_path() / "episode-recording-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    EpisodeRecordingOptions options;
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
  void AddHash(std::uint64_t run, std::uint64_t step, double time_s) {
    StateHash hash;
    hash.world_id = "meadow";
    hash.run = run;
    hash.step = step;
    recording_->Add(ToBag("/world/state_hash", ros::Time(time_s), hash));
  }
  // Every message of a type; the recording has ended.
  template <typename Message>
  std::vector<Message> Recorded() const {
    rosbag::Bag bag((folder_ / "a.bag").string());
    rosbag::View view(bag);
    std::vector<Message> messages;
    for (const rosbag::MessageInstance& one : view) {
      if (const auto message = one.instantiate<Message>()) messages.push_back(*message);
    }
    return messages;
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
