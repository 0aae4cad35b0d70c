#include "latticeworld/common/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "common/synced_directories.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class FilesTest : public testing::Test {
 protected:
  FilesTest() {
    std::string pattern = (fs::temp_directory_path() / "latticeworld_files.XXXXXX").string();
    directory_ = ::mkdtemp(pattern.data());
  }
  ~FilesTest() override { fs::remove_all(directory_); }

  int EntryCount() const {
    return static_cast<int>(
        std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }

  fs::path directory_;
};

TEST_F(FilesTest, ReadsBackWhatWasWritten) {
  const std::string content("a\0b\xff\n", 5);
  ASSERT_TRUE(WriteFile(directory_ / "file", content).ok());
  const Result<std::string> read = ReadFile(directory_ / "file", 5);
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  EXPECT_EQ(*read, content);
}

TEST_F(FilesTest, ReadIsBounded) {
  ASSERT_TRUE(WriteFile(directory_ / "file", "123456").ok());
  const Result<std::string> read = ReadFile(directory_ / "file", 5);
  EXPECT_EQ(read.status().code(), StatusCode::kResourceExhausted);
  EXPECT_NE(read.status().message().find("at most 5"), std::string::npos);
}

TEST_F(FilesTest, WhatIsNoFileIsRefused) {
  EXPECT_EQ(ReadFile(directory_ / "absent", 9).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(ReadFile(directory_, 9).status().code(), StatusCode::kInvalidArgument);
  ASSERT_EQ(::mkfifo((directory_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(ReadFile(directory_ / "pipe", 9).status().code(), StatusCode::kInvalidArgument);
}

TEST_F(FilesTest, DirectoryAppearsOnlyWhenCommitted) {
  Result<DirectoryWriter> writer = DirectoryWriter::Create(directory_ / "bundle");
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer->Write("a/b.txt", "content").ok());
  EXPECT_FALSE(fs::exists(directory_ / "bundle"));
  ASSERT_TRUE(writer->Commit().ok());
  EXPECT_EQ(*ReadFile(directory_ / "bundle/a/b.txt", 100), "content");
  EXPECT_EQ(EntryCount(), 1);
}

TEST_F(FilesTest, UncommittedDirectoryLeavesNothing) {
  {
    Result<DirectoryWriter> writer = DirectoryWriter::Create(directory_ / "bundle");
    ASSERT_TRUE(writer.ok());
    ASSERT_TRUE(writer->Write("b.txt", "content").ok());
  }
  EXPECT_EQ(EntryCount(), 0);
}

TEST_F(FilesTest, WhatAKilledWriterLeftTheNextRemovesAndNothingElse) {
  if (const pid_t child = ::fork(); child == 0) {
    auto writer = DirectoryWriter::Create(directory_ / "killed");
    ::_exit(writer.ok() && writer->Write("a", "half").ok() ? 0 : 1);
  } else {
    int status = 1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
  }
  ASSERT_EQ(EntryCount(), 1);
  fs::create_directory(directory_ / ".notes.backup");
  auto living = DirectoryWriter::Create(directory_ / "living");
  ASSERT_TRUE(living.ok() && living->Write("a", "whole").ok());
  auto next = DirectoryWriter::Create(directory_ / "next");
  ASSERT_TRUE(next.ok() && next->Commit().ok());
  EXPECT_TRUE(living->Commit().ok());
  EXPECT_TRUE(fs::exists(directory_ / "living/a"));
  // Where there are no locks (as in common_network_file_system), nobody knows whether a writer
  // lives.
  const int fd = ::open(directory_.c_str(), O_RDONLY | O_DIRECTORY);
  EXPECT_EQ(EntryCount(), ::flock(fd, LOCK_EX) == 0 ? 3 : 4);
  ::close(fd);
}

TEST_F(FilesTest, ARenamedFileKeepsItsNameThroughALossOfPower) {
  ASSERT_TRUE(WriteFile(directory_ / "new", "content").ok());
  ASSERT_TRUE(WriteFile(directory_ / "file", "before").ok());
  const std::size_t before = SyncedDirectories().size();
  ASSERT_TRUE(RenameFile(directory_ / "new", directory_ / "file").ok());
  EXPECT_EQ(*ReadFile(directory_ / "file", 100), "content");
  const std::vector<fs::path> synced = SyncedDirectories();
  ASSERT_GT(synced.size(), before);
  EXPECT_EQ(synced.back(), fs::canonical(directory_));
  EXPECT_EQ(RenameFile(directory_ / "absent", directory_ / "file").code(), StatusCode::kNotFound);
}

TEST_F(FilesTest, AnExistingDirectoryIsNeverReplaced) {
  fs::create_directory(directory_ / "bundle");
  EXPECT_EQ(DirectoryWriter::Create(directory_ / "bundle").status().code(),
            StatusCode::kAlreadyExists);
  // Not even when it appears while the other is being written.
  Result<DirectoryWriter> writer = DirectoryWriter::Create(directory_ / "late");
  ASSERT_TRUE(writer.ok());
  fs::create_directory(directory_ / "late");
  EXPECT_EQ(writer->Commit().code(), StatusCode::kAlreadyExists);
}

// Ends the process with 0 when a write beyond its limit is reported as a full disk and leaves
// nothing. A limit on file size stands for the full disk: write fails in the same place.
[[noreturn]] void WriteBeyondLimit(const fs::path& directory) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit;
  limit.rlim_cur = limit.rlim_max = 4;
  ::setrlimit(RLIMIT_FSIZE, &limit);
  StatusCode code = StatusCode::kOk;
  {
    Result<DirectoryWriter> writer = DirectoryWriter::Create(directory / "bundle");
    if (writer.ok()) code = writer->Write("file", "12345678").code();
  }
  const bool whole = code == StatusCode::kResourceExhausted && fs::is_empty(directory);
  std::_Exit(whole ? 0 : 1);
}

TEST_F(FilesTest, AFullDiskIsReportedAndLeavesNothing) {
  EXPECT_EXIT(WriteBeyondLimit(directory_), testing::ExitedWithCode(0), "");
}

TEST_F(FilesTest, ResolveBelowStopsEveryWayOut) {
  fs::create_directories(directory_ / "allowed/inner");
  fs::create_directories(directory_ / "allowed_too");
  ASSERT_TRUE(WriteFile(directory_ / "secret", "s").ok());
  ASSERT_TRUE(WriteFile(directory_ / "allowed/inner/file", "f").ok());
  ASSERT_TRUE(WriteFile(directory_ / "allowed_too/file", "f").ok());
  fs::create_symlink(directory_ / "secret", directory_ / "allowed/link");
  const std::vector<fs::path> allowed = {directory_ / "allowed/"};
  const auto code = [&](const fs::path& path) {
    return ResolveBelow(path, allowed).status().code();
  };
  EXPECT_EQ(code(directory_ / "allowed/inner/file"), StatusCode::kOk);
  EXPECT_EQ(code(directory_ / "allowed/inner/../inner/file"), StatusCode::kOk);
  EXPECT_EQ(code(directory_ / "allowed/absent"), StatusCode::kNotFound);
  EXPECT_EQ(code(directory_ / "allowed/../secret"), StatusCode::kPermissionDenied);
  EXPECT_EQ(code(directory_ / "allowed/link"), StatusCode::kPermissionDenied);
  EXPECT_EQ(code(directory_ / "allowed_too/file"), StatusCode::kPermissionDenied);
  EXPECT_EQ(code("/etc/passwd"), StatusCode::kPermissionDenied);
  EXPECT_EQ(ResolveBelow("/etc/passwd", {}).status().code(), StatusCode::kPermissionDenied);
}

TEST_F(FilesTest, ReadFileBelowStaysBelowWhileADirectoryIsSwapped) {
  fs::create_directories(directory_ / "allowed/inner");
  fs::create_directory(directory_ / "outside");
  ASSERT_TRUE(WriteFile(directory_ / "outside/file", "secret").ok());
  ASSERT_TRUE(WriteFile(directory_ / "allowed/inner/file", "open").ok());
  fs::create_directory_symlink(directory_ / "outside", directory_ / "link");
  const std::vector<fs::path> allowed = {directory_ / "allowed"};
  EXPECT_EQ(*ReadFileBelow(directory_ / "allowed/inner/file", allowed, 9), "open");
  std::atomic<bool> stop{false};
  std::thread swapper([&] {
    while (!stop) {
      ::renameat2(AT_FDCWD, (directory_ / "link").c_str(), AT_FDCWD,
                  (directory_ / "allowed/inner").c_str(), RENAME_EXCHANGE);
    }
  });
  for (int i = 0; i < 3000; ++i) {
    const auto read = ReadFileBelow(directory_ / "allowed/inner/file", allowed, 9);
    if (read.ok()) {
      EXPECT_EQ(*read, "open");
    }
  }
  stop = true;
  swapper.join();
}

}  // namespace
}  // namespace latticeworld
