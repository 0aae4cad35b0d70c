#include "latticeworld_ros/episode/bag_check.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "latticeworld_ros/episode/bag_file.h"
#include "latticeworld_ros/episode/bag_message.h"
#include "latticeworld_ros/episode/episode_reader.h"
#include "latticeworld_ros/episode/episode_recording.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class BagCheckTest : public testing::Test {
 protected:
  BagCheckTest() {
    std::string name = (fs::temp_directory_path() / "bag-check-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~BagCheckTest() override { fs::remove_all(folder_); }

  // The bytes of a bag of an episode's beginning, told twice.
  std::string MakeBag(BagCompression compression) const {
    const fs::path path = folder_ / "made.bag";
    auto file = BagFile::Create(path, compression);
    latticeworld_msgs::EpisodeStart start;
    start.format = kEpisodeFormat;
    for (const double time_s : {1.0, 2.0}) {
      EXPECT_TRUE((*file)->Write(ToBag(kEpisodeStartTopic, ros::Time(time_s), start, true)).ok());
    }
    EXPECT_TRUE((*file)->Finish().ok());
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    in.close();
    fs::remove(path);
    return bytes;
  }
  fs::path Put(const std::string& bytes) const {
    const fs::path path = folder_ / "a.bag";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  // That the bag is refused, and that a reader of episodes says so.
  void ExpectRefused(const std::string& bytes, const std::string& words) const {
    const fs::path path = Put(bytes);
    const Status status = CheckBag(path);
    EXPECT_EQ(status.code(), StatusCode::kDataLoss) << words;
    EXPECT_NE(status.message().find(words), std::string::npos) << status.message();
    EXPECT_EQ(EpisodeReader::Open({path}).status().code(), StatusCode::kDataLoss);
  }

  fs::path folder_;
};

TEST_F(BagCheckTest, WhatTheRecorderWritesIsWhole) {
  for (const BagCompression compression :
       {BagCompression::kNone, BagCompression::kLz4, BagCompression::kBz2}) {
    const fs::path path = Put(MakeBag(compression));
    const Status status = CheckBag(path);
    EXPECT_TRUE(status.ok()) << status.ToString();
    EXPECT_TRUE(EpisodeReader::Open({path}).ok());
  }
}

TEST_F(BagCheckTest, AnEncryptedBagIsRefused) {
  const std::string field = std::string("\x1e\0\0\0", 4) + "encryptor=rosbag/NoEncryptor..";
  std::string bag = MakeBag(BagCompression::kNone);
  bag[13] = static_cast<char>(bag[13] + static_cast<char>(field.size()));  // the header's length
  ExpectRefused(bag.insert(17, field), "encrypted by \"rosbag/NoEncryptor..\"");
}

TEST_F(BagCheckTest, WhatIsNoBagIsRefused) { ExpectRefused("no bag", "does not begin with"); }

TEST_F(BagCheckTest, ABagThatEndsEarlyIsRefusedWhereverItEnds) {
  const std::string bag = MakeBag(BagCompression::kLz4);
  for (std::size_t size = 0; size < bag.size(); size += 7) {
    const fs::path path = Put(bag.substr(0, size));
    EXPECT_EQ(EpisodeReader::Open({path}).status().code(), StatusCode::kDataLoss) << size;
  }
  EXPECT_EQ(CheckBag(folder_ / "absent.bag").code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace latticeworld
