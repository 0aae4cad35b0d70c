#include "latticeworld/common/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

// A pipe that nothing is written to: who reads it waits until it is closed.
class Gate {
 public:
  Gate() { EXPECT_EQ(::pipe(ends_), 0); }
  ~Gate() {
    Open();
    ::close(ends_[0]);
  }
  void Open() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  // In a child: its own end would keep the pipe open.
  void Wait() {
    Open();
    char byte;
    while (::read(ends_[0], &byte, 1) > 0) {
    }
  }

 private:
  int ends_[2] = {-1, -1};
};

TEST_F(FolderLockTest, OfManyThatSeeADeadOwnerOneTakesItsPlace) {
  constexpr int kRounds = 50;
  constexpr int kProcesses = 4;
  for (int round = 0; round < kRounds; ++round) {
    Gate begin, end;
    int answers[2];
    ASSERT_EQ(::pipe(answers), 0);
    for (int i = 0; i < kProcesses; ++i) {
      const pid_t child = ::fork();
      ASSERT_GE(child, 0);
      if (child == 0) {
        begin.Wait();
        const auto lock = FolderLock::Take(folder_ / ".lock");
        const char answer = lock.ok() ? '1' : '0';
        const bool told = ::write(answers[1], &answer, 1) == 1;
        end.Wait();
        ::_exit(told ? 0 : 1);  // dead, and the owner for all that the file system tells
      }
    }
    begin.Open();
    std::string held(kProcesses, ' ');
    for (char& answer : held) ASSERT_EQ(::read(answers[0], &answer, 1), 1);
    EXPECT_EQ(std::count(held.begin(), held.end(), '1'), 1) << held << " in round " << round;
    end.Open();
    for (int i = 0; i < kProcesses; ++i) ::wait(nullptr);
    ::close(answers[0]);
    ::close(answers[1]);
  }
  EXPECT_FALSE(fs::exists(folder_ / ".lock.owner.dead"));
}

// Where the file system has no locks, whoever holds the folder is named (the test runs with such a
// file system, too); elsewhere nothing is left beside the lock.
TEST_F(FolderLockTest, NothingIsLeftButTheLockFile) {
  { ASSERT_TRUE(FolderLock::Take(folder_ / ".lock").ok()); }
  EXPECT_FALSE(fs::exists(folder_ / ".lock.owner"));
  EXPECT_TRUE(fs::exists(folder_ / ".lock"));
}

TEST_F(FolderLockTest, KnowsItsFilesByTheirNames) {
  const auto lock = FolderLock::Take(folder_ / ".lock");
  ASSERT_TRUE(lock.ok()) << lock.status().ToString();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    EXPECT_TRUE(FolderLock::Owns(".lock", entry.path().filename().string())) << entry.path();
  }
  EXPECT_FALSE(FolderLock::Owns(".lock", ".lockable"));
  EXPECT_FALSE(FolderLock::Owns(".lock", "world.json"));
}

TEST_F(FolderLockTest, WhereNoFileCanBeMadeIsSaid) {
  const Status status = FolderLock::Take(folder_ / "nowhere/.lock").status();
  EXPECT_EQ(status.code(), StatusCode::kPermissionDenied);
  EXPECT_NE(status.ToString().find("nowhere"), std::string::npos) << status.ToString();
}

}  // namespace
}  // namespace latticeworld
