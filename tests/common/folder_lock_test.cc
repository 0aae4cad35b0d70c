#include "latticeworld/common/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class FolderLockTest : public ::testing::Test {
 protected:
  FolderLockTest() {
    std::string name = (fs::temp_directory_path() / "latticeworld_lock_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FolderLockTest() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(FolderLockTest, OnlyOneHoldsItAtATime) {
  auto first = FolderLock::Take(folder_ / ".lock");
  ASSERT_TRUE(first.ok()) << first.status().ToString();
  const Status second = FolderLock::Take(folder_ / ".lock").status();
  EXPECT_EQ(second.code(), StatusCode::kFailedPrecondition);
  EXPECT_NE(second.ToString().find(folder_.string()), std::string::npos) << second.ToString();
  EXPECT_TRUE(FolderLock::Take(folder_ / ".other").ok());
  { const FolderLock gone = *std::move(first); }
  EXPECT_TRUE(FolderLock::Take(folder_ / ".lock").ok());
}

TEST_F(FolderLockTest, AProcessThatDiesLetsItGo) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto lock = FolderLock::Take(folder_ / ".lock");
    ::_exit(lock.ok() ? 0 : 1);  // without any destructor
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  EXPECT_TRUE(FolderLock::Take(folder_ / ".lock").ok());
}

// Where the file system has no locks, whoever holds the folder is named (the test runs with such a
// file system, too); elsewhere nothing is left beside the lock.
TEST_F(FolderLockTest, NothingIsLeftButTheLockFile) {
  { ASSERT_TRUE(FolderLock::Take(folder_ / ".lock").ok()); }
  EXPECT_FALSE(fs::exists(folder_ / ".lock.owner"));
  EXPECT_TRUE(fs::exists(folder_ / ".lock"));
}

TEST_F(FolderLockTest, WhereNoFileCanBeMadeIsSaid) {
  const Status status = FolderLock::Take(folder_ / "nowhere/.lock").status();
  EXPECT_EQ(status.code(), StatusCode::kPermissionDenied);
  EXPECT_NE(status.ToString().find("nowhere"), std::string::npos) << status.ToString();
}

}  // namespace
}  // namespace latticeworld
