#include "latticeworld/common/data_files.h"

#include <algorithm>
#include <system_error>

#include "latticeworld/common/text.h"

namespace latticeworld {

namespace fs = std::filesystem;

Result<std::vector<fs::path>> JsonFilesAt(const fs::path& path, std::size_t most) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return std::vector<fs::path>{path};
  const std::string name = Quote(path.string(), 300);
  std::vector<fs::path> files;
  fs::directory_iterator entries(path, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    if (entries->path().extension() == ".json") files.push_back(entries->path());
    if (files.size() > most) {
      return InvalidArgument("more than " + std::to_string(most) + " files *.json in " + name);
    }
  }
  if (error) return PermissionDenied("cannot list " + name + ": " + error.message());
  if (files.empty()) return NotFound("no file *.json in " + name);
  std::sort(files.begin(), files.end());
  return files;
}

bool IsSound(const std::string& pointer, const std::vector<Violation>& violations) {
  return std::none_of(violations.begin(), violations.end(), [&](const Violation& violation) {
    return violation.pointer == pointer || StartsWith(violation.pointer, pointer + "/");
  });
}

}  // namespace latticeworld
