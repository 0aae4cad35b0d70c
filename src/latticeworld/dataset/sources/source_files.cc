#include "latticeworld/dataset/sources/source_files.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostBytes = std::size_t{512} << 20;

Status FolderError(const fs::path& folder, const std::error_code& error) {
  const std::string message = folder.string() + ": " + error.message();
  return error == std::errc::permission_denied ? PermissionDenied(message) : NotFound(message);
}

}  // namespace

Result<std::string> ReadSourceFile(const fs::path& path) {
  Result<std::string> bytes = ReadFile(path, kMostBytes);
  if (!bytes.ok() && bytes.status().message().find(path.string()) == std::string::npos) {
    return bytes.status().WithContext(path.string());
  }
  return bytes;
}

Result<std::vector<std::string>> NamesIn(const fs::path& folder, std::string_view extension) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return NotFound("there is no folder " + folder.string());
  if (!fs::is_directory(status)) return InvalidArgument(folder.string() + " is not a folder");
  std::vector<std::string> names;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;  // what vanishes in the meantime is no folder
    const bool wanted =
        extension.empty() ? entry->is_directory(ignored) : EndsWith(name, extension);
    if (wanted && name[0] != '.') names.push_back(name);
  }
  if (error) return FolderError(folder, error);
  std::sort(names.begin(), names.end());
  return names;
}

std::string SafeName(std::string_view name) {
  std::string safe(name);
  for (char& c : safe) {
    const bool legal = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '_' || c == '-';
    if (!legal) c = '_';
  }
  return safe;
}

void MakeUnique(std::vector<std::string>* names) {
  std::set<std::string> taken(names->begin(), names->end());
  std::set<std::string> seen;
  for (std::string& name : *names) {
    if (seen.insert(name).second) continue;
    std::string candidate;
    for (int i = 2; candidate.empty() || !taken.insert(candidate).second; ++i) {
      candidate = name + "_" + std::to_string(i);
    }
    name = candidate;
    seen.insert(name);
  }
}

}  // namespace latticeworld
