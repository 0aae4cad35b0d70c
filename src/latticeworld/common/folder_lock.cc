#include "latticeworld/common/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace latticeworld {

Result<FolderLock> FolderLock::Take(const std::filesystem::path& file) {
  const auto reason = [](int error) { return std::generic_category().message(error); };
  const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd < 0) return PermissionDenied("cannot open " + file.string() + ": " + reason(errno));
  FolderLock lock(fd);
  if (::flock(fd, LOCK_EX | LOCK_NB) == 0) return lock;
  if (errno == EWOULDBLOCK) {
    return FailedPrecondition("another process works on " + file.parent_path().string() +
                              " (it holds " + file.filename().string() + ")");
  }
  return Internal("cannot lock " + file.string() + ": " + reason(errno));
}

FolderLock::FolderLock(FolderLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace latticeworld
