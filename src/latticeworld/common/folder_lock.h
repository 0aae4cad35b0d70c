#ifndef LATTICEWORLD_COMMON_FOLDER_LOCK_H_
#define LATTICEWORLD_COMMON_FOLDER_LOCK_H_

#include <filesystem>
#include <string>

#include "latticeworld/common/result.h"

namespace latticeworld {

// Held by the one process that works on a folder; a process that dies lets it go. Where the file
// system knows no locks (Lustre without the mount option flock, NFS without a lock service), a file
// beside it, "NAME.owner", names host and process that hold it: one that died on the same host lets
// it go too, for another host's the file has to be deleted.
class FolderLock {
 public:
  // file: the lock, in the folder; made where it is not there, and left there. Errors:
  // FAILED_PRECONDITION (another process holds it, which is named where that is known),
  // PERMISSION_DENIED (no file can be made).
  static Result<FolderLock> Take(const std::filesystem::path& file);
  // Whether a file of that name in the folder is the lock called `lock`, or of those beside it.
  static bool Owns(const std::string& lock, const std::string& name);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int fd) : fd_(fd) {}
  int fd_;                       // -1 once moved from
  std::filesystem::path owner_;  // the file that names us; empty: the file system has locks
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_FOLDER_LOCK_H_
