#include "latticeworld_ros/episode/disk_reserve.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace latticeworld {
namespace {

// Asked for at once, so that not every message costs a call.
constexpr std::uint64_t kStep = 4u << 20;

std::string MiB(std::uint64_t bytes) {
  return std::to_string((bytes + (1u << 20) - 1) >> 20) + " MiB";
}

Status Full(std::uint64_t bytes, const std::string& why) {
  return ResourceExhausted("there is no room for a file of " + MiB(bytes) + ": " + why);
}

}  // namespace

Status DiskReserve::Open(const std::filesystem::path& file) {
  Close();
  ensured_bytes_ = 0;
  file_ = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (file_ >= 0) return Status();
  const std::string message = "cannot open " + file.string() + ": " + std::strerror(errno);
  if (errno == ENOENT) return NotFound(message);
  if (errno == EACCES || errno == EROFS) return PermissionDenied(message);
  return Internal(message);
}

Status DiskReserve::Ensure(std::uint64_t bytes) {
  if (bytes <= ensured_bytes_) return Status();
  const std::uint64_t wanted = (bytes / kStep + 1) * kStep;
  rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
      wanted > limit.rlim_cur) {
    return Full(wanted, "files may have " + MiB(limit.rlim_cur) + " at most");
  }
  int result = 0;
  do {
    result = ::fallocate(file_, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(wanted));
  } while (result != 0 && errno == EINTR);
  if (result != 0 && errno != EOPNOTSUPP && errno != ENOSYS) {
    return Full(wanted, std::strerror(errno));
  }
  if (result != 0) {
    struct statvfs disk {};
    struct stat file {};
    if (::fstatvfs(file_, &disk) == 0 && ::fstat(file_, &file) == 0) {
      const std::uint64_t free = static_cast<std::uint64_t>(disk.f_bavail) * disk.f_frsize;
      if (wanted > static_cast<std::uint64_t>(file.st_size) + free) {
        return Full(wanted, std::strerror(ENOSPC));
      }
    }
  }
  ensured_bytes_ = wanted;
  return Status();
}

Status DiskReserve::Release() {
  struct stat file {};
  if (::fstat(file_, &file) == 0 && ::ftruncate(file_, file.st_size) == 0 && ::fsync(file_) == 0) {
    return Status();
  }
  return Internal(std::string("the file may be lost when the power is: ") + std::strerror(errno));
}

void DiskReserve::Close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

}  // namespace latticeworld
