#ifndef LATTICEWORLD_COMMON_FOLDER_LOCK_H_
#define LATTICEWORLD_COMMON_FOLDER_LOCK_H_

#include <filesystem>

#include "latticeworld/common/result.h"

namespace latticeworld {

// Held by the one process that works on a folder; a process that dies lets it go.
class FolderLock {
 public:
  // file: the lock, in the folder; made where it is not there, and left there. Errors:
  // FAILED_PRECONDITION (another process holds it), PERMISSION_DENIED (no file can be made).
  static Result<FolderLock> Take(const std::filesystem::path& file);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int fd) : fd_(fd) {}
  int fd_;  // -1 once moved from
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_FOLDER_LOCK_H_
