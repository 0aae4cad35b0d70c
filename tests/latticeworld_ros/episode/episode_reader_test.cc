#include "latticeworld_ros/episode/episode_reader.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "latticeworld_ros/episode/bag_file.h"
#include "latticeworld_ros/episode/bag_message.h"
#include "latticeworld_ros/episode/episode_recording.h"
#include "latticeworld_ros/episode/lz4_frame.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr char kMagic[] = "\x04\x22\x4D\x18";  // of an LZ4 frame; its flags follow

class EpisodeReaderTest : public testing::Test {
 protected:
  EpisodeReaderTest() {
    std::string name = (fs::temp_directory_path() / "episode-reader-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~EpisodeReaderTest() override { fs::remove_all(folder_); }

  // A bag of the beginning of an episode.
  fs::path MakeBag(BagCompression compression) const {
    const fs::path path = folder_ / "a.bag";
    auto file = BagFile::Create(path, compression);
    latticeworld_msgs::EpisodeStart start;
    start.format = kEpisodeFormat;
    start.name = "a";
    EXPECT_TRUE((*file)->Write(ToBag(kEpisodeStartTopic, ros::Time(1.0), start, true)).ok());
    EXPECT_TRUE((*file)->Finish().ok());
    return path;
  }
  // Puts a byte in the place of another one, which stands that far behind the magic number.
  static void Patch(const fs::path& bag, std::size_t offset, char byte) {
    std::ifstream in(bag, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    in.close();
    const std::size_t frame = bytes.find(kMagic);
    ASSERT_NE(frame, std::string::npos);
    bytes[frame + offset] = byte;
    std::ofstream(bag, std::ios::binary) << bytes;
  }

  fs::path folder_;
};

TEST_F(EpisodeReaderTest, ReadsWhatTheRecorderCompresses) {
  const fs::path bag = MakeBag(BagCompression::kLz4);
  EXPECT_FALSE(HasForeignLz4Frame(bag));
  const auto reader = EpisodeReader::Open({bag});
  ASSERT_TRUE(reader.ok()) << reader.status().ToString();
  EXPECT_EQ((*reader)->start().name, "a");
}

// 0x68 are the flags of PyPI's rosbags 0.11.9: with the size of the content, without its checksum.
TEST_F(EpisodeReaderTest, SaysOfAnotherKindOfLz4FrameHowToConvertIt) {
  const fs::path bag = MakeBag(BagCompression::kLz4);
  Patch(bag, 4, '\x68');
  const Status status = EpisodeReader::Open({bag}).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(status.message().find("damaged"), std::string::npos) << status.message();
  EXPECT_NE(status.message().find("rosbags-convert --src " + bag.string()), std::string::npos)
      << status.message();
}

TEST_F(EpisodeReaderTest, AFrameThatIsNoneIsDamaged) {
  const fs::path bag = MakeBag(BagCompression::kLz4);
  Patch(bag, 3, '\x19');
  const Status status = EpisodeReader::Open({bag}).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_NE(status.message().find("damaged"), std::string::npos) << status.message();
}

TEST_F(EpisodeReaderTest, NoForeignFrameIsFoundInWhatIsNoBag) {
  EXPECT_FALSE(HasForeignLz4Frame(MakeBag(BagCompression::kNone)));
  std::ofstream(folder_ / "text") << "no bag\n" << kMagic << "\x68";
  EXPECT_FALSE(HasForeignLz4Frame(folder_ / "text"));
  EXPECT_FALSE(HasForeignLz4Frame(folder_ / "absent"));
}

}  // namespace
}  // namespace latticeworld
