// Catalogue::Load: the files of a user.

#include <algorithm>
#include <system_error>
#include <utility>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/catalogue/limits.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

// The *.json of a directory by name, or the file itself.
Result<std::vector<fs::path>> FilesAt(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return std::vector<fs::path>{path};
  std::vector<fs::path> files;
  fs::directory_iterator entries(path, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    if (entries->path().extension() != ".json") continue;
    files.push_back(entries->path());
    if (files.size() > kMaxCatalogueFiles) {
      return ResourceExhausted("more than " + std::to_string(kMaxCatalogueFiles) +
                               " files *.json in " + Quote(path.string(), 300));
    }
  }
  if (error) {
    return PermissionDenied("cannot list " + Quote(path.string(), 300) + ": " + error.message());
  }
  if (files.empty()) return NotFound("no file *.json in " + Quote(path.string(), 300));
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Result<std::shared_ptr<const Catalogue>> Catalogue::Load(const std::vector<fs::path>& paths) {
  std::vector<CatalogueFile> files;
  std::size_t bytes = 0;
  for (const fs::path& path : paths) {
    LW_ASSIGN_OR_RETURN(const std::vector<fs::path> found, FilesAt(path));
    for (const fs::path& file : found) {
      LW_ASSIGN_OR_RETURN(std::string text, ReadFile(file, kMaxCatalogueFileBytes));
      bytes += text.size();
      if (bytes > kMaxCatalogueBytes) {
        return ResourceExhausted("catalogue files of more than " +
                                 std::to_string(kMaxCatalogueBytes) + " bytes in all");
      }
      files.push_back({file.filename().string(), std::move(text)});
    }
  }
  return Extended(std::move(files));
}

}  // namespace latticeworld
