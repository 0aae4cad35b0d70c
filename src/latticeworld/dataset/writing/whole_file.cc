#include "latticeworld/dataset/writing/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "latticeworld/common/files.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

Status FailureOf(const std::string& what, const fs::path& path, int error) {
  const std::string message =
      what + " " + path.string() + ": " + std::generic_category().message(error);
  if (error == ENOSPC || error == EDQUOT || error == EFBIG) return ResourceExhausted(message);
  if (error == EACCES || error == EPERM || error == EROFS) return PermissionDenied(message);
  if (error == ENOENT || error == ENOTDIR) return NotFound(message);
  return Internal(message);
}

}  // namespace

Result<WholeFile> WholeFile::Create(const fs::path& path) {
  fs::path temporary = path;
  temporary += kUnfinished;
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd < 0) return FailureOf("cannot create", temporary, errno);
  return WholeFile(path, fd);
}

WholeFile::WholeFile(fs::path path, int fd)
    : path_(std::move(path)), fd_(fd), digest_(std::make_unique<Digest>()) {}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      size_(other.size_),
      digest_(std::move(other.digest_)) {}

WholeFile::~WholeFile() {
  if (fd_ < 0) return;
  ::close(fd_);
  ::unlink(Temporary().c_str());
}

fs::path WholeFile::Temporary() const {
  fs::path temporary = path_;
  temporary += kUnfinished;
  return temporary;
}

Status WholeFile::Append(std::string_view bytes) {
  digest_->AddBytes(bytes.data(), bytes.size());
  size_ += bytes.size();
  while (!bytes.empty()) {
    const ssize_t count = ::write(fd_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return FailureOf("cannot write", path_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return Status();
}

Status WholeFile::Commit() {
  if (::fsync(fd_) != 0) return FailureOf("cannot sync", path_, errno);
  LW_RETURN_IF_ERROR(RenameFile(Temporary(), path_));
  ::close(std::exchange(fd_, -1));
  return Status();
}

Status WriteWholeFile(const fs::path& path, std::string_view content) {
  LW_ASSIGN_OR_RETURN(WholeFile file, WholeFile::Create(path));
  LW_RETURN_IF_ERROR(file.Append(content));
  return file.Commit();
}

Status MakeDirectories(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  return error ? FailureOf("cannot make the folder", path, error.value()) : Status();
}

}  // namespace latticeworld
