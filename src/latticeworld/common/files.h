#ifndef LATTICEWORLD_COMMON_FILES_H_
#define LATTICEWORLD_COMMON_FILES_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// Whole content of a regular file of at most max_bytes. Errors: NOT_FOUND, PERMISSION_DENIED,
// RESOURCE_EXHAUSTED (larger than max_bytes), INVALID_ARGUMENT (not a regular file).
Result<std::string> ReadFile(const std::filesystem::path& path, std::size_t max_bytes);

// Writes and fsyncs one file; an existing file is replaced. Errors: PERMISSION_DENIED,
// RESOURCE_EXHAUSTED (disk full), INTERNAL.
Status WriteFile(const std::filesystem::path& path, std::string_view content);

// ReadFile of a file that ResolveBelow lets pass, and that is below an allowed directory still once
// it is open: who renames and links meanwhile leads nowhere else. Errors: of both.
Result<std::string> ReadFileBelow(const std::filesystem::path& path,
                                  const std::vector<std::filesystem::path>& allowed,
                                  std::size_t max_bytes);

// Gives a file that WriteFile or another has synced its name; what had that name is replaced. Once
// it is OK, the file has the name after a loss of power, too. Errors: as of WriteFile.
Status RenameFile(const std::filesystem::path& from, const std::filesystem::path& to);

// Removes the temporary directories that DirectoryWriters which were killed have left in
// `directory`. Those of writers that live stay, and so do all where the file system has no locks.
void RemoveUnfinished(const std::filesystem::path& directory);

// A directory that is written whole or not at all: files go to a temporary sibling of `target`;
// Commit fsyncs and renames it into place. Without Commit the temporary one is removed; by the next
// writer beside it, where the process was killed.
class DirectoryWriter {
 public:
  // Errors: ALREADY_EXISTS when target exists, PERMISSION_DENIED, RESOURCE_EXHAUSTED, NOT_FOUND
  // (no parent directory).
  static Result<DirectoryWriter> Create(const std::filesystem::path& target);
  DirectoryWriter(DirectoryWriter&& other) noexcept;
  DirectoryWriter& operator=(DirectoryWriter&&) = delete;
  ~DirectoryWriter();

  // relative: below the directory, its parent folders are made.
  Status Write(const std::filesystem::path& relative, std::string_view content);
  Status Commit();

 private:
  DirectoryWriter(std::filesystem::path target, std::filesystem::path temporary, int lock);
  std::filesystem::path target_;
  std::filesystem::path temporary_;  // empty once committed or moved from
  int lock_;                         // descriptor of the temporary directory, locked; -1: none
};

// The file that `path` names when it lies below one of the allowed directories once links and ".."
// are resolved; PERMISSION_DENIED naming the allowed ones when it does not, NOT_FOUND when absent.
Result<std::filesystem::path> ResolveBelow(const std::filesystem::path& path,
                                           const std::vector<std::filesystem::path>& allowed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_FILES_H_
