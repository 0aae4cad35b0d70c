#include "latticeworld/common/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

Status ErrnoStatus(const std::string& what, int error) {
  const std::string message = what + ": " + std::strerror(error);
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return NotFound(message);
    case EACCES:
    case EPERM:
    case EROFS:
      return PermissionDenied(message);
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return ResourceExhausted(message);
    case EEXIST:
    case ENOTEMPTY:
      return Status(StatusCode::kAlreadyExists, message);
    default:
      return Internal(message);
  }
}

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  ~FileDescriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

// Whether an error says that the file system has no such call: NFS, 9p, sshfs and ZFS before 2.2
// know no flags of renameat2, and some of them no fsync of a directory.
bool IsUnsupported(int error) { return error == EINVAL || error == ENOSYS || error == EOPNOTSUPP; }

Status SyncDirectory(const fs::path& directory) {
  const FileDescriptor fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const bool synced = fd.get() >= 0 && (::fsync(fd.get()) == 0 || IsUnsupported(errno));
  if (!synced) return ErrnoStatus("cannot sync directory " + directory.string(), errno);
  return Status();
}

// Gives a directory another name, which nothing has yet; what appeared there meanwhile is never
// replaced, not even an empty directory. 0, or the error number.
int RenameToNew(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (!IsUnsupported(errno)) return errno;
  // The name is claimed by an empty directory of our own, which rename then replaces.
  if (::mkdir(to.c_str(), 0755) != 0) return errno;
  if (::rename(from.c_str(), to.c_str()) == 0) return 0;
  const int error = errno;
  ::rmdir(to.c_str());
  return error;
}

// What the name of a temporary directory has between the target's and six characters of its own.
constexpr char kUnfinished[] = ".unfinished-";

bool IsUnfinished(const std::string& name) {
  const std::size_t mark = name.rfind(kUnfinished);
  return StartsWith(name, ".") && mark != std::string::npos &&
         name.size() == mark + std::strlen(kUnfinished) + 6;
}

// Locks a directory; its descriptor, -1 where it cannot be locked at all, nothing where another
// process has it or removes it.
std::optional<int> LockDirectory(const fs::path& directory) {
  const int fd = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (fd < 0) return errno == ENOENT ? std::nullopt : std::optional<int>(-1);
  struct stat info;
  const bool locked = ::flock(fd, LOCK_EX | LOCK_NB) == 0;
  if (locked && ::fstat(fd, &info) == 0 && info.st_nlink > 0) return fd;
  const bool taken = locked || errno == EWOULDBLOCK;
  ::close(fd);
  return taken ? std::nullopt : std::optional<int>(-1);
}

bool IsBelow(const fs::path& path, const fs::path& directory) {
  auto part = path.begin();
  for (const fs::path& expected : directory) {
    if (expected.empty()) continue;  // a trailing slash
    if (part == path.end() || *part != expected) return false;
    ++part;
  }
  return true;
}

// Whole content of an open file.
Result<std::string> ReadOpened(const FileDescriptor& fd, const fs::path& path,
                               std::size_t max_bytes) {
  struct stat info;
  if (::fstat(fd.get(), &info) != 0) return ErrnoStatus("cannot stat " + path.string(), errno);
  if (!S_ISREG(info.st_mode)) return InvalidArgument(path.string() + " is not a regular file");
  if (static_cast<std::uint64_t>(info.st_size) > max_bytes) {
    return ResourceExhausted(path.string() + " is " + std::to_string(info.st_size) +
                             " bytes long; at most " + std::to_string(max_bytes) + " are read");
  }
  std::string content(static_cast<std::size_t>(info.st_size), '\0');
  std::size_t size = 0;
  while (size < content.size()) {
    const ssize_t count = ::read(fd.get(), content.data() + size, content.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return ErrnoStatus("cannot read " + path.string(), errno);
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  content.resize(size);
  return content;
}

}  // namespace

Result<std::string> ReadFile(const fs::path& path, std::size_t max_bytes) {
  // O_NONBLOCK: opening a pipe that nobody writes to must not hang.
  const FileDescriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd.get() < 0) return ErrnoStatus("cannot open " + path.string(), errno);
  return ReadOpened(fd, path, max_bytes);
}

Result<std::string> ReadFileBelow(const fs::path& path, const std::vector<fs::path>& allowed,
                                  std::size_t max_bytes) {
  LW_ASSIGN_OR_RETURN(const fs::path resolved, ResolveBelow(path, allowed));
  const FileDescriptor fd(::open(resolved.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW));
  if (fd.get() < 0) return ErrnoStatus("cannot open " + path.string(), errno);
  std::error_code error;
  const fs::path opened = fs::read_symlink("/proc/self/fd/" + std::to_string(fd.get()), error);
  if (error || opened != resolved) {
    return PermissionDenied(Quote(path.string()) + " changes while it is opened");
  }
  return ReadOpened(fd, path, max_bytes);
}

Status WriteFile(const fs::path& path, std::string_view content) {
  const FileDescriptor fd(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (fd.get() < 0) return ErrnoStatus("cannot create " + path.string(), errno);
  std::size_t size = 0;
  while (size < content.size()) {
    const ssize_t count = ::write(fd.get(), content.data() + size, content.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return ErrnoStatus("cannot write " + path.string(), errno);
    size += static_cast<std::size_t>(count);
  }
  if (::fsync(fd.get()) != 0) return ErrnoStatus("cannot sync " + path.string(), errno);
  return Status();
}

Status RenameFile(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) {
    return ErrnoStatus("cannot rename to " + to.string(), errno);
  }
  return SyncDirectory(to.has_parent_path() ? to.parent_path() : fs::path("."));
}

void RemoveUnfinished(const fs::path& directory) {
  std::vector<fs::path> unfinished;
  std::error_code error;
  fs::directory_iterator entries(directory, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    if (IsUnfinished(entries->path().filename().string())) unfinished.push_back(entries->path());
  }
  for (const fs::path& path : unfinished) {
    const FileDescriptor lock(LockDirectory(path).value_or(-1));
    if (lock.get() >= 0) fs::remove_all(path, error);
  }
}

Result<DirectoryWriter> DirectoryWriter::Create(const fs::path& target) {
  constexpr int kTries = 3;  // RemoveUnfinished may come before the lock is there
  std::error_code error;
  if (fs::exists(fs::symlink_status(target, error))) {
    return Status(StatusCode::kAlreadyExists, target.string() + " already exists");
  }
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  RemoveUnfinished(parent);
  for (int i = 0; i < kTries; ++i) {
    std::string temporary =
        (parent / ("." + target.filename().string() + kUnfinished + "XXXXXX")).string();
    if (::mkdtemp(temporary.data()) == nullptr) {
      return ErrnoStatus("cannot create a directory in " + parent.string(), errno);
    }
    const std::optional<int> lock = LockDirectory(temporary);
    if (!lock) continue;
    ::chmod(temporary.c_str(), 0755);
    return DirectoryWriter(target, temporary, *lock);
  }
  return Unavailable("other processes remove what is written in " + parent.string());
}

DirectoryWriter::DirectoryWriter(fs::path target, fs::path temporary, int lock)
    : target_(std::move(target)), temporary_(std::move(temporary)), lock_(lock) {}

DirectoryWriter::DirectoryWriter(DirectoryWriter&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      lock_(std::exchange(other.lock_, -1)) {
  other.temporary_.clear();
}

DirectoryWriter::~DirectoryWriter() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

Status DirectoryWriter::Write(const fs::path& relative, std::string_view content) {
  const fs::path path = temporary_ / relative;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) return ErrnoStatus("cannot create " + path.parent_path().string(), error.value());
  return WriteFile(path, content);
}

Status DirectoryWriter::Commit() {
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(temporary_, error)) {
    if (entry.is_directory()) LW_RETURN_IF_ERROR(SyncDirectory(entry.path()));
  }
  LW_RETURN_IF_ERROR(SyncDirectory(temporary_));
  if (const int failure = RenameToNew(temporary_, target_); failure != 0) {
    return ErrnoStatus("cannot rename into " + target_.string(), failure);
  }
  temporary_.clear();
  return SyncDirectory(target_.has_parent_path() ? target_.parent_path() : fs::path("."));
}

Result<fs::path> ResolveBelow(const fs::path& path, const std::vector<fs::path>& allowed) {
  std::vector<std::string> names;
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  for (const fs::path& directory : allowed) {
    names.push_back(directory.string());
    if (error) continue;
    std::error_code directory_error;
    const fs::path base = fs::canonical(directory, directory_error);
    if (directory_error || !IsBelow(resolved, base)) continue;
    if (!fs::exists(resolved, directory_error)) return NotFound(path.string() + " does not exist");
    return resolved;
  }
  return PermissionDenied(Quote(path.string()) + " is outside the allowed directories (" +
                          (names.empty() ? "none is configured" : Join(names, ", ")) + ")");
}

}  // namespace latticeworld
