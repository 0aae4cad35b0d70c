#include "latticeworld/campaign/workers/campaign_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "generation/test_world.h"
#include "latticeworld/common/files.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

CampaignFolder FolderAt(const fs::path& out) {
  CampaignFolder folder;
  folder.text = "name: test\n";
  folder.out = out;
  return folder;
}

// Lets that many processes prepare the folder at the same moment; how many of them failed.
int FailuresOfAtOnce(int processes, const CampaignFolder& folder) {
  int gate[2];
  EXPECT_EQ(::pipe(gate), 0);
  std::vector<pid_t> children;
  for (int i = 0; i < processes; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(gate[1]);
      char none;
      (void)!::read(gate[0], &none, 1);  // ends when the parent opens the gate
      ::_exit(PrepareFolder(folder, /*resume=*/true).ok() ? 0 : 1);
    }
    children.push_back(child);
  }
  ::close(gate[0]);
  ::close(gate[1]);
  int failures = 0;
  for (const pid_t child : children) {
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) ++failures;
  }
  return failures;
}

TEST(CampaignFolderTest, ShardsMayBeginAtTheSameMoment) {
  const TemporaryDirectory temporary;
  for (int round = 0; round < 30; ++round) {
    const CampaignFolder folder = FolderAt(temporary.path() / std::to_string(round));
    ASSERT_EQ(FailuresOfAtOnce(6, folder), 0) << "round " << round;
    for (const char* name : {"worlds", "tasks", "trials"})
      EXPECT_TRUE(fs::is_directory(folder.out / name)) << name;
  }
}

TEST(CampaignFolderTest, WhatIsSomethingElseIsLeftAlone) {
  const TemporaryDirectory temporary;
  const CampaignFolder folder = FolderAt(temporary.path() / "out");
  fs::create_directories(folder.out / "trials");
  EXPECT_EQ(PrepareFolder(folder, true).code(), StatusCode::kFailedPrecondition);
  EXPECT_FALSE(fs::exists(folder.out / "worlds"));

  const CampaignFolder file = FolderAt(temporary.path() / "file");
  ASSERT_TRUE(WriteFile(file.out, "mine").ok());
  EXPECT_EQ(PrepareFolder(file, true).code(), StatusCode::kFailedPrecondition);
}

TEST(CampaignFolderTest, ResultsOfAnotherFileAreRefused) {
  const TemporaryDirectory temporary;
  CampaignFolder folder = FolderAt(temporary.path() / "out");
  ASSERT_TRUE(PrepareFolder(folder, false).ok());
  EXPECT_EQ(PrepareFolder(folder, false).code(), StatusCode::kAlreadyExists);
  EXPECT_TRUE(PrepareFolder(folder, true).ok());
  folder.text += "# another\n";
  EXPECT_EQ(PrepareFolder(folder, true).code(), StatusCode::kFailedPrecondition);
}

}  // namespace
}  // namespace latticeworld
