#include <algorithm>

#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/bundle_files.h"

namespace latticeworld {

namespace fs = std::filesystem;

Result<std::vector<BundleSummary>> ListBundles(const fs::path& directory) {
  std::error_code error;
  fs::directory_iterator entry(directory, error);
  if (error) {
    const std::string message = "cannot list " + directory.string() + ": " + error.message();
    return error == std::errc::permission_denied ? PermissionDenied(message) : NotFound(message);
  }
  std::vector<BundleSummary> bundles;
  for (; entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name[0] == '.') continue;  // one that is being written
    const Result<Manifest> manifest = ReadManifest(entry->path());
    if (!manifest.ok()) continue;
    bundles.push_back({name, manifest->world_id, manifest->request.layout_instruction});
  }
  if (error) return Internal("cannot list " + directory.string() + ": " + error.message());
  std::sort(bundles.begin(), bundles.end(),
            [](const BundleSummary& a, const BundleSummary& b) { return a.name < b.name; });
  return bundles;
}

}  // namespace latticeworld
