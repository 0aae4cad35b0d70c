#include "latticeworld/dataset/writing/whole_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "common/synced_directories.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

TEST(WholeFileTest, AWholeFileKeepsItsNameThroughALossOfPower) {
  std::string name = (fs::temp_directory_path() / "latticeworld_whole_file_XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  const std::size_t before = SyncedDirectories().size();
  ASSERT_TRUE(WriteWholeFile(folder / "file", "content").ok());
  ASSERT_GT(SyncedDirectories().size(), before);
  EXPECT_EQ(SyncedDirectories().back(), fs::canonical(folder));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace latticeworld
