#include "latticeworld/common/folder_lock.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr char kOwner[] = ".owner";
constexpr char kDead[] = ".dead";
constexpr std::size_t kMostOwnerBytes = 1024;

// Whether an error of flock says that the file system has no locks: Lustre without the mount option
// flock (ENOSYS), NFS without a lock service (ENOLCK), others (EOPNOTSUPP, EINVAL).
bool HasNoLocks(int error) {
  return error == ENOSYS || error == ENOLCK || error == EOPNOTSUPP || error == EINVAL;
}

std::string Reason(int error) { return std::generic_category().message(error); }

std::string HostName() {
  char name[256] = {};
  ::gethostname(name, sizeof(name) - 1);
  return name;
}

// Whether "HOST PROCESS" names a process of this host that has ended.
bool HasDied(const std::string& owner) {
  const std::size_t blank = owner.find(' ');
  if (blank == std::string::npos || owner.substr(0, blank) != HostName()) return false;
  const long process = std::strtol(owner.c_str() + blank, nullptr, 10);
  return process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

// Takes away the file of an owner that has died. Whoever does it holds "FILE.dead" meanwhile: of
// two that have seen the same dead owner, the slower one would else take away what the other has
// made in its place. Errors: as of Take.
Status RemoveDead(const std::filesystem::path& file, const std::string& owner) {
  const std::string claim = file.string() + kDead;
  const int fd = ::open(claim.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (fd < 0 && errno == EEXIST) {
    return FailedPrecondition("another process is about to work on " + file.parent_path().string() +
                              " (it holds " + file.filename().string() + kDead +
                              "; delete that file if no process works there)");
  }
  if (fd < 0) return PermissionDenied("cannot make " + claim + ": " + Reason(errno));
  ::close(fd);
  const auto now = ReadFile(file, kMostOwnerBytes);
  if (now.ok() && *now == owner) ::unlink(file.c_str());
  ::unlink(claim.c_str());
  return Status();
}

// Makes the file that names this process, which is not to be there yet. Errors: as of Take.
Status NameOwner(const std::filesystem::path& file) {
  constexpr int kTries = 3;  // each after an owner that has died, or has just let it go
  const std::string own = HostName() + " " + std::to_string(::getpid()) + "\n";
  for (int i = 0; i < kTries; ++i) {
    const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (fd >= 0) {
      const bool written = ::write(fd, own.data(), own.size()) == static_cast<ssize_t>(own.size());
      ::close(fd);
      return written ? Status() : PermissionDenied("cannot write " + file.string());
    }
    if (errno != EEXIST) {
      return PermissionDenied("cannot make " + file.string() + ": " + Reason(errno));
    }
    const auto owner = ReadFile(file, kMostOwnerBytes);
    if (owner.status().code() == StatusCode::kNotFound) continue;
    if (!owner.ok() || !HasDied(*owner)) {
      return FailedPrecondition("another process works on " + file.parent_path().string() + " (" +
                                file.filename().string() +
                                " says: " + Quote(owner.ok() ? *owner : owner.status().message()) +
                                "; delete that file if the process has ended)");
    }
    LW_RETURN_IF_ERROR(RemoveDead(file, *owner));
  }
  return FailedPrecondition("other processes want to work on " + file.parent_path().string());
}

}  // namespace

Result<FolderLock> FolderLock::Take(const std::filesystem::path& file) {
  const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd < 0) return PermissionDenied("cannot open " + file.string() + ": " + Reason(errno));
  FolderLock lock(fd);
  if (::flock(fd, LOCK_EX | LOCK_NB) == 0) return lock;
  if (errno == EWOULDBLOCK) {
    return FailedPrecondition("another process works on " + file.parent_path().string() +
                              " (it holds " + file.filename().string() + ")");
  }
  if (!HasNoLocks(errno)) {
    return Internal("cannot lock " + file.string() + ": " + Reason(errno));
  }
  const std::filesystem::path owner = file.string() + kOwner;
  LW_RETURN_IF_ERROR(NameOwner(owner));
  lock.owner_ = owner;
  return lock;
}

bool FolderLock::Owns(const std::string& lock, const std::string& name) {
  return name == lock || name == lock + kOwner || name == lock + kOwner + kDead;
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)), owner_(std::exchange(other.owner_, {})) {}

FolderLock::~FolderLock() {
  if (!owner_.empty()) ::unlink(owner_.c_str());
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace latticeworld
