#include "latticeworld_ros/episode/bag_file.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>

#include "common/synced_directories.h"
#include "latticeworld_ros/episode/bag_message.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class BagFileTest : public testing::Test {
 protected:
  BagFileTest() {
    std::string name = (fs::temp_directory_path() / "bag-file-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~BagFileTest() override { fs::remove_all(folder_); }

  // A text that no compression makes much smaller.
  static BagMessage Text(std::size_t bytes, double time_s = 1.0, bool latched = false) {
    std_msgs::String text;
    std::uint64_t state = 1;
    for (std::size_t i = 0; i < bytes; ++i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      text.data += static_cast<char>(state >> 56);
    }
    return ToBag("/text", ros::Time(time_s), text, latched);
  }
  // Texts of a bag.
  static std::size_t Count(const fs::path& path) {
    rosbag::Bag bag(path.string());
    rosbag::View view(bag);
    std::size_t count = 0;
    for (const rosbag::MessageInstance& one : view) {
      count += one.instantiate<std_msgs::String>() != nullptr;
    }
    return count;
  }

  fs::path folder_;
};

TEST_F(BagFileTest, AFinishedBagKeepsItsNameThroughALossOfPower) {
  auto file = BagFile::Create(folder_ / "a.bag", BagCompression::kNone);
  ASSERT_TRUE(file.ok() && (*file)->Write(Text(100)).ok());
  const std::size_t before = SyncedDirectories().size();
  ASSERT_TRUE((*file)->Finish().ok());
  ASSERT_GT(SyncedDirectories().size(), before);
  EXPECT_EQ(SyncedDirectories().back(), fs::canonical(folder_));
}

// A disk that is full takes not even what a bag begins with.
TEST_F(BagFileTest, WhereThereIsNoRoomForItsBeginningNothingIsLeft) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit limit = before;
  limit.rlim_cur = 4000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  const Status refused = BagFile::Create(folder_ / "a.bag", BagCompression::kNone).status();
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted) << refused.ToString();
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(BagFileTest, ABagHasItsNameOnceItIsWhole) {
  for (const auto& compression : EnumNames(BagCompression{})) {
    const fs::path path = folder_ / (std::string(compression.name) + ".bag");
    auto file = BagFile::Create(path, compression.value);
    ASSERT_TRUE(file.ok()) << file.status().ToString();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE((*file)->Write(Text(50000, 1.0 + i)).ok());
    EXPECT_FALSE(fs::exists(path));
    EXPECT_TRUE(fs::exists((*file)->active_path()));
    ASSERT_TRUE((*file)->Finish().ok());
    EXPECT_TRUE(fs::exists(path));
    EXPECT_FALSE(fs::exists((*file)->active_path()));
    EXPECT_EQ((*file)->bytes(), fs::file_size(path));
    EXPECT_EQ(Count(path), 50u);
    EXPECT_FALSE((*file)->Write(Text(1)).ok());
  }
}

TEST_F(BagFileTest, NothingIsOverwritten) {
  auto first = BagFile::Create(folder_ / "a.bag", BagCompression::kNone);
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(BagFile::Create(folder_ / "a.bag", BagCompression::kNone).status().code(),
            StatusCode::kAlreadyExists);
  ASSERT_TRUE((*first)->Finish().ok());
  EXPECT_EQ(BagFile::Create(folder_ / "a.bag", BagCompression::kNone).status().code(),
            StatusCode::kAlreadyExists);
  EXPECT_FALSE(BagFile::Create(folder_ / "absent" / "a.bag", BagCompression::kNone).ok());
}

TEST_F(BagFileTest, AFlushedChunkIsInTheFile) {
  auto file = BagFile::Create(folder_ / "a.bag", BagCompression::kNone);
  ASSERT_TRUE(file.ok());
  ASSERT_TRUE((*file)->Write(Text(20000)).ok());
  ASSERT_TRUE((*file)->Flush().ok());
  EXPECT_GT(fs::file_size((*file)->active_path()), 20000u);
  ASSERT_TRUE((*file)->Flush().ok());
  ASSERT_TRUE((*file)->Write(Text(20000)).ok());
  ASSERT_TRUE((*file)->Finish().ok());
  EXPECT_EQ(Count(folder_ / "a.bag"), 2u);
}

TEST_F(BagFileTest, LatchedMessagesSaySo) {
  EXPECT_TRUE(Text(1, 1.0, true).latched());
  EXPECT_FALSE(Text(1, 1.0, false).latched());
  EXPECT_FALSE((BagMessage{"/text", ros::Time(1), Text(1).message, nullptr}.latched()));
}

// A limit on the length of files is a full disk that needs no file system of its own.
TEST_F(BagFileTest, AFullDiskLeavesAWholeBag) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit limit = before;
  limit.rlim_cur = 12u << 20;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  for (const auto& compression : EnumNames(BagCompression{})) {
    const fs::path path = folder_ / (std::string(compression.name) + ".bag");
    auto file = BagFile::Create(path, compression.value);
    std::size_t written = 0;
    const BagMessage text = Text(500000);
    Status status = file.status();
    while (status.ok() && written < 400) {
      status = (*file)->Write(text);
      written += status.ok();
    }
    EXPECT_EQ(status.code(), StatusCode::kResourceExhausted) << status.ToString();
    if (!file.ok()) continue;
    EXPECT_TRUE((*file)->Write(Text(100), /*last=*/true).ok());
    EXPECT_TRUE((*file)->Finish().ok());
    EXPECT_EQ(Count(path), written + 1);
  }
  limit.rlim_cur = 1u << 20;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_EQ(BagFile::Create(folder_ / "tiny.bag", BagCompression::kNone).status().code(),
            StatusCode::kResourceExhausted);
  EXPECT_FALSE(fs::exists(folder_ / "tiny.bag"));
  EXPECT_FALSE(fs::exists(folder_ / "tiny.bag.active"));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
}

}  // namespace
}  // namespace latticeworld
