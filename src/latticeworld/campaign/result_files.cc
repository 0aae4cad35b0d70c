#include "latticeworld/campaign/result_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "latticeworld/common/files.h"

namespace latticeworld {

namespace fs = std::filesystem;

Status WriteWhole(const fs::path& path, std::string_view content) {
  fs::path temporary = path;
  temporary += "." + std::to_string(::getpid()) + ".part";
  Status status = WriteFile(temporary, content);
  std::error_code error;
  if (status.ok()) {
    fs::rename(temporary, path, error);
    if (error) status = Internal("cannot rename to " + path.string() + ": " + error.message());
  }
  if (!status.ok()) fs::remove(temporary, error);
  return status;
}

Result<FolderLock> FolderLock::Take(const fs::path& file) {
  const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd < 0) {
    return PermissionDenied("cannot open " + file.string() + ": " + std::strerror(errno));
  }
  if (::flock(fd, LOCK_EX | LOCK_NB) == 0) return FolderLock(fd);
  const int error = errno;
  ::close(fd);
  if (error == EWOULDBLOCK) {
    return FailedPrecondition("another process works on this campaign in " +
                              file.parent_path().string());
  }
  return Internal("cannot lock " + file.string() + ": " + std::strerror(error));
}

FolderLock::FolderLock(FolderLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace latticeworld
