#include "latticeworld/campaign/reports/result_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "common/synced_directories.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

TEST(ResultFilesTest, AWholeFileKeepsItsNameThroughALossOfPower) {
  std::string name = (fs::temp_directory_path() / "latticeworld_results_XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  const std::size_t before = SyncedDirectories().size();
  ASSERT_TRUE(WriteWhole(folder / "file", "content").ok());
  ASSERT_GT(SyncedDirectories().size(), before);
  EXPECT_EQ(SyncedDirectories().back(), fs::canonical(folder));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace latticeworld
