#ifndef LATTICEWORLD_CAMPAIGN_RESULT_FILES_H_
#define LATTICEWORLD_CAMPAIGN_RESULT_FILES_H_

#include <filesystem>
#include <string_view>

#include "latticeworld/common/result.h"

namespace latticeworld {

// Writes a file whole or not at all: beside it under a name of this process, synced, then renamed.
// What was there before is replaced. Errors: those of WriteFile, which name a full disk.
Status WriteWhole(const std::filesystem::path& path, std::string_view content);

// Holds a folder's lock file while it lives, so that no two processes work on the same shard of a
// campaign. A process that dies lets it go.
class FolderLock {
 public:
  // Errors: FAILED_PRECONDITION (another process holds it), PERMISSION_DENIED, INTERNAL.
  static Result<FolderLock> Take(const std::filesystem::path& file);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int fd) : fd_(fd) {}
  int fd_;  // -1 once moved from
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_RESULT_FILES_H_
