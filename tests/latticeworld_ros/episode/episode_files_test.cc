#include "latticeworld_ros/episode/episode_files.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

TEST(EpisodeFilesTest, PartsAreUnitedAndTheirOrderIsThatOfTheirNumbers) {
  std::string name = (fs::temp_directory_path() / "episode-files-XXXXXX").string();
  const fs::path folder = mkdtemp(name.data());
  for (const char* file : {"long.part0.bag", "long.part10.bag", "long.part2.bag", "plain.bag",
                           "scout_12.bag", "cut.bag.active", "notes.txt", ".bag", "v.1.bag"}) {
    std::ofstream(folder / file) << "12345";
  }
  fs::create_directory(folder / "folder.bag");
  const auto episodes = EpisodesIn(folder);
  ASSERT_EQ(episodes.size(), 5u);
  EXPECT_EQ(episodes[0].name, "cut");
  EXPECT_FALSE(episodes[0].complete);
  EXPECT_EQ(episodes[1].name, "long");
  EXPECT_TRUE(episodes[1].complete);
  EXPECT_EQ(episodes[1].bytes, 15u);
  ASSERT_EQ(episodes[1].paths.size(), 3u);
  EXPECT_EQ(episodes[1].paths[2], (folder / "long.part10.bag").string());
  EXPECT_EQ(episodes[2].name, "plain");
  EXPECT_EQ(episodes[3].name, "scout_12");
  EXPECT_EQ(episodes[4].name, "v.1");
  EXPECT_EQ(FilesOfEpisode(folder, "plain").size(), 1u);
  EXPECT_TRUE(FilesOfEpisode(folder, "absent").empty());
  fs::remove_all(folder);
  EXPECT_TRUE(EpisodesIn(folder).empty());
}

}  // namespace
}  // namespace latticeworld
