#include "latticeworld/dataset/writing/dataset_folder.h"

#include <cstdio>
#include <system_error>
#include <utility>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/writing/dataset_part.h"
#include "latticeworld/dataset/writing/whole_file.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFingerprintBytes = 1 << 20;
constexpr char kLockName[] = ".lock";
constexpr char kOptionsName[] = "options.json";

std::string NameOfPart(std::size_t part) {
  char name[24];
  std::snprintf(name, sizeof(name), "%06zu", part);
  return name;
}

// Whether nothing is there but what is left of a process that ended before it had begun.
Result<bool> IsUnused(const fs::path& root) {
  std::error_code error;
  for (fs::directory_iterator it(root, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (!FolderLock::Owns(kLockName, name) &&
        name != std::string(kOptionsName) + std::string(kUnfinished))
      return false;
  }
  if (error) return PermissionDenied("cannot list " + root.string() + ": " + error.message());
  return true;
}

Status Remove(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  return error ? PermissionDenied("cannot remove " + path.string() + ": " + error.message())
               : Status();
}

}  // namespace

DatasetFolder::DatasetFolder(fs::path root, FolderLock lock)
    : root_(std::move(root)), lock_(std::move(lock)) {}

Result<DatasetFolder> DatasetFolder::Open(const fs::path& root, const std::string& fingerprint,
                                          bool resume) {
  std::error_code error;
  const fs::path options = root / kOptionsName;
  const bool there = fs::exists(root, error);
  const bool begun = there && fs::exists(options, error);
  if (there && !begun) {
    bool unused = fs::is_directory(root, error);
    if (unused) {
      LW_ASSIGN_OR_RETURN(unused, IsUnused(root));
    }
    if (!unused)
      return FailedPrecondition(root.string() + " is there and is no data set; give a new folder");
  }
  if (begun) {
    LW_ASSIGN_OR_RETURN(const std::string kept, ReadFile(options, kMostFingerprintBytes));
    if (kept != fingerprint) {
      return FailedPrecondition(root.string() +
                                " was begun with other options, another source or "
                                "another version: " +
                                options.string() + " differs; give a new folder");
    }
    if (!resume)
      return Status(StatusCode::kAlreadyExists,
                    root.string() + " has this data set or a part of it; --resume goes on with it");
  }
  LW_RETURN_IF_ERROR(MakeDirectories(root));
  LW_ASSIGN_OR_RETURN(FolderLock lock, FolderLock::Take(root / kLockName));
  if (!begun) LW_RETURN_IF_ERROR(WriteWholeFile(options, fingerprint));
  DatasetFolder folder(root, std::move(lock));
  if (!folder.IsWhole()) {
    LW_RETURN_IF_ERROR(MakeDirectories(root / "parts"));
    LW_RETURN_IF_ERROR(MakeDirectories(root / "images"));
  }
  return folder;
}

bool DatasetFolder::IsWhole() const {
  std::error_code error;
  return fs::exists(Manifest(), error);
}

fs::path DatasetFolder::PartFile(std::size_t part) const {
  return root_ / "parts" / NameOfPart(part);
}
std::string DatasetFolder::ImageNameOf(std::size_t part) const {
  return "images/" + NameOfPart(part);
}
fs::path DatasetFolder::ImagesOf(std::size_t part) const { return root_ / ImageNameOf(part); }

bool DatasetFolder::HasPart(std::size_t part) const { return ReadPart(PartFile(part)).ok(); }

Status DatasetFolder::RemoveLeftovers() const {
  std::vector<fs::path> leftovers;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(root_ / "parts", error)) {
    if (EndsWith(entry.path().filename().string(), kUnfinished)) leftovers.push_back(entry.path());
  }
  // DirectoryWriter's temporary names begin with a dot.
  for (const fs::directory_entry& entry : fs::directory_iterator(root_ / "images", error)) {
    if (StartsWith(entry.path().filename().string(), ".")) leftovers.push_back(entry.path());
  }
  for (const fs::path& leftover : leftovers) LW_RETURN_IF_ERROR(Remove(leftover));
  return Status();
}

Status DatasetFolder::RemoveImages(std::size_t part) const { return Remove(ImagesOf(part)); }

void DatasetFolder::RemoveParts() const {
  std::error_code ignored;
  fs::remove_all(root_ / "parts", ignored);
  fs::remove(root_ / "images", ignored);  // where there are none
  fs::remove(root_ / kLockName, ignored);
}

}  // namespace latticeworld
